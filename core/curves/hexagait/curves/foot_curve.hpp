// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/curves/knots.hpp>
#include <hexagait/math/quintic.hpp>

namespace hexagait {

/// What a swing is to do ([FG16] II-C, Footstep).
struct FootSwing {
  Vector3 target = Vector3::Zero();  ///< [m]
  SwingProfile profile = SwingProfile::triangle;
  double profile_height = 0.08;  ///< >= 0; of a swing replaced in mid-air: what is left of it [m]
  Vector3 normal = Vector3::UnitZ();  ///< of the ground; needn't be a unit vector
  double touchdown_speed = 0.2;       ///< the foot arrives with this against the normal [m/s]
};

/// max(length of the polygon / average velocity, minimum) [s].
[[nodiscard]] double swing_duration(const Vector3& start, const FootSwing& swing,
                                    double average_velocity, double minimum) noexcept;

/// The motion of a foot over time, in whatever frame its states are given: position, velocity and
/// acceleration are continuous (C2), also from the start state on.
///
/// Swing: a polygon through knots. With u along the chord (from s to t, perpendicular to the
/// normal), n along the normal, both from the start s; b = max(0, t.n), h the profile height:
///
///     straight   s, t
///     triangle   s, (½ t.u, b + h), t
///     square     s, (0, b + h), (t.u, b + h), t
///     trapezoid  s, (0.1 t.u, h), (½ t.u, t.n + h), (0.9 t.u, t.n + h), t
///
/// Minimum-jerk moves go from knot to knot, per axis; the velocities at both ends come on top.
/// Where an axis goes on in its direction at a knot it passes with v = min(c s₋, c s₊), s the mean
/// velocities before and after, c = 1 or, where the axis rests at the other end, 1.875; else it
/// rests there. A segment then is a σ of non-negative size and two cubic ramps of velocity in the
/// same direction: it can neither leave the knots' box nor run backwards. A cubic spline through
/// the knots, C1 or C2, does both: it passes the apex, and on `square` it first goes back. The
/// velocities at the ends are ramped from and to 0 over the first and last segment, or over the
/// shorter time in which that takes no more way than there is, at least 0.9 mm: to arrive with 0.2
/// m/s where there is no way down takes 9 ms and 33 m/s². A start velocity is braked with no more
/// than 15 m/s² where the first segment lasts long enough: a foot replaced in mid-air may leave the
/// box by v²/20 s²/m, and turn back if its target is behind it.
/// Knots come in proportion to the square root of the chord length, so that moves from stop to stop
/// accelerate equally, 5.77 way/time²; deviation: the reference's proportion to the length would
/// lift by 1 cm within 20 ms. Knots within 1 mm of the next are left out.
///
/// Only reserve() allocates. A value; assignment to one with as much room doesn't allocate.
class FootCurve {
 public:
  FootCurve() { reserve(0); }

  /// Room for a trajectory of so many knots; for a swing or a target there always is.
  void reserve(int knots);

  /// @param start     usually at rest or lifting off, else the state of the swing it replaces
  /// @param duration  [s]; at least 1 ms is taken
  void plan_swing(const PointState& start, const FootSwing& swing, double duration) noexcept;

  /// One quintic to `target`; from rest to rest the minimum-jerk motion.
  void plan_target(const PointState& start, const PointState& target, double duration) noexcept;

  /// Through all knots. Velocities that are left out: parabola_rates(), at the last knot 0; so are
  /// all accelerations, at the last knot 0. Reproduces lines and parabolas; local; may overshoot.
  /// What happens to knots at times that don't rise or beyond the room: usable_knots().
  void plan_trajectory(const PointState& start, std::span<const FootKnot> knots) noexcept;

  [[nodiscard]] double duration() const noexcept { return spline_.duration(); }
  /// @param t  since the start, clamped into [0, duration()] [s]
  [[nodiscard]] PointState at(double t) const noexcept { return spline_.at(t); }
  /// The same, faster for who goes along.
  [[nodiscard]] PointState along(double t) noexcept { return spline_.along(t); }

 private:
  QuinticSpline spline_;
};

}  // namespace hexagait

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/curves/knots.hpp>
#include <hexagait/math/quintic.hpp>

namespace hexagait {

/// A swing motion ([FG16] II-C, Footstep).
struct FootSwing {
  Vector3 target = Vector3::Zero();  ///< [m]
  SwingProfile profile = SwingProfile::triangle;
  double profile_height = 0.08;  ///< >= 0; of a swing replaced in mid-air, what remains of it [m]
  Vector3 normal = Vector3::UnitZ();  ///< of the ground; of any length
  double touchdown_speed = 0.2;       ///< speed on arrival, against the normal [m/s]
  double tolerance = 1e-3;            ///< > 0; closer corners count as one [m]
  double braking = 15.0;              ///< > 0; of a start in mid-air, where time allows [m/s²]
};

/// max(length of the polygon / average velocity, minimum) [s].
[[nodiscard]] double swing_duration(const Vector3& start, const FootSwing& swing,
                                    double average_velocity, double minimum) noexcept;

/// The motion of a foot over time, in the frame of the given states: position, velocity and
/// acceleration are continuous (C2), including at the start state.
///
/// A swing is the sum, per axis, of minimum-jerk motions from corner to corner of the polygon
/// (SwingProfile), and of ramps of the velocities at its ends. With s₋, s₊ the mean velocities of
/// the segments before and after a corner: an axis that continues in its direction passes the
/// corner at v = min(c s₋, c s₊), with c = 1.875 if the axis is at rest at the far end of that
/// segment and 1 otherwise; an axis that reverses stops there. So no segment leaves the box of its
/// corners or runs backwards. (A cubic spline through the corners does both: it overshoots the
/// apex, and on `square` it first moves back.)
///
/// The velocities at the ends are ramped from and to 0 over the first and last segment, or over a
/// shorter time if the ramp would otherwise need more than the segment's length, or 0.9 tolerances
/// if that is longer. Worst case: arriving at 0.2 m/s with no descent, tolerance 1 mm, takes 9 ms
/// and 33 m/s². The start velocity is braked at no more than `braking` where the first segment lasts
/// long enough; a foot replaced in mid-air may therefore leave the box by 3/4 v²/braking, and turn
/// back if its target is behind it.
///
/// Segment times are proportional to the square roots of the segment lengths, so that segments from
/// stop to stop accelerate equally, by 5.77 length/time². Deviation: [FG16]'s implementation takes
/// times proportional to the lengths, which would lift the foot by 1 cm within 20 ms. Corners
/// closer to the next than the tolerance are dropped.
///
/// Only reserve() allocates. A value: assignment to a curve of sufficient capacity does not
/// allocate.
class FootCurve {
 public:
  FootCurve() { reserve(0); }

  /// Allocates space for a trajectory of this many knots. Swings and targets always fit.
  void reserve(int knots);

  /// Plans a swing.
  /// @param start     at rest, lifting off, or the present state of the swing that this one
  ///                  replaces
  /// @param duration  [s]; raised to 1 ms if shorter
  void plan_swing(const PointState& start, const FootSwing& swing, double duration) noexcept;

  /// Plans one quintic to `target`; from rest to rest, the minimum-jerk motion.
  /// @param duration  [s]; raised to 1 ms if shorter
  void plan_target(const PointState& start, const PointState& target, double duration) noexcept;

  /// Plans a motion through all usable_knots(). Accelerations, and velocities that are not given,
  /// are parabola_rates(), 0 at the last knot. Reproduces lines and parabolas; each knot affects
  /// only the segments near it; may overshoot.
  void plan_trajectory(const PointState& start, std::span<const FootKnot> knots) noexcept;

  /// Is the motion finite at any time?
  [[nodiscard]] bool in_range() const noexcept { return spline_.in_range(); }
  [[nodiscard]] double duration() const noexcept { return spline_.duration(); }
  /// @param t  since the start [s], clamped into [0, duration()]
  [[nodiscard]] PointState at(double t) const noexcept { return spline_.at(t); }
  /// As at(), faster for times that increase.
  [[nodiscard]] PointState along(double t) noexcept { return spline_.along(t); }

 private:
  QuinticSpline spline_;
};

}  // namespace hexagait

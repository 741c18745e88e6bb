// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <hexagait/curves/knots.hpp>
#include <hexagait/math/quintic.hpp>

namespace hexagait {

/// How the joints of a leg move and what they are to give.
struct JointState {
  LegJoints q = LegJoints::Zero();       ///< [rad]
  LegJoints qd = LegJoints::Zero();      ///< [rad/s]
  LegJoints qdd = LegJoints::Zero();     ///< [rad/s²]
  LegJoints effort = LegJoints::Zero();  ///< [N m]
};

/// max(longest way of a joint / average velocity, minimum) [s].
[[nodiscard]] double joint_duration(const LegJoints& from, const LegJoints& to,
                                    double average_velocity, double minimum) noexcept;

/// Largest speed of each joint in a quintic from rest to rest: 1.875 |Δq| / T [rad/s].
[[nodiscard]] LegJoints peak_joint_velocity(const LegJoints& from, const LegJoints& to,
                                            double duration) noexcept;

/// The motion of a leg's joints over time: quintics between knots; position, velocity and
/// acceleration are continuous (C2), also from the start state on. Efforts go linearly.
///
/// What a knot doesn't give of a joint (NaN) is chosen, with s₋, s₊ the mean velocities before and
/// after the knot:
///
///     q       where the velocity is given: it is integrated, q₋ + ½ (v₋ + v) T; else as before
///     qd      that of the parabola through the neighbours, parabola_rates(), if it is within
///             2 min(|s₋|, |s₊|) and the joint goes on in its direction; else that bound; 0 where
///             it turns or stands on one side; 0 at the last knot
///     qdd     that of the parabola; 0 where qd had to be bounded, and at the last knot
///     effort  as before
///
/// Where bounded on both sides, a segment is monotone: a minimum-jerk move of size D − ½ (v₋ + v₊)
/// T
/// >= −D and cubic ramps of velocity towards D. So it doesn't pass data that rest or turn; the
/// parabola's acceleration may pass monotone data by some percent of a segment. Dense samples of a
/// smooth motion aren't bounded: lines and parabolas come out as they are.
///
/// Only reserve() allocates. A value; assignment to one with as much room doesn't allocate.
class JointCurve {
 public:
  JointCurve() { reserve(1); }
  JointCurve(const JointCurve& other) { *this = other; }
  JointCurve(JointCurve&&) noexcept = default;
  JointCurve& operator=(const JointCurve& other);
  JointCurve& operator=(JointCurve&&) noexcept = default;
  ~JointCurve() = default;

  /// Room for so many knots, at least one.
  void reserve(int knots);

  /// A target is a trajectory of one knot; from rest to rest this is the minimum-jerk motion. Knots
  /// at times that don't rise, or beyond the room, are left out as usable_knots() says.
  void plan(const JointState& start, std::span<const JointKnot> knots) noexcept;

  [[nodiscard]] double duration() const noexcept { return splines_[0].duration(); }
  /// @param t  since the start, clamped into [0, duration()] [s]
  [[nodiscard]] JointState at(double t) const noexcept;

 private:
  std::array<QuinticSpline, kMaxLegJoints / 3> splines_;  // of three joints each
  std::vector<LegJoints> efforts_;                        // at its nodes
};

}  // namespace hexagait

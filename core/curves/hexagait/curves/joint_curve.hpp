// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <hexagait/curves/knots.hpp>
#include <hexagait/math/quintic.hpp>

namespace hexagait {

/// Motion and efforts of the joints of a leg.
struct JointState {
  LegJoints q = LegJoints::Zero();       ///< [rad]
  LegJoints qd = LegJoints::Zero();      ///< [rad/s]
  LegJoints qdd = LegJoints::Zero();     ///< [rad/s²]
  LegJoints effort = LegJoints::Zero();  ///< [N m]
};

/// max(largest |Δq| of a joint / average velocity, minimum) [s].
[[nodiscard]] double joint_duration(const LegJoints& from, const LegJoints& to,
                                    double average_velocity, double minimum) noexcept;

/// Peak speed of each joint in a quintic from rest to rest: 1.875 |Δq| / T [rad/s].
[[nodiscard]] LegJoints peak_joint_velocity(const LegJoints& from, const LegJoints& to,
                                            double duration) noexcept;

/// The motion of a leg's joints over time: quintics between knots; position, velocity and
/// acceleration are continuous (C2), including at the start state. Efforts are interpolated
/// linearly.
///
/// Values that a knot does not give (NaN) are chosen as follows, with s₋, s₊ the mean velocities
/// before and after the knot:
///
///     q       if the velocity is given, its integral q₋ + ½ (v₋ + v) T; otherwise as before
///     qd      parabola_rates() if within 2 min(|s₋|, |s₊|) and in the direction of motion,
///             otherwise that bound; 0 where the joint reverses or rests on one side, and at the
///             last knot
///     qdd     parabola_rates(); 0 where qd had to be bounded, and at the last knot
///     effort  as before
///
/// A segment of length D whose velocities were bounded at both ends is monotone: it is the sum of a
/// minimum-jerk motion of length D − ½ (v₋ + v₊) T ≥ −D and of cubic velocity ramps towards D. So
/// it does not overshoot where the data rest or reverse. The parabola's acceleration may overshoot
/// monotone data by some percent of a segment. Dense samples of a smooth motion are not bounded, so
/// lines and parabolas are reproduced exactly.
///
/// Only reserve() allocates. A value: assignment to a curve of sufficient capacity does not
/// allocate.
class JointCurve {
 public:
  JointCurve() { reserve(1); }
  JointCurve(const JointCurve& other) { *this = other; }
  JointCurve(JointCurve&&) noexcept = default;
  JointCurve& operator=(const JointCurve& other);
  JointCurve& operator=(JointCurve&&) noexcept = default;
  ~JointCurve() = default;

  /// Allocates space for this many knots, at least one.
  void reserve(int knots);

  /// Plans a motion through all usable_knots(). A target is a trajectory of one knot; from rest to
  /// rest it is the minimum-jerk motion.
  void plan(const JointState& start, std::span<const JointKnot> knots) noexcept;

  /// Is the motion finite at any time?
  [[nodiscard]] bool in_range() const noexcept;
  [[nodiscard]] double duration() const noexcept { return splines_[0].duration(); }
  /// @param t  since the start [s], clamped into [0, duration()]
  [[nodiscard]] JointState at(double t) const noexcept;
  /// The efforts of at(t) alone.
  [[nodiscard]] LegJoints effort_at(double t) const noexcept;

 private:
  std::array<QuinticSpline, kMaxLegJoints / 3> splines_;  // three joints each
  std::vector<LegJoints> efforts_;                        // at the nodes
};

}  // namespace hexagait

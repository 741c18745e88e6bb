// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/model/kinematics.hpp>

/// Discrete posture control ([PC04] 5.2): the smooth displacement of the body over its feet, cut into
/// pieces for servos that take a target some twenty times a second.
///
/// In a piece of duration D the body moves with one twist V. The joints of all legs that stand move
/// along straight lines in joint space, and all arrive at the same moment:
///
///     q_i(t) = q_i + t/D (q'_i − q_i),    q'_i = joints with the foot at exp(−V D) p_i  (displacement 1)
///
/// At both ends the feet are where V takes them. Between, foot i leaves this path, and its place on
/// the ground, by at most
///
///     e_i = (Σ_jk ρ_max(j,k) |Δ_j| |Δ_k| + |w| |u_i| D²) / 8                        (displacement 2)
///
/// with Δ = q' − q, u_i the greatest speed of the foot in the body frame, w the turning rate, and ρ_k
/// the length of the leg beyond joint k. Both terms are quadratic in D and in the speed.
/// Derivation: docs/theory.md 5.
namespace hexagait {

/// The piece that is under way. A value.
struct DiscreteDisplacement {
  int ticks = 0;              ///< control periods until its end; 0: none is under way
  LegSet legs;                ///< that take part
  LegSet reachable;           ///< of them, those that can reach their foot's place at the end
  LegArray<LegJoints> q_end;  ///< their joints then [rad]
};

/// Control periods in a piece: at least 1, and as close as can be to its duration.
[[nodiscard]] int displacement_ticks(double period, double dt) noexcept;

/// X_BB' of a body that moves with a constant twist for a time: exp(V t).
[[nodiscard]] Pose displacement(const Twist& V_B, double time) noexcept;

/// Joints of a leg at the end of a piece of (displacement 1).
/// @param p_BF      its foot now [m]
/// @param q, trig   its joints now
/// @param V_B       twist of the body [m/s], [rad/s]
/// @param time      until the end [s]
/// @param roll_arm  from a spherical foot's contact point to its centre, which rolls on [m]
[[nodiscard]] LegSolution joints_after(const LegModel& leg, const Vector3& p_BF, const LegJoints& q,
                                       const LegTrig& trig, const Twist& V_B, double time,
                                       const Vector3& roll_arm) noexcept;

/// Of the speed limits of the leg's joints, the greatest share that a line asks for.
[[nodiscard]] double speed_share(const LegModel& leg, const LegJoints& q, const LegJoints& q_end,
                                 double time) noexcept;

/// (displacement 2): how far a foot leaves its place at most, in a piece [m].
/// @param p_BF  at the beginning [m]
[[nodiscard]] double most_slip(const LegModel& leg, const Vector3& p_BF, const LegJoints& q,
                               const LegJoints& q_end, const Twist& V_B, double time) noexcept;

}  // namespace hexagait

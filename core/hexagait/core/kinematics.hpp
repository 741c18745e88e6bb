// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/core/robot_model.hpp>

namespace hexagait {

// Forward and inverse kinematics of the yaw-pitch-pitch leg; frames and canonical angles k as in
// LegModel. Fit for a control loop: nothing here allocates or throws, and forward kinematics,
// Jacobian, tibia orientation and inverse kinematics share one set of sines and cosines per leg.

/// Sines and cosines of one leg's canonical angles k₁, k₂ and k₂ + k₃.
struct LegTrig {
  double c1 = 1.0, s1 = 0.0;    ///< yaw
  double c2 = 1.0, s2 = 0.0;    ///< pitch of the femur, positive downwards
  double c23 = 1.0, s23 = 0.0;  ///< pitch of the tibia, positive downwards
};

/// @param q  joint values in the robot's own signs and zeros [rad]
[[nodiscard]] LegTrig leg_trig(const LegModel& leg, const LegJoints& q) noexcept;

/// Foot centre p_BF [m]:
///
///     r = coxa + femur c₂ + tibia c₂₃,   h = −femur s₂ − tibia s₂₃,   p_HF = (r c₁, r s₁, h)
[[nodiscard]] Vector3 foot_position(const LegModel& leg, const LegTrig& trig) noexcept;
[[nodiscard]] Vector3 foot_position(const LegModel& leg, const LegJoints& q) noexcept;

/// ∂p_BF/∂q [m/rad], by the robot's own joint values q. Singular where r = 0, and where the knee is
/// straight or folded.
[[nodiscard]] Matrix3 foot_jacobian(const LegModel& leg, const LegTrig& trig) noexcept;

/// R_BT of the tibia frame T: x from the knee to the foot, y along the canonical pitch axis.
[[nodiscard]] Matrix3 tibia_rotation(const LegModel& leg, const LegTrig& trig) noexcept;

/// Rotation of the tibia in the body frame when the joints change by dq, to first order [rad].
/// @param trig  the angles at which the change begins
[[nodiscard]] Vector3 tibia_turn(const LegModel& leg, const LegTrig& trig,
                                 const LegJoints& dq) noexcept;

/// Are all joints within their limits? An excess of up to 1e-9 rad (rounding) is allowed.
[[nodiscard]] bool within_limits(const LegModel& leg, const LegJoints& q) noexcept;

/// What inverse_kinematics() found.
struct LegSolution {
  LegJoints q = LegJoints::Zero();  ///< joint values, never outside their limits [rad]
  LegTrig trig;                     ///< of q
  bool reachable = false;           ///< is the foot where it was asked to be?
};

/// Joint values that put the foot at p_BF with the knee above the line from hip to foot.
///
/// Closed form. With (r, h) the foot in the leg's plane, a = r − coxa, b = −h and d² = a² + b²:
///
///     c₃ = (d² − femur² − tibia²) / (2 femur tibia),   s₃ = +√(1 − c₃²)
///     A = femur + tibia c₃,   B = tibia s₃,   (c₂, s₂) = (A a + B b, A b − B a) / d²
///
/// Yaw turns the leg's plane towards the foot, r > 0; where the limits forbid this but allow the
/// leg to reach back through the yaw axis, r < 0. A foot on the yaw axis leaves yaw open: 0 is
/// taken.
///
/// Out of reach, the leg points as near to the target as is sensible: yaw is limited first, the
/// target is projected into the leg's plane, moved along the line from the hip-pitch axis into
/// [min_reach, max_reach], and then hip and knee are limited.
///
/// @param p_BF  foot centre in the body frame [m]; any finite value
/// @pre 0 < min_reach <= max_reach < femur + tibia, and min_reach > |femur − tibia|
[[nodiscard]] LegSolution inverse_kinematics(const LegModel& leg, const Vector3& p_BF) noexcept;

/// X_BL of a link (0 coxa, 1 femur, 2 tibia), as the product of the rotations about the joint axes
/// of LegModel. Slower than the functions above and independent of them: for simulators, and as an
/// oracle.
[[nodiscard]] Pose link_pose(const LegModel& leg, int link, const LegJoints& q) noexcept;

}  // namespace hexagait

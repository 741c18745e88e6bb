// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/model/leg_solution.hpp>

/// The closed-form kinematics of the yaw-pitch-pitch leg; frames and canonical angles k as in
/// LegModel. Behind kinematics.hpp, whose functions say what theirs of the same names return.
///
/// LegTrig: [0] canonical yaw k₁, [1] pitch k₂ of the femur, [2] pitch k₂ + k₃ of the tibia, both
/// positive downwards.
namespace hexagait::yaw_pitch_pitch {

[[nodiscard]] LegTrig leg_trig(const LegModel& leg, const LegJoints& q) noexcept;

///     r = coxa + femur c₂ + tibia c₂₃,   h = −femur s₂ − tibia s₂₃,   p_HF = (r c₁, r s₁, h)
[[nodiscard]] Vector3 foot_position(const LegModel& leg, const LegTrig& trig) noexcept;

/// Singular where r = 0, and where the knee is straight or folded.
[[nodiscard]] LegJacobian foot_jacobian(const LegModel& leg, const LegTrig& trig) noexcept;

/// R_BT of the tibia frame T: x from the knee to the foot, y along the canonical pitch axis.
[[nodiscard]] Matrix3 tibia_rotation(const LegModel& leg, const LegTrig& trig) noexcept;

[[nodiscard]] Vector3 tibia_turn(const LegModel& leg, const LegTrig& trig,
                                 const LegJoints& dq) noexcept;

/// Joint values that put the foot at p_BF with the knee above the line from hip to foot.
///
/// With (r, h) the foot in the leg's plane, a = r − coxa, b = −h and d² = a² + b²:
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
/// @pre 0 < min_reach <= max_reach < femur + tibia, and min_reach > |femur − tibia|
[[nodiscard]] LegSolution inverse_kinematics(const LegModel& leg, const Vector3& p_BF) noexcept;

}  // namespace hexagait::yaw_pitch_pitch

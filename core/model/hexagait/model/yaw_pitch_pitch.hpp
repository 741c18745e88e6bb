// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/model/leg_solution.hpp>
#include <hexagait/model/yaw_and_pitches.hpp>

namespace hexagait {

/// Closed-form kinematics of a yaw-pitch-pitch leg; frames and canonical angles k as in LegModel.
/// LegTrig: [0] canonical yaw k₁, [1] pitch k₂ of the femur, [2] pitch k₂ + k₃ of the tibia, both
/// positive downwards.
struct YawPitchPitchLeg {
  static constexpr double kOnAxis = 1e-12;  ///< feet closer to an axis count as on it [m]
  static constexpr double kLittle =
      0.125;  ///< tan of half the angle by which joints turn little: 14°

  static LegTrig leg_trig(const LegModel& leg, const LegJoints& q) noexcept;

  ///     r = coxa + femur c₂ + tibia c₂₃,   h = −femur s₂ − tibia s₂₃,   p_HF = (r c₁, r s₁, h)
  static Vector3 foot_position(const LegModel& leg, const LegTrig& trig) noexcept;

  /// Singular where r = 0, and where the knee is straight or folded.
  static LegJacobian foot_jacobian(const LegModel& leg, const LegTrig& trig) noexcept;

  /// With the force (f_r, f_t, f_z) in the leg's plane, across it and upwards:
  ///
  ///     τ₃ = −tibia (s₂₃ f_r + c₂₃ f_z),   τ₂ = τ₃ − femur (s₂ f_r + c₂ f_z),   τ₁ = r f_t
  static LegJoints foot_effort(const LegModel& leg, const LegTrig& trig,
                               const Vector3& force_B) noexcept;

  /// R_BT of the tibia frame T: x from the knee to the foot, y along the canonical pitch axis.
  static Matrix3 tibia_rotation(const LegModel& leg, const LegTrig& trig) noexcept;

  static Vector3 tibia_turn(const LegModel& leg, const LegTrig& trig, const LegJoints& dq) noexcept;

  /// Joint values that put the foot at p_BF with the knee above the line from hip to foot.
  ///
  /// With (r, h) the foot in the leg's plane, a = r − coxa, b = −h and d² = a² + b²:
  ///
  ///     c₃ = (d² − femur² − tibia²) / (2 femur tibia),   s₃ = +√(1 − c₃²)
  ///     A = femur + tibia c₃,   B = tibia s₃,   (c₂, s₂) = (A a + B b, A b − B a) / d²
  ///
  /// Yaw turns the leg's plane towards the foot, r > 0; where the limits forbid this but allow the
  /// leg to reach back through the yaw axis, r < 0. For a foot on the yaw axis, yaw is 0.
  ///
  /// For a target out of reach, yaw is clamped to its limits first, the target is projected into
  /// the leg's plane and moved along the line from the hip-pitch axis into [min_reach, max_reach];
  /// then hip and knee are clamped.
  ///
  /// @param near  not used: there is only one solution
  /// @pre 0 < min_reach <= max_reach < femur + tibia, and min_reach > |femur − tibia|
  static LegSolution inverse_kinematics(const LegModel& leg, const Vector3& p_BF,
                                        const LegJoints& near) noexcept;

  /// Where the foot is within reach and no angle k differs by more than 14° from the one k' of
  /// `near`, without an arcus tangent of it:
  ///
  ///     k = k' + 2 atan u,   u = (s c' − c s') / (1 + c c' + s s')
  static LegSolution inverse_kinematics(const LegModel& leg, const Vector3& p_BF,
                                        const LegJoints& near, const LegTrig& near_trig) noexcept;
};

static_assert(LegKinematics<YawPitchPitchLeg>);

// Short ones, for each leg in each tick.

inline Vector3 YawPitchPitchLeg::foot_position(const LegModel& leg, const LegTrig& trig) noexcept {
  const double r = leg.coxa + leg.femur * trig.c[1] + leg.tibia * trig.c[2];
  const double h = -leg.femur * trig.s[1] - leg.tibia * trig.s[2];
  return leg.X_BH * Vector3(r * trig.c[0], r * trig.s[0], h);
}

inline LegJoints YawPitchPitchLeg::foot_effort(const LegModel& leg, const LegTrig& trig,
                                               const Vector3& force_B) noexcept {
  // In the leg's plane, outwards and up; and across it.
  const Vector3 f = leg.X_BH.R.transpose() * force_B;
  const double outwards = trig.c[0] * f.x() + trig.s[0] * f.y(), up = f.z();
  const double across = trig.c[0] * f.y() - trig.s[0] * f.x();
  const double r = leg.coxa + leg.femur * trig.c[1] + leg.tibia * trig.c[2];
  const double knee = -leg.tibia * (trig.s[2] * outwards + trig.c[2] * up);
  const double hip = knee - leg.femur * (trig.s[1] * outwards + trig.c[1] * up);
  LegJoints effort = LegJoints::Zero();
  effort.head<3>() = leg.joint_sign.cwiseProduct(Vector3(r * across, hip, knee));
  return effort;
}

inline Vector3 YawPitchPitchLeg::tibia_turn(const LegModel& leg, const LegTrig& trig,
                                            const LegJoints& dq) noexcept {
  const Vector3 dk = leg.joint_sign.cwiseProduct(dq.head<3>());
  return detail::last_link_turn(leg, {trig.s[0], trig.c[0]}, dk[0], dk[1] + dk[2]);
}

}  // namespace hexagait

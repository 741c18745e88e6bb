// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/model/leg_solution.hpp>

namespace hexagait {

/// Closed-form kinematics of a leg of two joints, as Genghis' ([PC04] 5): yaw k₁ swings it fore and
/// aft, pitch k₂, positive downwards, lowers it. LegTrig: [0] of k₁, [1] of k₂.
///
///     r = coxa + femur c₂,   h = −femur s₂,   p_HF = (r c₁, r s₁, h)                      (leg 5)
///
/// Its foot is on a surface, and can't be where one wants it. Inverse kinematics project along x_H,
/// outwards: y and z of p_HF are those that are asked for, and x is what comes of it,
///
///     s₂ = −z/femur,   s₁ = y/r                                                           (leg 6)
///
/// A foot that stands keeps its place fore and aft, and slides across, to the side.
struct YawPitchLeg {
  static LegTrig leg_trig(const LegModel& leg, const LegJoints& q) noexcept;
  static Vector3 foot_position(const LegModel& leg, const LegTrig& trig) noexcept;
  static LegJacobian foot_jacobian(const LegModel& leg, const LegTrig& trig) noexcept;
  static LegJoints foot_effort(const LegModel& leg, const LegTrig& trig,
                               const Vector3& force_B) noexcept;

  /// R_BT of the frame T of the last link: x to the foot, y along the canonical pitch axis.
  static Matrix3 tibia_rotation(const LegModel& leg, const LegTrig& trig) noexcept;
  static Vector3 tibia_turn(const LegModel& leg, const LegTrig& trig, const LegJoints& dq) noexcept;

  /// (leg 6). `reachable`: y and z are within reach and limits; of x it says nothing.
  /// @param near  not used: there is only one solution with the foot outside of the pitch axis
  static LegSolution inverse_kinematics(const LegModel& leg, const Vector3& p_BF,
                                        const LegJoints& near) noexcept;
  static LegSolution inverse_kinematics(const LegModel& leg, const Vector3& p_BF,
                                        const LegJoints& near, const LegTrig& near_trig) noexcept;
};

static_assert(LegKinematics<YawPitchLeg>);

}  // namespace hexagait

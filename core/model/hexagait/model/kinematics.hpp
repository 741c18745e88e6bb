// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/model/leg_solution.hpp>
#include <hexagait/model/serial_leg.hpp>
#include <hexagait/model/yaw_pitch_pitch.hpp>

namespace hexagait {

// Forward and inverse kinematics of a leg, by its kind: in closed form for yaw_pitch_pitch, by
// iteration for serial. Fit for a control loop: nothing here allocates or throws, iterations are
// bounded, and forward kinematics, Jacobian, tibia orientation and inverse kinematics share one set
// of sines and cosines per leg.

/// @param q  joint values in the robot's own signs and zeros [rad]
[[nodiscard]] inline LegTrig leg_trig(const LegModel& leg, const LegJoints& q) noexcept {
  return leg.kind == LegKind::serial ? serial::leg_trig(leg, q) : yaw_pitch_pitch::leg_trig(leg, q);
}

/// Foot centre p_BF [m].
[[nodiscard]] inline Vector3 foot_position(const LegModel& leg, const LegTrig& trig) noexcept {
  return leg.kind == LegKind::serial ? serial::foot_position(leg, trig)
                                     : yaw_pitch_pitch::foot_position(leg, trig);
}
[[nodiscard]] inline Vector3 foot_position(const LegModel& leg, const LegJoints& q) noexcept {
  return foot_position(leg, leg_trig(leg, q));
}

/// ∂p_BF/∂q [m/rad], by the robot's own joint values q.
[[nodiscard]] inline LegJacobian foot_jacobian(const LegModel& leg, const LegTrig& trig) noexcept {
  return leg.kind == LegKind::serial ? serial::foot_jacobian(leg, trig)
                                     : yaw_pitch_pitch::foot_jacobian(leg, trig);
}

/// R_BT of a frame T that is fixed to the link with the foot.
[[nodiscard]] inline Matrix3 tibia_rotation(const LegModel& leg, const LegTrig& trig) noexcept {
  return leg.kind == LegKind::serial ? serial::tibia_rotation(leg, trig)
                                     : yaw_pitch_pitch::tibia_rotation(leg, trig);
}

/// Rotation, in the body frame, of the link with the foot when the joints change by dq, to second
/// order [rad].
/// @param trig  the angles at which the change begins
[[nodiscard]] inline Vector3 tibia_turn(const LegModel& leg, const LegTrig& trig,
                                        const LegJoints& dq) noexcept {
  return leg.kind == LegKind::serial ? serial::tibia_turn(leg, trig, dq)
                                     : yaw_pitch_pitch::tibia_turn(leg, trig, dq);
}

/// Are all joints within their limits? An excess of up to 1e-9 rad (rounding) is allowed.
[[nodiscard]] bool within_limits(const LegModel& leg, const LegJoints& q) noexcept;

/// The joints that the leg has, and 0 for the rest, whatever stood there.
[[nodiscard]] LegJoints own_joints(const LegModel& leg, const LegJoints& q) noexcept;

/// Joint values that put the foot at p_BF; where there are none, those that bring it near.
/// @param p_BF  foot centre in the body frame [m]; any finite value
/// @param near  where the search begins and, of several answers, which one is meant: the joint
///              values before [rad]. The closed form needs none.
[[nodiscard]] inline LegSolution inverse_kinematics(const LegModel& leg, const Vector3& p_BF,
                                                    const LegJoints& near) noexcept {
  return leg.kind == LegKind::serial ? serial::inverse_kinematics(leg, p_BF, near)
                                     : yaw_pitch_pitch::inverse_kinematics(leg, p_BF);
}
/// The same, near the nominal stance.
[[nodiscard]] inline LegSolution inverse_kinematics(const LegModel& leg,
                                                    const Vector3& p_BF) noexcept {
  return inverse_kinematics(leg, p_BF, leg.q_nominal);
}

/// X_BL of a link (0 … num_joints − 1), as the product of the rotations about the joint axes of
/// LegModel. Slower than the functions above and independent of them: for simulators, and as an
/// oracle.
[[nodiscard]] Pose link_pose(const LegModel& leg, int link, const LegJoints& q) noexcept;

}  // namespace hexagait

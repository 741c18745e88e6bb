// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/model/leg_solution.hpp>
#include <hexagait/model/serial_leg.hpp>
#include <hexagait/model/yaw_pitch.hpp>
#include <hexagait/model/yaw_pitch_pitch.hpp>

namespace hexagait {

// Forward and inverse kinematics of a leg: in closed form for yaw_pitch_pitch and yaw_pitch, by
// iteration for serial. For use in a control loop: nothing here allocates or throws, iterations are bounded, and
// all functions share one set of sines and cosines per leg.

/// Calls f with the LegKinematics of the leg's kind.
template <class F>
[[nodiscard]] auto by_kind(const LegModel& leg, F f) noexcept {
  if (leg.kind == LegKind::yaw_pitch) return f(YawPitchLeg{});
  return leg.kind == LegKind::serial ? f(SerialLeg{}) : f(YawPitchPitchLeg{});
}

/// @param q  joint values in the robot's own signs and zeros [rad]
[[nodiscard]] inline LegTrig leg_trig(const LegModel& leg, const LegJoints& q) noexcept {
  return by_kind(leg, [&]<class Kind>(Kind) { return Kind::leg_trig(leg, q); });
}

/// Foot centre p_BF [m].
[[nodiscard]] inline Vector3 foot_position(const LegModel& leg, const LegTrig& trig) noexcept {
  return by_kind(leg, [&]<class Kind>(Kind) { return Kind::foot_position(leg, trig); });
}
[[nodiscard]] inline Vector3 foot_position(const LegModel& leg, const LegJoints& q) noexcept {
  return foot_position(leg, leg_trig(leg, q));
}

/// ∂p_BF/∂q [m/rad], with q in the robot's own signs and zeros.
[[nodiscard]] inline LegJacobian foot_jacobian(const LegModel& leg, const LegTrig& trig) noexcept {
  return by_kind(leg, [&]<class Kind>(Kind) { return Kind::foot_jacobian(leg, trig); });
}

/// Joint efforts with which the foot presses on the world with a force: Jᵀ F [N m].
/// @param force_B  F, axes of the body [N]
[[nodiscard]] inline LegJoints foot_effort(const LegModel& leg, const LegTrig& trig,
                                           const Vector3& force_B) noexcept {
  return by_kind(leg, [&]<class Kind>(Kind) { return Kind::foot_effort(leg, trig, force_B); });
}

/// R_BT of a frame T that is fixed to the last link.
[[nodiscard]] inline Matrix3 tibia_rotation(const LegModel& leg, const LegTrig& trig) noexcept {
  return by_kind(leg, [&]<class Kind>(Kind) { return Kind::tibia_rotation(leg, trig); });
}

/// Rotation vector of the last link, in the body frame, when the joints change by dq; accurate to
/// second order [rad].
/// @param trig  of the joint values before the change
[[nodiscard]] inline Vector3 tibia_turn(const LegModel& leg, const LegTrig& trig,
                                        const LegJoints& dq) noexcept {
  return by_kind(leg, [&]<class Kind>(Kind) { return Kind::tibia_turn(leg, trig, dq); });
}

/// Are all joints within their limits, up to a rounding error of 1e-9 rad?
[[nodiscard]] bool within_limits(const LegModel& leg, const LegJoints& q) noexcept;

/// q with the entries beyond the leg's joints set to 0, whatever they were.
[[nodiscard]] inline LegJoints own_joints(const LegModel& leg, const LegJoints& q) noexcept {
  LegJoints own = LegJoints::Zero();
  own.head<kMinLegJoints>() = q.head<kMinLegJoints>();
  for (int i = kMinLegJoints; i < leg.num_joints(); ++i) own[i] = q[i];
  return own;
}

/// Joint values that put the foot at p_BF, or close to it if it is out of reach. A leg of two joints
/// puts it there fore and aft and in height only: (leg 6).
/// @param p_BF  foot centre in the body frame [m]; any finite value
/// @param near  joint values [rad], usually the previous ones: where the search of a serial leg
///              starts, and which of several solutions it finds
[[nodiscard]] inline LegSolution inverse_kinematics(const LegModel& leg, const Vector3& p_BF,
                                                    const LegJoints& near) noexcept {
  return by_kind(leg, [&]<class Kind>(Kind) { return Kind::inverse_kinematics(leg, p_BF, near); });
}

/// The same, faster for a foot that has moved little since `near`. It goes on from there: rounding
/// errors of one solution after the other add up, to some 1e-12 rad in a million.
/// @param near_trig  of `near`
[[nodiscard]] inline LegSolution inverse_kinematics(const LegModel& leg, const Vector3& p_BF,
                                                    const LegJoints& near,
                                                    const LegTrig& near_trig) noexcept {
  return by_kind(
      leg, [&]<class Kind>(Kind) { return Kind::inverse_kinematics(leg, p_BF, near, near_trig); });
}

/// The same, near the nominal stance.
[[nodiscard]] inline LegSolution inverse_kinematics(const LegModel& leg,
                                                    const Vector3& p_BF) noexcept {
  return inverse_kinematics(leg, p_BF, leg.q_nominal);
}

/// Pose X_BL of a link (0 … num_joints − 1), as the product of rotations about the joint axes of
/// LegModel. Slower than the functions above and independent of them: for simulators and tests.
[[nodiscard]] Pose link_pose(const LegModel& leg, int link, const LegJoints& q) noexcept;

}  // namespace hexagait

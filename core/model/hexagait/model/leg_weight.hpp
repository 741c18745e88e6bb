// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/model/robot_model.hpp>

namespace hexagait {

/// The weight of a leg's own links: the joint efforts that hold it, and its first moment of mass.
struct LegWeight {
  LegJoints effort = LegJoints::Zero();  ///< holds the links against gravity [N m]
  Vector3 moment_B = Vector3::Zero();    ///< first moment of mass, Σ m_i p_BM,i [kg m]
};

/// With a_k the axis of joint k and p_J,k a point on it:
///
///     τ_k = a_k · Σ_{i ≥ k} (p_M,i − p_J,k) × m_i g up                                  (weight 1)
///
/// @param q       joint values [rad]
/// @param g_up_B  minus the acceleration of gravity, body frame [m/s²]
[[nodiscard]] LegWeight leg_weight(const LegModel& leg, const LegJoints& q,
                                   const Vector3& g_up_B) noexcept;

/// The robot's centre of mass in a posture, body frame [m].
/// @param q  joint values of each leg [rad]
/// @pre the robot's mass is set
[[nodiscard]] Vector3 centre_of_mass(const RobotModel& robot,
                                     const LegArray<LegJoints>& q) noexcept;

/// The robot's inertia about its centre of mass in the nominal stance, axes of the body [kg m²].
/// @pre mass and p_BM of the robot are set
[[nodiscard]] Matrix3 nominal_inertia(const RobotModel& robot);

}  // namespace hexagait

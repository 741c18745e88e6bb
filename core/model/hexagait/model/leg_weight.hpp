// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/model/robot_model.hpp>

namespace hexagait {

/// What the mass of a leg's own links does to its joints and to the balance of the robot.
struct LegWeight {
  LegJoints effort = LegJoints::Zero();  ///< that holds the links against gravity [N m]
  Vector3 moment_B = Vector3::Zero();    ///< Σ m_i p_BM,i [kg m]
};

/// Of a leg at q, with a_k the axis of joint k and p_J,k a point on it:
///
///     τ_k = a_k · Σ_{i ≥ k} (p_M,i − p_J,k) × m_i g up                                  (weight 1)
///
/// @param g_up_B  against gravity, with its magnitude; body frame [m/s²]
[[nodiscard]] LegWeight leg_weight(const LegModel& leg, const LegJoints& q,
                                   const Vector3& g_up_B) noexcept;

/// The robot's inertia about its centre of mass in the nominal stance, axes of the body [kg m²].
/// @pre mass and p_BM of the robot are known
[[nodiscard]] Matrix3 nominal_inertia(const RobotModel& robot);

}  // namespace hexagait

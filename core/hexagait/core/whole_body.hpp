// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/core/contact_forces.hpp>
#include <hexagait/core/kinematics.hpp>
#include <hexagait/core/robot_model.hpp>

namespace hexagait {

/// How set points become joint efforts; switched without touching the action ([FG16] IV).
enum class WholeBodyController : std::uint8_t {
  kinematic,      ///< the joints are servoed to their targets, the weight is fed forward
  virtual_model,  ///< the base is held by a virtual spring and damper, the feet push accordingly
};

/// The springs and dampers of the virtual model; the defaults suit a robot of some 50 kg.
struct VirtualModelParams {
  double stiffness = 4000.0;      ///< [N/m]
  double damping = 600.0;         ///< [N s/m]
  double turn_stiffness = 400.0;  ///< [N m/rad]
  double turn_damping = 50.0;     ///< [N m s/rad]
  ContactForceParams contact;
};

/// Where the base is to be and is not: desired less present, axes of the present base.
struct BaseError {
  Vector3 p_B = Vector3::Zero();     ///< [m]
  Vector3 turn_B = Vector3::Zero();  ///< rotation vector [rad]
  Twist V_B;                         ///< [m/s], [rad/s]
};

/// Of a base at X_OB with twist V_B (its own axes) that is to be at X_OD with twist V_D (axes of
/// D).
[[nodiscard]] BaseError base_error(const Pose& X_OB, const Twist& V_B, const Pose& X_OD,
                                   const Twist& V_D) noexcept;

/// What the efforts depend on.
struct WholeBodyInput {
  LegArray<Vector3> p_BF;           ///< set points of the feet, body frame [m]
  LegArray<LegTrig> trig;           ///< of the joint targets
  LegArray<double> load;            ///< share of its load that each leg carries, 0 … 1
  Vector3 up_B = Vector3::UnitZ();  ///< against gravity, in the body frame
  LegArray<Vector3> normal_B;       ///< of the ground at each foot; virtual model only
  BaseError error;                  ///< virtual model only
};

/// The wrench of the virtual model: weight, spring and damper,
///
///     F = m g up + k e + d ė,   M = p_BM × m g up + k' θ + d' ω                        (body 1)
[[nodiscard]] Wrench virtual_model_wrench(const RobotModel& model, const WholeBodyInput& input,
                                          double gravity,
                                          const VirtualModelParams& params) noexcept;

/// Joint efforts with which the feet that carry press on the ground: τ = Jᵀ (−F), F by
/// shared_load() along `up_B` (kinematic) or by contact_forces() for (body 1) (virtual model). Legs
/// in the air get 0: they are servoed.
///
/// @param gravity  [m/s²]
/// @returns τ [N m]
[[nodiscard]] LegArray<LegJoints> joint_efforts(WholeBodyController controller,
                                                const RobotModel& model,
                                                const WholeBodyInput& input, double gravity,
                                                const VirtualModelParams& params) noexcept;

}  // namespace hexagait

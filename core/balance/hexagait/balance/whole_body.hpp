// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/balance/contact_forces.hpp>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/model/robot_model.hpp>

namespace hexagait {

/// How set points become joint efforts; switched without touching the action ([FG16] IV).
enum class WholeBodyController : std::uint8_t {
  kinematic,  ///< the joints are servoed to their targets, the weight is fed forward
  /// The base is held by a virtual spring and damper, the feet push accordingly. Legs that stand
  /// are driven by efforts alone: their angles must be measured (SensorMask::joint_feedback).
  virtual_model,
};

[[nodiscard]] const char* to_string(WholeBodyController controller) noexcept;

/// The springs and dampers of the virtual model. As frequencies they are the same for every robot:
/// its mass and its inertia make forces of them (body 1).
struct VirtualModelParams {
  /// ω of the base in its spring [rad/s]. Lower: the base gives way more, by f/(m ω²) to a force f
  /// and by a/ω² where its plan accelerates by a. Higher: stiffer; what the springs ask for must be
  /// done long before the base has moved, so ω is to be a fraction (a fifth, say) of the bandwidth
  /// of the joints' torque, and ω dt, with the control period, far below 1. The default, 2 Hz,
  /// gives way by 6 mm to a force of a tenth of the weight, and asks for no more than joints with a
  /// bandwidth of 10 Hz and a control period of up to 10 ms.
  double frequency = 12.5;
  double turn_frequency = 12.5;  ///< the same of turns [rad/s]

  /// ζ. 1: back without overshoot, as fast as can be. Higher: slower, and the noise of the
  /// velocity, which is that of the joint angles over one period, reaches the joints; lower: it
  /// swings.
  double damping_ratio = 1.0;
  double turn_damping_ratio = 1.0;

  /// Of foot and ground, as far as one relies on it: larger than true, and feet slip.
  double friction = 0.6;
  /// Bounds of what a fully loaded foot carries, as shares of the weight. The lower one keeps it on
  /// the ground, and its contact sensor in no doubt; the upper one saves the leg. A foot that
  /// carried the whole robot would need 1.
  double least_load = 0.02;
  double most_load = 1.2;
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

  // The virtual model only.
  LegArray<LegJoints> q;       ///< of trig [rad]
  LegArray<Vector3> normal_B;  ///< of the ground at each foot
  BaseError error;
};

/// The wrench of the virtual model: weight, spring and damper, at the centre of mass M. With e, θ
/// the error of M and of the base's rotation, I the inertia about M (RobotModel):
///
///     F = m (g up + ω² e + 2 ζ ω ė),   M = p_BM × F + I (ω'² θ + 2 ζ' ω' θ̇)             (body 1)
///
/// so the base comes back as a mass on a spring of that frequency, as far as legs have no mass.
/// @param p_BM  as the legs are now [m]
[[nodiscard]] Wrench virtual_model_wrench(const RobotModel& model, const Vector3& p_BM,
                                          const WholeBodyInput& input, double gravity,
                                          const VirtualModelParams& params) noexcept;

/// Joint efforts with which the feet that carry press on the ground: τ = Jᵀ (−F), F by
/// shared_load() along `up_B` (kinematic) or by contact_forces() for (body 1) (virtual model; it
/// also holds the links of all legs, (weight 1)). Legs in the air press on nothing: they are
/// servoed.
///
/// @param gravity  [m/s²]
/// @returns τ [N m]
[[nodiscard]] LegArray<LegJoints> joint_efforts(WholeBodyController controller,
                                                const RobotModel& model,
                                                const WholeBodyInput& input, double gravity,
                                                const VirtualModelParams& params) noexcept;

}  // namespace hexagait

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/balance/contact_forces.hpp>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/model/robot_model.hpp>
#include <hexagait/params/robot_params.hpp>

namespace hexagait {

/// How joint efforts are computed from set points, independently of the action ([FG16] IV).
enum class WholeBodyController : std::uint8_t {
  kinematic,  ///< the joints are servoed to their targets, the weight is fed forward
  /// A virtual spring and damper hold the base, and contact forces realise their wrench. Standing
  /// legs are driven by effort alone, so their angles must be measured
  /// (SensorMask::joint_feedback).
  virtual_model,
};

[[nodiscard]] const char* to_string(WholeBodyController controller) noexcept;

/// The springs and dampers of the virtual model. They are given as natural frequencies, which suit
/// robots of any size: (body 1) multiplies them by mass and inertia.
struct VirtualModelParams {
  /// Natural frequency ω of the base's position [rad/s]. Lower: the base is softer; a force f
  /// displaces it by f/(m ω²), and it lags by a/ω² behind a plan that accelerates by a. Higher:
  /// stiffer. ω should be at most a fifth or so of the bandwidth of the joints' torque, and ω dt,
  /// dt the control period, far below 1. At 2 Hz a force of a tenth of the weight
  /// displaces the base by 6 mm; it needs a torque bandwidth of 10 Hz and a control period of at
  /// most 10 ms.
  double frequency = kDerived;
  double turn_frequency = kDerived;  ///< natural frequency ω' of the base's rotation [rad/s]

  /// Damping ratio ζ. 1: critical, the fastest return without overshoot. Higher: slower, and more
  /// of the noise of the differentiated joint angles reaches the joints; lower: the base
  /// oscillates.
  double damping_ratio = 1.0;
  double turn_damping_ratio = 1.0;  ///< ζ' of the base's rotation

  /// Coefficient between foot and ground that the controller relies on. Larger than the true one:
  /// feet slip.
  double friction = 0.6;
  /// Bounds of the normal force on a fully loaded foot, as fractions of the robot's weight. The
  /// lower one keeps the foot on the ground and its contact sensor closed; the upper one protects
  /// the leg. At 1, one foot could carry the whole robot.
  double least_load = 0.02;
  double most_load = 1.2;
};

/// Desired minus present state of the base, in the axes of the present base.
struct BaseError {
  Vector3 p_B = Vector3::Zero();     ///< [m]
  Vector3 turn_B = Vector3::Zero();  ///< rotation vector [rad]
  Twist V_B;                         ///< [m/s], [rad/s]
};

/// The error of a base at X_OB with twist V_B (axes of B) that should be at X_OD with twist V_D
/// (axes of D).
[[nodiscard]] BaseError base_error(const Pose& X_OB, const Twist& V_B, const Pose& X_OD,
                                   const Twist& V_D) noexcept;

/// The inputs of joint_efforts().
struct WholeBodyInput {
  const LegArray<LegJoints>& q;        ///< joint targets [rad]
  const LegArray<LegTrig>& trig;       ///< of q
  LegArray<Vector3> p_BF;              ///< set points of the feet, body frame [m]
  LegArray<double> load;               ///< fraction of its load that each leg carries, 0 … 1
  Matrix3 R_OB = Matrix3::Identity();  ///< attitude of the body; z of O is opposite to gravity

  // Used by the kinematic controller only:
  Vector3 p_BM = Vector3::Zero();  ///< centre of mass, body frame [m]

  // Used by the virtual model only:
  LegArray<Vector3> normal_B;  ///< of the ground at each foot, unit vectors
  BaseError error;

  /// Direction opposite to gravity, body frame.
  [[nodiscard]] Vector3 up_B() const { return R_OB.row(2); }
};

/// The wrench of the virtual model: weight, spring and damper, acting at the centre of mass M. With
/// e and θ the errors of M's position and of the base's rotation and I the inertia about M:
///
///     F = m (g up + ω² e + 2 ζ ω ė),   M = p_BM × F + I (ω'² θ + 2 ζ' ω' θ̇)             (body 1)
///
/// The base then moves like a mass on a spring of that frequency, as far as the legs' mass can be
/// neglected.
/// @param p_BM  centre of mass in the present posture [m]
[[nodiscard]] Wrench virtual_model_wrench(const RobotModel& model, const Vector3& p_BM,
                                          const WholeBodyInput& input, double gravity,
                                          const VirtualModelParams& params) noexcept;

/// The result of joint_efforts().
struct JointEfforts {
  LegArray<LegJoints> effort;          ///< τ [N m]
  QpStatus status = QpStatus::solved;  ///< of contact_forces(); always solved if kinematic
};

/// Joint efforts with which the loaded feet press on the ground: τ = Jᵀ (−F). F is by shared_load()
/// along up (kinematic), or by contact_forces() for the wrench of (body 1) (virtual model,
/// which also carries the links of all legs, (weight 1)). Legs in the air get no contact force.
///
/// @param gravity  [m/s²]
[[nodiscard]] JointEfforts joint_efforts(WholeBodyController controller, const RobotModel& model,
                                         const WholeBodyInput& input, double gravity,
                                         const VirtualModelParams& params) noexcept;

}  // namespace hexagait

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/core/load_sharing.hpp>
#include <hexagait/core/whole_body.hpp>

namespace hexagait {
namespace {

// Each standing foot presses down with its share of the weight: τ = Jᵀ (−F up).
LegArray<LegJoints> kinematic_efforts(const RobotModel& model, const WholeBodyInput& input,
                                      double gravity) {
  const int n = model.num_legs();
  LegArray<LegJoints> effort(n, LegJoints::Zero());
  const LegArray<double> force =
      shared_load(input.p_BF, model.p_BM, input.load, model.mass * gravity);
  for (LegId i = 0; i < n; ++i) {
    if (force[i] > 0.0)
      effort[i] =
          foot_jacobian(model.legs[i], input.trig[i]).transpose() * (-force[i] * input.up_B);
  }
  return effort;
}

LegArray<LegJoints> virtual_model_efforts(const RobotModel& model, const WholeBodyInput& input,
                                          double gravity, const VirtualModelParams& params) {
  const int n = model.num_legs();
  LegArray<LegJoints> effort(n, LegJoints::Zero());
  const LegArray<Vector3> force = contact_forces(
      {virtual_model_wrench(model, input, gravity, params), input.p_BF, input.normal_B, input.load},
      params.contact);
  for (LegId i = 0; i < n; ++i)
    effort[i] = foot_jacobian(model.legs[i], input.trig[i]).transpose() * -force[i];
  return effort;
}

}  // namespace

BaseError base_error(const Pose& X_OB, const Twist& V_B, const Pose& X_OD,
                     const Twist& V_D) noexcept {
  const Pose X_BD = X_OB.inverse() * X_OD;
  return {X_BD.p, rotation_vector(X_BD.R), {X_BD.R * V_D.v - V_B.v, X_BD.R * V_D.w - V_B.w}};
}

Wrench virtual_model_wrench(const RobotModel& model, const WholeBodyInput& input, double gravity,
                            const VirtualModelParams& params) noexcept {
  const Vector3 weight = model.mass * gravity * input.up_B;
  const BaseError& error = input.error;
  return {weight + params.stiffness * error.p_B + params.damping * error.V_B.v,
          model.p_BM.cross(weight) + params.turn_stiffness * error.turn_B +
              params.turn_damping * error.V_B.w};
}

LegArray<LegJoints> joint_efforts(WholeBodyController controller, const RobotModel& model,
                                  const WholeBodyInput& input, double gravity,
                                  const VirtualModelParams& params) noexcept {
  return controller == WholeBodyController::kinematic
             ? kinematic_efforts(model, input, gravity)
             : virtual_model_efforts(model, input, gravity, params);
}

}  // namespace hexagait

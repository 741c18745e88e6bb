// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <hexagait/balance/load_sharing.hpp>
#include <hexagait/balance/whole_body.hpp>
#include <hexagait/model/leg_weight.hpp>

namespace hexagait {
namespace {

// Each loaded foot presses down with its part of the weight: τ = Jᵀ (−F up). The parts are those of the feet as
// gravity sees them.
LegArray<LegJoints> kinematic_efforts(const RobotModel& model, const WholeBodyInput& input,
                                      double gravity) {
  const int n = model.num_legs();
  LegArray<LegJoints> effort(n, LegJoints::Zero());
  LegArray<Vector3> p_F_O(n);  // from the body's origin
  for (LegId i = 0; i < n; ++i) p_F_O[i] = input.R_OB * input.p_BF[i];
  const Vector3 up_B = input.up_B();
  const LegArray<double> force =
      shared_load(p_F_O, input.R_OB * input.p_BM, input.load, model.mass * gravity);
  for (LegId i = 0; i < n; ++i) {
    if (force[i] > 0.0) effort[i] = foot_effort(model.legs[i], input.trig[i], -force[i] * up_B);
  }
  return effort;
}

// The lever arm that makes forces and moments comparable: both then count as accelerations.
double radius_of_gyration(const RobotModel& model) {
  return std::sqrt(model.inertia_M_B.trace() / (3.0 * model.mass));
}

ContactForceParams contact_params(const RobotModel& model, double gravity,
                                  const VirtualModelParams& params) {
  const double weight = model.mass * gravity;
  return {.friction = params.friction,
          .min_normal = params.least_load * weight,
          .max_normal = params.most_load * weight,
          .moment_arm = radius_of_gyration(model)};
}

// Contact forces for (body 1), plus the efforts that hold the legs themselves.
JointEfforts virtual_model_efforts(const RobotModel& model, const WholeBodyInput& input,
                                   double gravity, const VirtualModelParams& params) {
  const int n = model.num_legs();
  LegArray<LegJoints> effort(n, LegJoints::Zero());
  Vector3 moment_B = model.base.mass * model.base.p_LM;
  for (LegId i = 0; i < n; ++i) {
    const LegWeight weight = leg_weight(model.legs[i], input.q[i], gravity * input.up_B());
    effort[i] = weight.effort;
    moment_B += weight.moment_B;
  }
  const ContactForces forces =
      contact_forces({virtual_model_wrench(model, moment_B / model.mass, input, gravity, params),
                      input.p_BF, input.normal_B, input.load},
                     contact_params(model, gravity, params));
  for (LegId i = 0; i < n; ++i)
    effort[i] -= foot_effort(model.legs[i], input.trig[i], forces.force[i]);
  return {effort, forces.status};
}

}  // namespace

const char* to_string(WholeBodyController controller) noexcept {
  return controller == WholeBodyController::kinematic ? "kinematic" : "virtual_model";
}

BaseError base_error(const Pose& X_OB, const Twist& V_B, const Pose& X_OD,
                     const Twist& V_D) noexcept {
  const Pose X_BD = X_OB.inverse() * X_OD;
  return {X_BD.p, rotation_vector(X_BD.R), {X_BD.R * V_D.v - V_B.v, X_BD.R * V_D.w - V_B.w}};
}

Wrench virtual_model_wrench(const RobotModel& model, const Vector3& p_BM,
                            const WholeBodyInput& input, double gravity,
                            const VirtualModelParams& params) noexcept {
  const BaseError& error = input.error;
  const Vector3 e = error.p_B + error.turn_B.cross(p_BM);
  const Vector3 v = error.V_B.v + error.V_B.w.cross(p_BM);
  const double w = params.frequency, turn_w = params.turn_frequency;
  const Vector3 force =
      model.mass * (gravity * input.up_B() + w * w * e + 2.0 * params.damping_ratio * w * v);
  return {force, p_BM.cross(force) +
                     model.inertia_M_B * (turn_w * turn_w * error.turn_B +
                                          2.0 * params.turn_damping_ratio * turn_w * error.V_B.w)};
}

JointEfforts joint_efforts(WholeBodyController controller, const RobotModel& model,
                           const WholeBodyInput& input, double gravity,
                           const VirtualModelParams& params) noexcept {
  if (controller == WholeBodyController::kinematic)
    return {kinematic_efforts(model, input, gravity)};
  return virtual_model_efforts(model, input, gravity, params);
}

}  // namespace hexagait

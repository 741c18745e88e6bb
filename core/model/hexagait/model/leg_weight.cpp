// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/model/detail/turned.hpp>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/model/leg_weight.hpp>

namespace hexagait {
namespace {

// Inertia of a link at X_BL about p_BM (Steiner).
Matrix3 inertia_about(const Vector3& p_BM, const LinkModel& link, const Pose& X_BL) {
  const Vector3 arm = X_BL * link.p_LM - p_BM;
  return X_BL.R * link.inertia_M_L * X_BL.R.transpose() +
         link.mass * (arm.squaredNorm() * Matrix3::Identity() - arm * arm.transpose());
}

// First moment of mass of a leg. From the foot inwards, each joint turns all that is beyond it, as it is with the
// joints farther in at zero.
Vector3 first_moment(const LegModel& leg, const LegJoints& q) {
  Vector3 moment_B = Vector3::Zero();
  double mass = 0.0;
  for (int i = leg.num_joints(); i-- > 0;) {
    const LinkModel& link = leg.links[i];
    mass += link.mass;
    moment_B += link.mass * (link.X_BL0 * link.p_LM);
    const Vector3 at_joint = mass * leg.p_BJ0[i];
    const auto [sine, cosine] = portable::sincos(q[i]);
    moment_B = at_joint + detail::turned(moment_B - at_joint, leg.axis_B0[i], cosine, sine);
  }
  return moment_B;
}

}  // namespace

LegWeight leg_weight(const LegModel& leg, const LegJoints& q, const Vector3& g_up_B) noexcept {
  const int joints = leg.num_joints();
  JointArray<Vector3> p_BJ(joints), axis_B(joints), moment_B(joints);

  // From the hip outwards: joints and centres of mass of the links.
  Pose X_BB0;  // displacement of the present link from its pose with all joints at zero
  for (int i = 0; i < joints; ++i) {
    p_BJ[i] = X_BB0 * leg.p_BJ0[i];
    axis_B[i] = X_BB0.R * leg.axis_B0[i];
    X_BB0 = X_BB0 * rotation_about(leg.p_BJ0[i], rotation(leg.axis_B0[i] * q[i]));
    const LinkModel& link = leg.links[i];
    moment_B[i] = link.mass * (X_BB0 * (link.X_BL0 * link.p_LM));
  }

  // Back inwards: each joint holds all links beyond it.
  LegWeight weight;
  double mass = 0.0;
  for (int i = joints; i-- > 0;) {
    mass += leg.links[i].mass;
    weight.moment_B += moment_B[i];
    weight.effort[i] = axis_B[i].dot((weight.moment_B - mass * p_BJ[i]).cross(g_up_B));
  }
  return weight;
}

Vector3 centre_of_mass(const RobotModel& robot, const LegArray<LegJoints>& q) noexcept {
  Vector3 moment_B = robot.base.mass * robot.base.p_LM;
  for (LegId i = 0; i < q.size(); ++i) moment_B += first_moment(robot.legs[i], q[i]);
  return moment_B / robot.mass;
}

Matrix3 nominal_inertia(const RobotModel& robot) {
  Matrix3 inertia = inertia_about(robot.p_BM, robot.base, {});
  for (const LegModel& leg : robot.legs) {
    const LegJoints q = inverse_kinematics(leg, leg.p_BC).q;
    for (int i = 0; i < leg.num_joints(); ++i)
      inertia += inertia_about(robot.p_BM, leg.links[i], link_pose(leg, i, q));
  }
  return inertia;
}

}  // namespace hexagait

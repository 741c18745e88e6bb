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

// From the foot inwards, each joint turns all that is beyond it, as it is with the joints farther in at zero.
struct Outer {
  Vector3 moment_B = Vector3::Zero();  // first moment of mass of the links beyond the joint
  double mass = 0.0;

  // @returns what the joint turns, with its point on the axis as the origin
  Vector3 turn_about(const LegModel& leg, int joint, double cosine, double sine) {
    const LinkModel& link = leg.links[joint];
    mass += link.mass;
    moment_B += link.mass * (link.X_BL0 * link.p_LM);
    const Vector3 at_joint = mass * leg.p_BJ0[joint];
    const Vector3 arm = detail::turned(moment_B - at_joint, leg.axis_B0[joint], cosine, sine);
    moment_B = at_joint + arm;
    return arm;
  }
};

Vector3 first_moment(const LegModel& leg, const LegJoints& q) {
  Outer outer;
  for (int i = leg.num_joints(); i-- > 0;) {
    const auto [sine, cosine] = portable::sincos(q[i]);
    outer.turn_about(leg, i, cosine, sine);
  }
  return outer.moment_B;
}

}  // namespace

LegWeight leg_weight(const LegModel& leg, const LegJoints& q, const Vector3& g_up_B) noexcept {
  const int joints = leg.num_joints();
  JointArray<double> c(joints), s(joints);
  JointArray<Vector3> g_up(joints);  // as each joint sees it with those farther in at zero
  Vector3 g = g_up_B;
  for (int i = 0; i < joints; ++i) {
    const auto [sine, cosine] = portable::sincos(q[i]);
    s[i] = sine;
    c[i] = cosine;
    g_up[i] = g;
    g = detail::turned(g, leg.axis_B0[i], c[i], -s[i]);
  }
  LegWeight weight;
  Outer outer;
  for (int i = joints; i-- > 0;)
    weight.effort[i] = leg.axis_B0[i].dot(outer.turn_about(leg, i, c[i], s[i]).cross(g_up[i]));
  weight.moment_B = outer.moment_B;
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

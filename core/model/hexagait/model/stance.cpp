// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/math/trigonometry.hpp>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/model/leg_weight.hpp>
#include <hexagait/model/stance.hpp>
#include <hexagait/model/workspace.hpp>
#include <hexagait/text/violations.hpp>

namespace hexagait {
namespace {

std::string place_in_words(const LegModel& leg, const Vector3& p_BC) {
  const Vector3 p_HC = leg.X_BH.inverse() * p_BC;
  return "its foot " + in_words(p_HC.head<2>().norm()) + " m out and " + in_words(-p_HC.z()) +
         " m below its hip";
}

// Of a leg of two joints how far out the foot is follows from its height, and can't be chosen.
Vector3 foot_of_two_joints(const LegModel& leg, const Vector3& p_HC, double z_H) {
  const double square = leg.femur * leg.femur - z_H * z_H;
  const double out = leg.coxa + std::sqrt(std::max(0.0, square));
  const Vector2 direction = p_HC.head<2>().normalized();
  return leg.X_BH * Vector3(out * direction.x(), out * direction.y(), z_H);
}

Vector3 requested_foot(const RobotModel& robot, const LegModel& leg, const StanceRequest& request) {
  Vector3 p_BC = leg.p_BC;
  if (request.height) p_BC.z() = robot.foot_radius - *request.height;
  const Vector3 p_HC = leg.X_BH.inverse() * p_BC;
  if (leg.has_two_joints()) return foot_of_two_joints(leg, p_HC, p_HC.z());
  const Vector2 out = p_HC.head<2>().normalized() * request.splay;
  return leg.X_BH * (p_HC + Vector3(out.x(), out.y(), 0.0));
}

bool has_disc(double radius) { return std::isfinite(radius) && radius > 0.0; }

}  // namespace

Stance nominal_stance(const RobotModel& robot) noexcept {
  Stance stance{LegArray<Vector3>(robot.num_legs(), Vector3::Zero()),
                LegArray<double>(robot.num_legs())};
  for (LegId leg = 0; leg < robot.num_legs(); ++leg) {
    stance.p_BC[leg] = robot.legs[leg].p_BC;
    stance.radius[leg] = robot.legs[leg].workspace_radius;
  }
  return stance;
}

Stance stance_at(const RobotModel& robot, const StanceRequest& request) {
  Violations violations("stance");
  Stance stance = nominal_stance(robot);
  for (LegId i = 0; i < robot.num_legs(); ++i) {
    LegModel leg = robot.legs[i];
    if (leg.has_two_joints() && request.splay != 0.0) {
      violations.add("leg " + leg.name,
                     "has two joints: how far out its foot is follows from the "
                     "height of the body, and no splay can be asked for");
      continue;
    }
    const Vector3 p_BC = requested_foot(robot, leg, request);
    stance.p_BC[i] = p_BC;
    stance.radius[i] = put_foot(leg, p_BC) ? reachable_radius(leg) : 0.0;
    if (!has_disc(stance.radius[i]))
      violations.add("leg " + leg.name, "can't stand and step with " + place_in_words(leg, p_BC) +
                                            "; it stands " +
                                            in_words(robot.foot_radius - robot.legs[i].p_BC.z()) +
                                            " m below the body's origin by itself");
  }
  violations.throw_if_any();
  return stance;
}

RobotModel in_stance(RobotModel robot, const Stance& stance) {
  check_stance(robot, stance);
  for (LegId i = 0; i < robot.num_legs(); ++i) {
    static_cast<void>(put_foot(robot.legs[i], stance.p_BC[i]));
    robot.legs[i].workspace_radius = stance.radius[i];
  }
  weigh(robot);
  return robot;
}

void check_stance(const RobotModel& robot, const Stance& stance) {
  Violations violations("stance");
  if (stance.p_BC.size() != robot.num_legs() || stance.radius.size() != robot.num_legs())
    violations.add("legs", "are " + std::to_string(stance.p_BC.size()) + ", the robot has " +
                               std::to_string(robot.num_legs()));
  violations.throw_if_any();
  for (LegId i = 0; i < robot.num_legs(); ++i) {
    LegModel leg = robot.legs[i];
    if (!has_disc(stance.radius[i]))
      violations.add("leg " + leg.name, "has a disc of radius " + in_words(stance.radius[i]) +
                                            " m; need a positive number");
    if (!stance.p_BC[i].allFinite() || !put_foot(leg, stance.p_BC[i]))
      violations.add("leg " + leg.name, "can't stand with " + place_in_words(leg, stance.p_BC[i]));
  }
  violations.throw_if_any();
}

bool put_foot(LegModel& leg, const Vector3& p_BC) {
  const LegSolution solution = inverse_kinematics(leg, p_BC);
  if (!solution.reachable) return false;
  leg.p_BC = p_BC;
  if (leg.kind == LegKind::serial) leg.q_nominal = solution.q;
  return true;
}

void weigh(RobotModel& robot) {
  LegArray<LegJoints> q(robot.num_legs());
  for (LegId i = 0; i < q.size(); ++i)
    q[i] = inverse_kinematics(robot.legs[i], robot.legs[i].p_BC).q;
  robot.p_BM = centre_of_mass(robot, q);
  robot.inertia_M_B = nominal_inertia(robot);
}

}  // namespace hexagait

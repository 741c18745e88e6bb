// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <hexagait/footstep_gen/walker.hpp>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/model/workspace.hpp>
#include <hexagait/plant/recorded_plant.hpp>

// Links to the controller alone: makes a hexapod in code and walks it straight ahead, on a plant
// that is at once where it is told to be.
using namespace hexagait;

namespace {

/// A yaw-pitch-pitch leg that points straight out from p_BH.
LegModel make_leg(const char* name, const Vector3& p_BH, double direction) {
  LegModel leg;
  leg.name = name;
  leg.X_BH = {Eigen::AngleAxisd(direction, Vector3::UnitZ()).toRotationMatrix(), p_BH};
  leg.coxa = 0.05;
  leg.femur = 0.15;
  leg.tibia = 0.2;
  leg.joint_names = {"yaw", "hip", "knee"};
  const Vector3 out = leg.X_BH.R.col(0), left = leg.X_BH.R.col(1);
  leg.axis_B0 = {Vector3::UnitZ(), left, left};
  leg.p_BJ0 = {p_BH, p_BH + leg.coxa * out, p_BH + (leg.coxa + leg.femur) * out};
  leg.p_BF0 = p_BH + (leg.coxa + leg.femur + leg.tibia) * out;
  for (int k = 0; k < leg.num_joints(); ++k) {
    leg.limits[k] = {.lower = -2.5, .upper = 2.5, .velocity = 10.0, .effort = 30.0};
    leg.links[k].mass = 0.2;
    leg.links[k].X_BL0 = {leg.X_BH.R, leg.p_BJ0[k]};
  }
  const Reach reach = leg_reach(leg);
  leg.min_reach = reach.min;
  leg.max_reach = reach.max;
  leg.p_BC = nominal_foot(leg);
  leg.workspace_radius = reachable_radius(leg);
  return leg;
}

RobotModel make_robot() {
  RobotModel robot;
  robot.name = "six legs";
  robot.base.mass = 6.0;
  robot.foot_radius = 0.01;
  robot.legs = LegArray<LegModel>(6);
  const char* const names[] = {"LF", "RF", "LM", "RM", "LR", "RR"};
  robot.mass = robot.base.mass;
  for (LegId i = 0; i < 6; ++i) {
    const double side = i % 2 == 0 ? 1.0 : -1.0;
    const double splay = 0.4 * (1 - i / 2);  // the front legs forwards, the rear legs backwards
    robot.legs[i] = make_leg(names[i], {0.25 * (1 - i / 2), 0.1 * side, 0.0},
                             side * (std::numbers::pi / 2 - splay));
    for (const LinkModel& link : robot.legs[i].links) robot.mass += link.mass;
  }
  robot.inertia_M_B = Matrix3::Identity() * 0.2;
  return robot;
}

}  // namespace

int main() {
  const RobotModel robot = make_robot();
  LegArray<LegJoints> q(robot.num_legs());
  for (LegId i = 0; i < robot.num_legs(); ++i)
    q[i] = inverse_kinematics(robot.legs[i], robot.legs[i].p_BC).q;

  footstep_gen::WalkerParams params;
  params.sensors.foot_contacts = false;  // flat ground: feet touch where and when it was planned
  footstep_gen::Walker walker(robot, params);
  PreviewPlant plant(q, params.control_dt);
  Measurement measured;
  PlantStatus status = plant.read(measured);
  walker.start(measured);
  while (measured.time < 5.0) {
    plant.write(walker.tick(status, measured, heading_control::Heading::straight(0.0)).targets);
    status = plant.read(measured);
  }
  const footstep_gen::TickRecord& tick = walker.record();
  std::printf("controller: %s came %.2f m in 5 s\n", robot.name.c_str(), tick.state.X_OB.p.x());
  return tick.fault == footstep_gen::Fault::none && tick.state.X_OB.p.x() > 0.1 ? 0 : 1;
}

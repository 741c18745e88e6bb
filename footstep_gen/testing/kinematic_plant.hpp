// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/footstep_gen/walker.hpp>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/model/workspace.hpp>
#include <hexagait/sim/random.hpp>

/// For tests and benchmarks: a robot of n legs, and a world without dynamics. (Not inlined: GCC 12
/// would warn that unused elements are copied uninitialised.)
namespace hexagait::footstep_gen::testing {

/// A symmetric robot of n legs, 4 to 12, in pairs 0.35 m apart: the leg of robots/argos.urdf on
/// each side, straight out.
[[gnu::noinline]] inline RobotModel robot_of(int n) {
  RobotModel robot;
  robot.legs = LegArray<LegModel>(n);
  robot.foot_radius = 0.02;
  robot.mass = 32.0 + 3.0 * n;
  for (LegId i = 0; i < n; ++i) {
    LegModel& leg = robot.legs[i];
    const double side = i % 2 == 0 ? 1.0 : -1.0, x = 0.175 * (n / 2 - 1) - 0.35 * (i / 2);
    leg.X_BH = {rotation_z(side * 0.5 * std::numbers::pi), {x, side * 0.17, 0.0}};
    leg.coxa = 0.08, leg.femur = 0.28, leg.tibia = 0.38;
    leg.limits = {JointLimits{-1.0, 1.0, 8.0, 120.0}, JointLimits{-1.6, 1.6, 8.0, 200.0},
                  JointLimits{0.1, 2.76, 8.0, 200.0}};
    leg.min_reach = leg_reach(leg).min, leg.max_reach = leg_reach(leg).max;
    leg.p_BC = nominal_foot(leg);
    leg.workspace_radius = reachable_radius(leg);
  }
  return robot;
}

/// A robot on the plane z = 0, or over other ground, that follows its commands exactly: joints are at
/// their targets one period later, and the body moves with the executor's twist. A foot has contact
/// when it reaches the ground below it, until it is `lift_off` above that. One that presses on the ground gets no lower.
struct KinematicPlant {
  const RobotModel* model;
  double (*ground)(const Vector2& p_O) = [](const Vector2&) { return 0.0; };  ///< its height [m]
  double lift_off = 5e-4;                                                     ///< [m]
  Pose X_OB;
  Measurement measurement;

  /// Level, each foot up to `spread` of its workspace radius from its centre.
  [[gnu::noinline]] KinematicPlant(const RobotModel& robot, double spread, RandomSequence random)
      : model(&robot) {
    const int n = robot.num_legs();
    measurement.q = LegArray<LegJoints>(n);
    measurement.contact = LegArray<bool>(n, true);
    for (LegId i = 0; i < n; ++i) {
      const double r = spread * robot.legs[i].workspace_radius * std::sqrt(random.u01());
      const Matrix3 R = rotation_z(random.uniform(-std::numbers::pi, std::numbers::pi));
      const Vector3 p_BF = robot.legs[i].p_BC + R * Vector3(r, 0.0, 0.0);
      measurement.q[i] = inverse_kinematics(robot.legs[i], p_BF).q;
    }
    X_OB.p.z() = robot.foot_radius - robot.legs[0].p_BC.z();
  }

  void follow(const TickRecord& record, double dt) {
    const Twist V = record.base.twist();
    X_OB = X_OB * Pose{rotation(V.w * dt), dt * V.v + 0.5 * dt * dt * V.w.cross(V.v)};
    measurement.time += dt;
    for (LegId i = 0; i < model->num_legs(); ++i) {
      const bool presses = record.legs[i].probes && measurement.contact[i];
      if (!presses) measurement.q[i] = record.targets.q[i];
      const Vector3 p_OF = foot(i);
      const double z = p_OF.z() - model->foot_radius - ground(p_OF.head<2>());
      measurement.contact[i] = z <= (measurement.contact[i] ? lift_off : 0.0);
    }
  }

  /// p_OF [m]
  Vector3 foot(LegId i) const { return X_OB * foot_position(model->legs[i], measurement.q[i]); }
};

}  // namespace hexagait::footstep_gen::testing

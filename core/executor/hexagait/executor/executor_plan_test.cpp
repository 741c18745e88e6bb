// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/sim/random.hpp>
#include <testing/action_words.hpp>
#include <testing/argos.hpp>
#include <testing/scripted_robot.hpp>

// How the executor follows plans, by the commands that become plans.

namespace hexagait {
namespace {

using testing::argos;
using testing::foot_target;
using testing::ScriptedRobot;
using testing::step;
using testing::steps;

const Vector3 kUp(0.0, 0.0, 0.08);

action::JointTarget joint_target(LegId leg) {
  action::JointTarget target;
  target.leg = leg;
  target.ignore_contact = true;
  return target;
}

double effort_limit(LegId leg, int k) { return argos().legs[leg].limits[k].effort; }

// A force of 20 N down from a foot in the air: comes within 0.1 s, at no more than a limit per
// 0.1 s, and goes likewise.
TEST(Effort, OfAPlanComesAndGoesSmoothly) {
  ScriptedRobot robot(argos());
  action::EndEffectorTarget push = foot_target(0, robot.foot(0) + kUp);
  push.force = {0.0, 0.0, -20.0};
  push.average_velocity = 0.1;
  robot.runner.submit(steps(
      {step({{foot_target(0, robot.foot(0) + kUp), {}}}), step({{push, {}}}), testing::wait(0.3)}));
  double most = 0.0;
  LegJoints before = LegJoints::Zero();
  robot.finish([&](const ActionRecord& record) {
    const LegJoints now = record.desired.targets.effort[0];
    for (int k = 0; k < 3 && record.feedback.step > 1; ++k)
      EXPECT_LE(std::abs(now[k] - before[k]), effort_limit(0, k) * robot.dt() / 0.1 * 1.001);
    before = now;
    if (record.feedback.step > 1) most = std::max(most, now.cwiseAbs().maxCoeff());
  });
  EXPECT_GT(most, 0.1);
  EXPECT_LT(before.norm(), 1e-9);
}

// Driven by efforts, a leg is where it is pushed: what comes next starts from there, and gets there
// no faster than the joints can.
TEST(ModeChange, StartsFromTheMeasuredState) {
  ScriptedRobot robot(argos());
  action::JointTarget limp = joint_target(0);
  limp.target.effort = leg_joints({0.0, 0.0, 0.0});
  limp.average_velocity = 0.1;
  action::LegMode wait = testing::leg_mode(0, false, 0.2);
  robot.runner.submit(steps(
      {step({{foot_target(0, robot.foot(0) + kUp), {}}}), step({{limp, {}}}), step({{wait, {}}})}));
  LegJoints pushed = LegJoints::Zero();
  bool driven = false;
  while (!robot.runner.idle()) {
    robot.sense();
    const JointTargets& targets = robot.record().desired.targets;
    if (targets.mode[0] == ControlMode::effort) {
      driven = true;
      robot.measurement.q[0] = pushed = targets.q[0] + leg_joints({0.002, 0.0, 0.0});
    }
    robot.runner.tick(PlantStatus::fresh, robot.measurement);
  }
  EXPECT_TRUE(driven);
  EXPECT_EQ(robot.record().desired.targets.mode[0], ControlMode::position);
  // As measured a tick before.
  EXPECT_LT((robot.record().desired.targets.q[0] - pushed).norm(), 0.002 + 1e-6);
}

TEST(Joints, StayWithinTheirLimitsAndBeyondThemTheActionFails) {
  ScriptedRobot robot(argos());
  action::JointTarget far = joint_target(2);
  const JointLimits& limits = argos().legs[2].limits[0];
  far.target.q = robot.record().state.q[2] + leg_joints({0.0, -0.3, 0.0});
  far.target.q[0] = limits.upper + 0.5;
  robot.runner.submit(steps({step({{far, {}}})}));
  robot.finish(
      [&](const ActionRecord& record) { EXPECT_LE(record.desired.targets.q[2][0], limits.upper); });
  EXPECT_EQ(robot.record().result.cause, Cause::out_of_reach);
  EXPECT_EQ(robot.record().result.leg, 2);
}

// A target of 0.1 rad/s for all the time, at the end of which the leg is held.
TEST(Joints, GoByVelocity) {
  ScriptedRobot robot(argos());
  action::JointTrajectory turn;
  turn.leg = 0;
  turn.ignore_contact = true;
  for (const double time : {0.3, 0.6}) {
    JointKnot knot{.time = time};
    knot.qd = leg_joints({0.1, 0.0, 0.0});
    turn.knots.push_back(knot);
  }
  robot.runner.submit(
      steps({step({{foot_target(0, robot.foot(0) + kUp), {}}}), step({{turn, {}}})}));
  double before = 0.0, after = 0.0;
  robot.finish([&](const ActionRecord& record) {
    const double q = record.desired.targets.q[0][0];
    if (record.feedback.step == 1) before = q;
    after = q;
  });
  // ½ · 0.3 s · 0.1 rad/s and 0.3 s · 0.1 rad/s
  EXPECT_NEAR(after - before, 0.045, 1e-3);
}

// Two targets one after the other, the first passed at 0.1 m/s: the foot doesn't stop there.
TEST(Foot, PassesFromTargetToTargetWithTheVelocityAskedFor) {
  ScriptedRobot robot(argos());
  const Vector3 start = robot.foot(0);
  action::EndEffectorTarget first = foot_target(0, start + kUp);
  first.velocity = {0.0, 0.0, 0.1};
  robot.runner.submit(
      steps({step({{first, {}}}), step({{foot_target(0, start + 1.5 * kUp), {}}})}));
  double slowest = 1.0;
  robot.finish([&](const ActionRecord& record) {
    const double risen = robot.foot(0).z() - start.z();
    if (risen > 0.078 && risen < 0.082) slowest = std::min(slowest, record.legs[0].v_O.z());
  });
  EXPECT_GT(slowest, 0.08);
  EXPECT_NEAR(robot.foot(0).z() - start.z(), 0.12, 1e-3);
}

// Joints that are stopped on their way leave the foot with the velocity it has: it searches from
// there without a jump.
TEST(Foot, KnowsItsVelocityWhenTheJointsLead) {
  ScriptedRobot robot(argos());
  action::JointTarget target = joint_target(0);
  target.target.q = robot.record().state.q[0] + leg_joints({0.3, -0.3, 0.0});
  robot.runner.submit(steps({step({{target, {}}})}));
  robot.run(0.14);
  const Vector3 before = robot.foot(0);
  robot.tick();
  EXPECT_LT((robot.lane(0).v_O - (robot.foot(0) - before) / robot.dt()).norm(), 5e-3);
  EXPECT_GT(robot.lane(0).v_O.norm(), 0.05);
}

// The set point of a foot in odom follows its curve even if odometry moves: noise of 1 mm.
TEST(Foot, ReturnsToItsCurve) {
  ScriptedRobot robot(argos());
  const Vector3 target = robot.foot(0) + Vector3(0.03, 0.0, 0.08);
  action::EndEffectorTarget slow = foot_target(0, target);
  slow.average_velocity = 0.1;
  robot.runner.submit(steps({step({{slow, {}}}), step({{foot_target(0, target), {}}})}));
  RandomSequence random{.seed = 3};
  while (!robot.runner.idle()) {
    robot.sense();
    for (LegJoints& q : robot.measurement.q)
      for (int k = 0; k < 3; ++k) q[k] += random.uniform(-1e-3, 1e-3);
    robot.runner.tick(PlantStatus::fresh, robot.measurement);
  }
  EXPECT_LT((robot.foot(0) - target).norm(), 3e-3);
}

}  // namespace
}  // namespace hexagait

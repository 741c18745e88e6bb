// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <testing/action_expectations.hpp>
#include <testing/action_words.hpp>
#include <testing/argos.hpp>
#include <testing/scripted_robot.hpp>

// When a step may begin: not while paused, and not while a leg that stands is not sure to stand.

namespace hexagait::step_begin_test {
namespace {

using testing::argos;
using testing::expect_result;
using testing::footstep;
using testing::forward;
using testing::ScriptedRobot;
using testing::step;
using testing::steps;
using testing::wait;
using Touch = ScriptedRobot::Touch;

action::Step step_of_leg_0(const ScriptedRobot& robot) {
  return step({{footstep(0, robot.foot(0) + forward(0.05)), {}}});
}

LegSet standing(const ScriptedRobot& robot) { return robot.record().desired.support; }

// Time slows to a stop within 0.2 s, in which half of that passes: the first step's time runs out
// while it slows down.
TEST(StepBegin, WaitsForTheEndOfAPause) {
  ScriptedRobot robot(argos());
  robot.runner.submit(steps({wait(0.1), step_of_leg_0(robot)}));
  robot.run(0.05);
  robot.runner.pause();
  robot.run(1.0);
  EXPECT_EQ(robot.record().feedback.step, 1);
  EXPECT_EQ(robot.record().feedback.status, ActionStatus::paused);
  EXPECT_EQ(standing(robot), LegSet::all(6));
  robot.runner.resume();
  robot.finish();
  expect_result(robot.record().result, Outcome::succeeded, Cause::none, 2, -1);
}

TEST(StepBegin, OfAnActionWaitsForTheEndOfAPauseToo) {
  ScriptedRobot robot(argos());
  robot.runner.pause();
  robot.runner.submit(steps({step_of_leg_0(robot)}));
  robot.run(1.0);
  const ActionFeedback& feedback = robot.record().feedback;
  EXPECT_FALSE(robot.runner.idle());
  EXPECT_EQ(feedback.status, ActionStatus::paused);
  EXPECT_EQ(feedback.step, 0);
  EXPECT_EQ(feedback.steps, 1);
  EXPECT_EQ(feedback.phase, 0.0);
  EXPECT_EQ(feedback.moving, LegSet());
  EXPECT_EQ(standing(robot), LegSet::all(6));
  robot.runner.resume();
  robot.finish();
  expect_result(robot.record().result, Outcome::succeeded, Cause::none, 1, -1);
}

// Leg 5 loses the ground shortly before the first step's time runs out.
TEST(StepBegin, WaitsForALegThatHasLostTheGround) {
  for (const double time : {0.24, 0.275}) {  // it searches then, or has only lost contact
    ScriptedRobot robot(argos());
    robot.runner.submit(steps({wait(0.31), step_of_leg_0(robot)}));
    robot.run(time);
    robot.touch[5] = Touch::nothing;
    robot.run(0.5);
    EXPECT_EQ(robot.record().feedback.step, 1) << time;
    EXPECT_TRUE(standing(robot).contains(0)) << time;
    EXPECT_EQ(robot.record().feedback.status, ActionStatus::regaining) << time;
    robot.touch[5] = Touch::something;
    robot.finish([&](const ActionRecord& record) {
      if (record.feedback.step == 2) {
        EXPECT_TRUE(record.desired.support.contains(5)) << time;
      }
    });
    expect_result(robot.record().result, Outcome::succeeded, Cause::none, 2, -1);
  }
}

// And fails if it never finds it: an action has a result whatever it waits for.
TEST(StepBegin, OfAnActionFailsIfAStandingLegFindsNoGround) {
  ScriptedRobot robot(argos());
  robot.touch[5] = Touch::nothing;
  robot.run(0.1);
  robot.runner.submit(steps({step_of_leg_0(robot)}));
  robot.finish({}, 10.0);
  ASSERT_TRUE(robot.runner.idle());
  expect_result(robot.record().result, Outcome::failed, Cause::lost_contact, 0, 5);
}

}  // namespace
}  // namespace hexagait::step_begin_test

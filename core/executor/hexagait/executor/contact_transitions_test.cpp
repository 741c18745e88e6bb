// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <testing/action_expectations.hpp>
#include <testing/action_words.hpp>
#include <testing/argos.hpp>
#include <testing/scripted_robot.hpp>

namespace hexagait {
namespace {

using testing::argos;
using testing::base_target;
using testing::expect_at_rest;
using testing::expect_result;
using testing::foot_target;
using testing::footstep;
using testing::forward;
using testing::kUnload;
using testing::ScriptedRobot;
using testing::step;
using testing::steps;
using testing::wait;
using Touch = ScriptedRobot::Touch;

// Ground 3 cm above where the foot is to land: it stands as soon as it touches.
TEST(Contact, ComingEarlyEndsTheMotionOfAFootThatIsToStand) {
  ScriptedRobot robot(argos());
  const Vector3 target = robot.foot(0) + forward(0.08);
  robot.ground = [target](double x, double y) {
    return (Vector2(x, y) - target.head<2>()).norm() < 0.05 ? 0.03 : 0.0;
  };
  robot.runner.submit(steps({step({{footstep(0, target), {}}})}));
  robot.finish();
  expect_result(robot.record().result, Outcome::succeeded, Cause::none, 1, -1);
  EXPECT_TRUE(robot.record().desired.support.contains(0));
  EXPECT_NEAR(robot.foot(0).z(), target.z() + 0.03, 2e-3);
}

TEST(Contact, DoesNotStopAFootThatIsToIgnoreIt) {
  ScriptedRobot robot(argos());
  const Vector3 target = robot.foot(0) + Vector3(0.0, 0.02, 0.05);
  robot.runner.submit(steps({step({{foot_target(0, target), {}}})}));
  robot.touch[0] = Touch::something;
  robot.finish();
  expect_result(robot.record().result, Outcome::succeeded, Cause::none, 1, -1);
  EXPECT_LT((robot.foot(0) - target).norm(), 2e-3);
  EXPECT_EQ(robot.lane(0).phase, LegPhase::hold);
  EXPECT_FALSE(robot.record().desired.support.contains(0));
}

// Ground 4 cm lower than expected: the step waits for the foot, which goes straight on along the
// normal. At 0.15 m/s that takes about a quarter of a second.
TEST(Contact, ComingLateMakesTheStepWait) {
  for (const Vector3& normal : {Vector3(0, 0, 1), Vector3(0.3, 0, 1)}) {
    ScriptedRobot robot(argos());
    action::Footstep down = footstep(0, robot.foot(0) + forward(0.05));
    down.surface_normal.v = normal;
    robot.ground = [x0 = robot.foot(0).x()](double x, double y) {
      return x > x0 + 0.02 && y > 0.0 ? -0.04 : 0.0;
    };
    robot.runner.submit(steps({step({{down, {}}}), wait(0.1)}));
    bool searched = false;
    Vector3 end_of_plan = Vector3::Zero();
    robot.finish([&](const ActionRecord& record) {
      if (record.legs[0].phase == LegPhase::search && !searched) end_of_plan = robot.foot(0);
      searched = searched || record.legs[0].phase == LegPhase::search;
      if (record.legs[0].phase == LegPhase::search) {
        EXPECT_EQ(record.feedback.step, 1);
      }
    });
    EXPECT_TRUE(searched);
    expect_result(robot.record().result, Outcome::succeeded, Cause::none, 2, -1);
    const Vector3 way = robot.foot(0) - end_of_plan;
    EXPECT_NEAR(way.z(), -0.04, 3e-3);
    EXPECT_NEAR(way.x(), -0.04 * normal.x() / normal.z(), 3e-3) << "along the normal";
  }
}

// A precipice: the search ends where the leg does, 0.48 m at most, or after 1.5 s.
TEST(Contact, ThatNeverComesFailsTheActionAndNamesTheLeg) {
  ScriptedRobot robot(argos());
  const Vector3 target = robot.foot(3) + forward(0.05);
  robot.ground = [target](double x, double y) {
    return (Vector2(x, y) - target.head<2>()).norm() < 0.02 ? -9.0 : 0.0;
  };
  robot.runner.submit(steps({wait(0.1), step({{footstep(3, target), {}}}), wait(0.1)}));
  robot.finish({}, 0.1 + kUnload + 0.45 + 1.5 + 0.5);
  ASSERT_TRUE(robot.runner.idle());
  expect_result(robot.record().result, Outcome::failed, Cause::no_contact, 2, 3);
  EXPECT_EQ(robot.lane(3).phase, LegPhase::hold);
  EXPECT_FALSE(robot.record().desired.support.contains(3));
  expect_at_rest(robot);
}

// A leg that stands loses the ground: everything waits, and goes on when it is back.
TEST(Contact, LostAndFoundAgainPausesAndGoesOn) {
  ScriptedRobot robot(argos());
  Pose X = robot.record().state.X_OB;
  X.p.x() += 0.05;
  robot.runner.submit(steps({step(base_target(X))}));
  robot.run(0.3);
  robot.touch[5] = Touch::nothing;
  robot.run(0.25);
  EXPECT_EQ(robot.record().feedback.status, ActionStatus::regaining);
  EXPECT_STREQ(robot.record().feedback.description, "Regaining contact");
  robot.run(0.15);
  EXPECT_LT(robot.record().desired.V_B.v.norm(), 0.03) << "comes to rest within 0.2 s";
  robot.touch[5] = Touch::something;
  robot.finish();
  expect_result(robot.record().result, Outcome::succeeded, Cause::none, 1, -1);
  EXPECT_NEAR(robot.record().state.X_OB.p.x(), X.p.x(), 5e-3);
}

TEST(Contact, LostForGoodFailsTheAction) {
  ScriptedRobot robot(argos());
  robot.runner.submit(steps({wait(0.2), wait(10.0)}));
  robot.run(0.3);
  robot.touch[4] = Touch::nothing;
  robot.finish({}, 2.0);
  ASSERT_TRUE(robot.runner.idle());
  expect_result(robot.record().result, Outcome::failed, Cause::lost_contact, 2, 4);
  expect_at_rest(robot);
}

// Contact that comes and goes with every tick neither counts as support nor lasts for ever: 5 s.
TEST(Contact, ThatFlickersForEverFailsTheAction) {
  ScriptedRobot robot(argos());
  robot.runner.submit(steps({step({{footstep(0, robot.foot(0)), {}}})}));
  int k = 0;
  robot.run(0.4);
  robot.finish(
      [&](const ActionRecord& record) {
        robot.touch[0] = ++k % 2 == 0 ? Touch::something : Touch::nothing;
        EXPECT_FALSE(record.desired.support.contains(0));
      },
      11.0);
  ASSERT_TRUE(robot.runner.idle());
  expect_result(robot.record().result, Outcome::failed, Cause::lost_contact, 1, 0);
}

}  // namespace
}  // namespace hexagait

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
using testing::leg_mode;
using testing::ScriptedRobot;
using testing::step;
using testing::steps;
using testing::wait;
using Touch = ScriptedRobot::Touch;

TEST(Sequencer, EndsAnActionWithoutStepsAtOnce) {
  ScriptedRobot robot(argos());
  robot.runner.submit({});
  EXPECT_FALSE(robot.runner.idle());
  robot.tick();
  EXPECT_TRUE(robot.runner.idle());
  expect_result(robot.record().result, Outcome::succeeded, Cause::none, 0, -1);
}

// 0.1 m at 0.65 m/s would take less than the minimum of 0.45 s; the second foot has 1 s to go. The
// load is handed over first.
TEST(Sequencer, BeginsAStepWhenAllMotionsOfTheLastHaveEnded) {
  ScriptedRobot robot(argos());
  action::Footstep slow = footstep(3, robot.foot(3) + forward(0.05));
  slow.duration = 1.0;
  robot.runner.submit(
      steps({step({{footstep(0, robot.foot(0) + forward(0.05)), {}}, {slow, {}}}), wait(0.1)}));
  double second = 0.0;
  robot.finish([&](const ActionRecord& record) {
    if (record.feedback.step == 2 && second == 0.0) second = robot.measurement.time;
    if (record.feedback.step == 1) {
      EXPECT_LT(robot.measurement.time, 1.0 + kUnload + 0.1);
    }
  });
  expect_result(robot.record().result, Outcome::succeeded, Cause::none, 2, -1);
  EXPECT_GE(second, 1.0 + kUnload);
  EXPECT_LT((robot.foot(0) - Vector3(robot.record().state.print_O[0])).norm(), 2e-3);
}

// 100 waits of 2.5 periods: 250 periods, and one in which the action begins.
TEST(Sequencer, CarriesWhatAStepOvershootsIntoTheNext) {
  ScriptedRobot robot(argos());
  const double dt = robot.dt();
  robot.runner.submit(steps(std::vector<action::Step>(100, wait(2.5 * dt))));
  robot.finish();
  EXPECT_NEAR(robot.measurement.time, 250 * dt, 1.5 * dt);
}

TEST(Sequencer, TellsHowFarItIs) {
  ScriptedRobot robot(argos());
  robot.runner.submit(steps({wait(0.2), step({{leg_mode(2, false), {}}}), wait(0.1)}));
  robot.tick();
  const ActionFeedback& feedback = robot.record().feedback;
  EXPECT_EQ(feedback.action, 1U);
  EXPECT_EQ(feedback.step, 1);
  EXPECT_EQ(feedback.steps, 3);
  EXPECT_EQ(feedback.queue, 2);
  EXPECT_EQ(feedback.status, ActionStatus::executing);
  EXPECT_DOUBLE_EQ(feedback.duration, 0.2);
  robot.run(0.1);
  EXPECT_NEAR(robot.record().feedback.phase, 0.5, 0.011);
  robot.run(0.12);
  EXPECT_EQ(robot.record().feedback.step, 2);
  EXPECT_EQ(robot.record().feedback.moving, LegSet(1U << 2));
  EXPECT_STREQ(robot.record().feedback.description, "Preparing for step");
  robot.finish();
  EXPECT_EQ(robot.record().feedback.status, ActionStatus::idle);
  EXPECT_EQ(robot.record().feedback.step, 0);
  EXPECT_EQ(robot.record().result.action, 1U);
}

TEST(Preemption, AtOnceBringsTheFootDownAndThenBeginsTheNext) {
  ScriptedRobot robot(argos());
  robot.runner.submit(steps({step({{footstep(0, robot.foot(0) + forward(0.08)), {}}}), wait(9.0)}));
  robot.run(0.25);
  ASSERT_GT(robot.foot(0).z(), robot.model.foot_radius + 0.03);
  robot.runner.submit(steps({wait(0.1)}), Preemption::at_once);
  bool touched = false;
  robot.finish([&](const ActionRecord& record) {
    touched = touched || robot.measurement.contact[0];
    if (record.feedback.action == 1 && record.feedback.status != ActionStatus::idle) {
      EXPECT_EQ(record.feedback.status, ActionStatus::stopping);
    }
    if (record.desired.support.contains(0)) {
      EXPECT_TRUE(touched);
    }
    if (record.result.action == 1) {
      EXPECT_EQ(record.result.outcome, Outcome::preempted);
      EXPECT_TRUE(record.desired.support.contains(0));
    }
  });
  EXPECT_EQ(robot.record().result.action, 2U);
  EXPECT_EQ(robot.record().result.outcome, Outcome::succeeded);
}

TEST(Preemption, AtTheEndOfTheStepAndAfterTheAction) {
  for (const Preemption when : {Preemption::end_of_step, Preemption::wait}) {
    ScriptedRobot robot(argos());
    robot.runner.submit(steps({wait(0.2), wait(0.2)}));
    robot.run(0.1);
    robot.runner.submit(steps({wait(0.05)}), when);
    double end = 0.0;
    ActionResult first;
    robot.finish([&](const ActionRecord& record) {
      if (record.result.action == 1 && end == 0.0) end = robot.measurement.time;
      if (record.result.action == 1) first = record.result;
    });
    const bool waits = when == Preemption::wait;
    EXPECT_NEAR(end, waits ? 0.4 : 0.2, 0.012);
    EXPECT_EQ(first.outcome, waits ? Outcome::succeeded : Outcome::preempted);
    EXPECT_EQ(robot.record().result.action, 2U);
  }
}

// At any moment of a step: the foot comes down, and is no support leg before it has touched.
TEST(Stop, BringsDownTheFootThatIsInTheAir) {
  for (double time = 0.01; time < 0.5; time += 0.03) {
    ScriptedRobot robot(argos());
    robot.runner.submit(steps({step({{footstep(0, robot.foot(0) + forward(0.05)), {}}})}));
    robot.run(time);
    robot.runner.stop();
    bool off = false;
    robot.finish([&](const ActionRecord& record) {
      off = (off || !record.legs[0].on_ground()) && !robot.measurement.contact[0];
      EXPECT_FALSE(off && record.desired.support.contains(0)) << time;
    });
    EXPECT_EQ(robot.record().result.outcome, Outcome::preempted) << time;
    EXPECT_TRUE(robot.record().desired.support.contains(0)) << time;
    EXPECT_NEAR(robot.foot(0).z(), robot.model.foot_radius, 2e-3) << time;
  }
}

// While a leg hands its load over nobody looks at its contact: if it has none, it is not support.
TEST(Stop, WhileALegUnloadsDoesNotMakeItSupportWithoutContact) {
  ScriptedRobot robot(argos());
  robot.runner.submit(steps({step({{footstep(0, robot.foot(0) + forward(0.05)), {}}})}));
  robot.touch[0] = Touch::nothing;
  robot.run(0.036);
  ASSERT_EQ(robot.lane(0).phase, LegPhase::unload);
  robot.runner.stop();
  robot.finish(
      [](const ActionRecord& record) { EXPECT_FALSE(record.desired.support.contains(0)); });
}

TEST(Replace, ChangesTheStepsAfterTheOneUnderWay) {
  ScriptedRobot robot(argos());
  robot.runner.submit(steps({wait(0.2), wait(5.0), wait(5.0)}));
  robot.run(0.1);
  robot.runner.replace({wait(0.1)});
  robot.tick();
  EXPECT_EQ(robot.record().feedback.steps, 2);
  robot.finish();
  EXPECT_NEAR(robot.measurement.time, 0.3, 0.012);
  expect_result(robot.record().result, Outcome::succeeded, Cause::none, 2, -1);
}

// The base was to go on into the next step, which is taken away: it brakes, at no more than
// BaseParams::acceleration (and what pulls it back to the plan), and does not stop dead.
TEST(Replace, LetsABaseBrakeThatWasToGoOn) {
  ScriptedRobot robot(argos());
  Pose X = robot.record().state.X_OB, Y = X;
  X.p.x() += 0.03;
  Y.p.x() += 0.06;
  robot.runner.submit(steps({step(base_target(X)), step(base_target(Y))}));
  robot.run(0.3);
  robot.runner.replace({wait(0.3)});
  double before = robot.record().desired.V_B.v.x(), fastest = before;
  robot.finish([&](const ActionRecord& record) {
    const double now = record.desired.V_B.v.x();
    EXPECT_LT(std::abs(now - before), 1.3 * robot.dt());
    before = now;
    fastest = std::max(fastest, now);
  });
  EXPECT_GT(fastest, 0.03);
  EXPECT_LT(std::abs(before), 1e-3);
}

// 3 cm + 3 cm at 0.05 m/s: over the boundary in the middle with 0.05 m/s, without the dip of a
// single tick; there and back it stops in between.
TEST(BaseOverSteps, GoesOnWithoutAStopExceptWhereItTurnsBack) {
  for (const double second : {0.06, 0.0}) {
    ScriptedRobot robot(argos());
    Pose X = robot.record().state.X_OB, Y = X;
    X.p.x() += 0.03;
    Y.p.x() += second;
    robot.runner.submit(steps({step(base_target(X)), step(base_target(Y))}));
    double slowest = 1.0;
    robot.finish([&](const ActionRecord& record) {
      const double x = record.state.X_OB.p.x();
      if (x > 0.029 && x < 0.031)
        slowest = std::min(slowest, record.desired.V_B.v.head<2>().norm());
    });
    EXPECT_EQ(robot.record().result.outcome, Outcome::succeeded);
    if (second > 0.0) {
      EXPECT_GT(slowest, 0.03);
    }
    if (second == 0.0) {
      EXPECT_LT(slowest, 0.002);
    }
  }
}

// Something that lasts longer than the base's motion: then it has to stop at the end of its own.
TEST(BaseOverSteps, StopsWhereItsStepLastsLonger) {
  ScriptedRobot robot(argos());
  Pose X = robot.record().state.X_OB, Y = X;
  X.p.x() += 0.03;
  Y.p.x() += 0.06;
  action::Step first = step(base_target(X));
  first.wait.duration = 2.0;
  robot.runner.submit(steps({first, step(base_target(Y))}));
  robot.finish([&](const ActionRecord& record) {
    if (record.feedback.step == 1) {
      EXPECT_LT(record.state.X_OB.p.x(), 0.0305);
    }
    if (record.feedback.step == 1 && robot.measurement.time > 1.0) {
      EXPECT_LT(record.desired.V_B.v.norm(), 2e-3);
    }
  });
}

// Velocities ramp down within 0.2 s and up again; no joint's velocity jumps.
TEST(Pause, StopsAndGoesOnSmoothly) {
  ScriptedRobot robot(argos());
  Pose X = robot.record().state.X_OB;
  X.p.x() += 0.05;
  robot.runner.submit(steps({step(base_target(X))}));
  robot.run(0.4);
  const double speed = robot.record().desired.V_B.v.norm();
  robot.runner.pause();
  double before = speed;
  const auto smooth = [&](double seconds) {
    for (int k = 0; k < static_cast<int>(seconds / robot.dt()); ++k) {
      const double now = robot.tick().desired.V_B.v.norm();
      EXPECT_LT(std::abs(now - before), 1.5 * speed * robot.dt() / 0.2);
      before = now;
    }
  };
  smooth(0.3);
  EXPECT_LT(before, 2e-3);
  EXPECT_EQ(robot.record().feedback.status, ActionStatus::paused);
  robot.runner.resume();
  smooth(0.25);
  EXPECT_GT(before, 0.03);
  robot.finish();
  EXPECT_EQ(robot.record().result.outcome, Outcome::succeeded);
}

// Legs 0, 2, 4 (all of the left side) carry the robot's mass no more.
TEST(Refusal, OfAStepThatWouldTipTheRobot) {
  ScriptedRobot robot(argos());
  const Vector3 up(0.0, 0.0, 0.05);
  robot.runner.submit(steps({wait(0.1), step({{foot_target(0, robot.foot(0) + up), {}},
                                              {foot_target(2, robot.foot(2) + up), {}},
                                              {foot_target(4, robot.foot(4) + up), {}}})}));
  robot.finish();
  expect_result(robot.record().result, Outcome::failed, Cause::unstable, 2, 0);
  EXPECT_EQ(robot.record().desired.support, LegSet::all(6));
  expect_at_rest(robot);
}

TEST(Refusal, OfFeetThatNoBaseReaches) {
  ScriptedRobot robot(argos());
  robot.runner.submit(steps(
      {step(action::BaseAuto{}, {{footstep(3, robot.foot(3) + Vector3(0.0, -3.0, 0.0)), {}}})}));
  robot.finish();
  EXPECT_EQ(robot.record().result.outcome, Outcome::failed);
  EXPECT_EQ(robot.record().result.cause, Cause::out_of_reach);
  expect_at_rest(robot);
}

// A height that the legs don't have is not what the next BaseAuto keeps.
TEST(BaseAutoHeight, IsThatOfTheLastOneAsFarAsItCouldBe) {
  ScriptedRobot robot(argos());
  for (const double height : {0.35, 3.0}) {
    robot.runner.submit(steps({step(testing::base_auto(height)), step(action::BaseAuto{})}));
    double first = 0.0;
    robot.finish([&](const ActionRecord& record) {
      if (record.feedback.step == 1) first = record.state.X_OB.p.z();
    });
    EXPECT_EQ(robot.record().result.outcome, Outcome::succeeded);
    EXPECT_NEAR(robot.record().state.X_OB.p.z(), first, 5e-3);
    if (height < 1.0) {
      EXPECT_NEAR(first, height + robot.model.foot_radius, 2e-3);
    }
  }
}

TEST(Reach, OfAFootThatGoesBeyondFailsTheAction) {
  ScriptedRobot robot(argos());
  robot.runner.submit(steps({step({{foot_target(1, robot.foot(1) + forward(2.0)), {}}})}));
  robot.finish();
  expect_result(robot.record().result, Outcome::failed, Cause::out_of_reach, 1, 1);
  expect_at_rest(robot);
}

// A jump of the localisation moves nothing of a step that is under way; the next one is in the new
// place.
TEST(MapJump, CountsFromTheNextStepOn) {
  ScriptedRobot robot(argos());
  const Vector3 target = robot.foot(0) + forward(0.05);
  robot.runner.submit(
      steps({step({{footstep(0, target, kMap), {}}}), step({{footstep(0, target, kMap), {}}})}));
  Vector3 first = Vector3::Zero();
  robot.run(0.2);
  robot.runner.frames().X_OM.p = {0.0, 0.03, 0.0};
  robot.finish([&](const ActionRecord& record) {
    if (record.feedback.step == 1) first = robot.foot(0);
  });
  EXPECT_LT((first - target).head<2>().norm(), 2e-3);
  EXPECT_LT((robot.foot(0) - target - Vector3(0, 0.03, 0)).head<2>().norm(), 3e-3);
}

// What is given in the base keeps its place in the base while that moves.
TEST(BaseFrame, TargetsMoveAlongWithTheBase) {
  ScriptedRobot robot(argos());
  Pose X = robot.record().state.X_OB;
  const Vector3 target = robot.lane(0).p_BF + Vector3(0.0, 0.0, 0.1);
  X.p.x() += 0.05;
  robot.runner.submit(steps({step(base_target(X), {{foot_target(0, target, kBase), {}}})}));
  robot.finish();
  EXPECT_EQ(robot.record().result.outcome, Outcome::succeeded);
  EXPECT_NEAR(robot.record().state.X_OB.p.x(), X.p.x(), 3e-3);
  EXPECT_LT((robot.lane(0).p_BF - target).norm(), 1e-4);
}

TEST(CustomCommand, CallsTheHandlerWhenItsStepStarts) {
  ScriptedRobot robot(argos());
  std::string heard;
  const auto hear = [](const action::CustomCommand& command, void* context) {
    *static_cast<std::string*>(context) += command.type + ":" + command.command + ";";
  };
  robot.runner.handle_custom(hear, &heard);
  robot.runner.start(robot.measurement);  // forgets actions, but no handler
  action::Step loud;
  loud.custom = {{0, "sound", 0.3, "bark"}};
  robot.runner.submit(steps({wait(0.1), loud, loud}));
  robot.run(0.09);
  EXPECT_EQ(heard, "");
  robot.run(0.1);
  EXPECT_EQ(heard, "sound:bark;");
  robot.finish();
  EXPECT_EQ(heard, "sound:bark;sound:bark;");
  EXPECT_NEAR(robot.measurement.time, 0.7, 0.01);
}

TEST(GivingUp, EndsTheActionWhenThePlantIsLateOrClosed) {
  for (const PlantStatus status : {PlantStatus::late, PlantStatus::closed}) {
    ScriptedRobot robot(argos());
    robot.runner.submit(steps({wait(5.0)}));
    robot.run(0.1);
    for (int k = 0; k < 60; ++k) robot.runner.tick(status, robot.measurement);
    EXPECT_TRUE(robot.runner.idle());
    expect_result(robot.record().result, Outcome::failed, Cause::plant, 1, -1);
    EXPECT_NE(robot.record().fault, Fault::none);
    robot.runner.submit(steps({wait(5.0)}));
    robot.runner.tick(PlantStatus::fresh, robot.measurement);
    EXPECT_TRUE(robot.runner.idle()) << "a fault stays";
  }
}

}  // namespace
}  // namespace hexagait

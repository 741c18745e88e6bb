// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/text/invalid_input.hpp>
#include <testing/action_words.hpp>
#include <testing/argos.hpp>
#include <testing/counted_allocations.hpp>
#include <testing/scripted_robot.hpp>

namespace hexagait {
namespace {

// They keep a pointer to the model: made from a temporary one, they would dangle.
template <class T, class... Params>
constexpr bool kTakesOnlyLastingModels = std::is_constructible_v<T, const RobotModel&, Params...> &&
                                         !std::is_constructible_v<T, RobotModel, Params...> &&
                                         !std::is_constructible_v<T, const RobotModel, Params...>;
static_assert(kTakesOnlyLastingModels<ActionRunner>);
static_assert(kTakesOnlyLastingModels<ActionRunner, RunnerParams>);
static_assert(kTakesOnlyLastingModels<Sequencer, SequencerParams>);
static_assert(kTakesOnlyLastingModels<Executor, ExecutorParams>);
static_assert(kTakesOnlyLastingModels<StateEstimator, SensorMask>);
static_assert(kTakesOnlyLastingModels<Odometry>);

using testing::argos;
using testing::base_target;
using testing::footstep;
using testing::ScriptedRobot;
using testing::step;

// Footsteps, trajectories of foot, joints and base, BaseAuto, targets: all sorts.
action::Action long_action(const ScriptedRobot& robot) {
  const Pose X_OB = robot.record().state.X_OB;
  action::EndEffectorTrajectory foot;
  foot.leg = 1;
  for (int k = 1; k < 8; ++k)
    foot.knots.push_back({0.1 * k, robot.foot(1) + Vector3(0, 0, 0.01 * k * (8 - k)), {}});
  foot.knots.push_back({0.9, robot.foot(1), {}});
  action::JointTrajectory joints;
  joints.leg = 4;
  joints.ignore_contact = true;
  for (int k = 1; k < 6; ++k) {
    JointKnot knot{.time = 0.1 * k};
    knot.q = robot.record().state.q[4] + leg_joints({0.02 * k, -0.05 * k, 0.0});
    joints.knots.push_back(knot);
  }
  action::BaseTrajectory base;
  for (int k = 1; k < 6; ++k)
    base.knots.push_back({0.2 * k, {X_OB.R, X_OB.p + Vector3(0.005 * k, 0, 0.004 * k)}});
  action::Action action;
  action.steps = {
      step(base, {{foot, {}}}),
      step({{joints, {}}}),
      step({{testing::leg_mode(4, true), {}}}),
      step(action::BaseAuto{}, {{footstep(2, robot.foot(2) + Vector3(0.03, 0, 0)), {}}}),
      step(base_target(X_OB)),
      testing::wait(0.1)};
  return action;
}

TEST(ActionRunner, DoesAllSortsOfThings) {
  ScriptedRobot robot(argos());
  robot.runner.submit(long_action(robot));
  robot.finish();
  EXPECT_STREQ(to_string(robot.record().result.outcome), "succeeded")
      << to_string(robot.record().result.cause) << " step " << robot.record().result.step;
}

TEST(ActionRunner, AllocatesInNoTickNotEvenOfACopy) {
  for (const auto controller :
       {WholeBodyController::kinematic, WholeBodyController::virtual_model}) {
    RunnerParams params;
    params.executor.controller = controller;
    ScriptedRobot robot(argos(), params);
    robot.runner.submit(long_action(robot));
    robot.run(0.2);
    ActionRunner copy = robot.runner;
    Measurement measurement = robot.measurement;
    const long before = testing::allocations;
    for (int k = 0; k < 3000; ++k) {
      robot.tick();
      measurement.time += robot.dt();
      measurement.q = copy.record().desired.targets.q;
      copy.tick(PlantStatus::fresh, measurement);
    }
    const long after = testing::allocations;
    EXPECT_EQ(after, before);
    EXPECT_TRUE(robot.runner.idle());
    EXPECT_EQ(robot.record().result.outcome, Outcome::succeeded);
  }
}

// A copy that is fed what the original was does what it did, bit for bit, from any moment on.
TEST(ActionRunner, IsAValueThatCanBePlayedAhead) {
  ScriptedRobot robot(argos());
  robot.runner.submit(long_action(robot));
  for (int part = 0; part < 4; ++part) {
    robot.run(0.37);
    ActionRunner copy = robot.runner;
    std::vector<Measurement> measured;
    std::vector<JointTargets> ahead;
    for (int k = 0; k < 400; ++k) {
      ahead.push_back(robot.tick().desired.targets);
      measured.push_back(robot.measurement);
    }
    for (std::size_t k = 0; k < measured.size(); ++k) {
      const JointTargets& now = copy.tick(PlantStatus::fresh, measured[k]).desired.targets;
      for (LegId i = 0; i < 6; ++i) {
        ASSERT_EQ(now.q[i], ahead[k].q[i]);
        ASSERT_EQ(now.effort[i], ahead[k].effort[i]);
      }
    }
  }
}

TEST(ActionRunner, RefusesToStartWithoutJointPositionsAndGoesOnAsBefore) {
  ScriptedRobot robot(argos());
  robot.runner.submit({});
  Measurement none = robot.measurement;
  none.q = LegArray<LegJoints>(3, LegJoints::Zero());
  EXPECT_THROW(robot.runner.start(none), InvalidInput);
  robot.tick();
  EXPECT_EQ(robot.record().result.outcome, Outcome::succeeded);
}

// The plan slows down as in a pause, and speeds up again.
TEST(ActionRunner, SlowsDownWhileThePlantIsLate) {
  ScriptedRobot robot(argos());
  Pose X = robot.record().state.X_OB;
  X.p.x() += 0.03;
  robot.runner.submit({"", "", {}, {step(base_target(X))}});
  robot.run(0.3);
  double speed = robot.record().desired.targets.qd[0].norm();
  const double first = speed;
  ASSERT_GT(first, 0.01);
  for (int k = 0; k < 45; ++k) {
    robot.runner.tick(PlantStatus::late, robot.measurement);
    const double now = robot.record().desired.targets.qd[0].norm();
    ASSERT_NEAR(now, speed, 0.05 * first) << "not at once";
    speed = now;
  }
  EXPECT_TRUE(robot.record().holding);
  EXPECT_LT(speed, 0.8 * first);
  robot.measurement.q = robot.record().desired.targets.q;
  robot.finish();
  EXPECT_EQ(robot.record().result.outcome, Outcome::succeeded);
  EXPECT_NEAR(robot.record().state.X_OB.p.x(), X.p.x(), 3e-3);
}

TEST(ActionRunner, EndsAtAnEmergencyStop) {
  ScriptedRobot robot(argos());
  robot.runner.submit({"", "", {}, {testing::wait(5.0)}});
  robot.run(0.1);
  robot.runner.emergency_stop();
  robot.tick();
  EXPECT_TRUE(robot.runner.idle());
  EXPECT_EQ(robot.record().result.cause, Cause::plant);
  EXPECT_EQ(robot.record().fault, Fault::emergency_stop);
}

TEST(ActionRunner, HoldsTheRobotWhereItIsBeforeItIsStarted) {
  ScriptedRobot robot(argos());
  ActionRunner runner(argos());
  const ActionRecord& record = runner.tick(PlantStatus::fresh, robot.measurement);
  EXPECT_EQ(record.fault, Fault::not_started);
  ASSERT_EQ(record.desired.targets.q.size(), 6);
  for (LegId i = 0; i < 6; ++i) {
    EXPECT_EQ(record.desired.targets.q[i], robot.measurement.q[i]);
    EXPECT_EQ(record.desired.targets.qd[i].norm(), 0.0);
  }
  runner.start(robot.measurement);
  EXPECT_EQ(runner.tick(PlantStatus::fresh, robot.measurement).fault, Fault::none);
}

TEST(ActionRunner, RefusesAControlPeriodOutOfRange) {
  for (const double dt : {0.0, -0.01, 0.0009, 0.021, std::nan("")}) {
    RunnerParams params;
    params.control_dt = dt;
    try {
      const ActionRunner runner(argos(), params);
      ADD_FAILURE() << dt;
    } catch (const InvalidInput& error) {
      EXPECT_NE(std::string(error.what()).find("control_dt [s]: is"), std::string::npos);
      EXPECT_NE(std::string(error.what()).find("1 to 20 ms"), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace hexagait

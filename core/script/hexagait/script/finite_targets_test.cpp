// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdlib>
#include <hexagait/urdf/urdf.hpp>
#include <limits>
#include <testing/action_words.hpp>
#include <testing/argos.hpp>
#include <testing/poisoned_actions.hpp>
#include <testing/random_actions.hpp>
#include <testing/scripted_robot.hpp>
#include <testing/source_path.hpp>

// Targets are finite and within the joints' limits whatever numbers a program gives.

namespace hexagait {
namespace {

using testing::ActionSpec;
using testing::NumbersOf;
using testing::ScriptedRobot;
using testing::step;
using testing::steps;
using testing::operator<<;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kAbsurd[] = {kNaN,  kInfinity, -kInfinity, 1e308, -1e200, 1e100,
                              -1e30, 1e13,      1e-300,     -1e-9, 0.0,    -1.0};

const RobotModel& robot(int index) {
  static const RobotModel robots[] = {testing::argos(),
                                      load_urdf(testing::source_path("robots/hexapod_4dof.urdf"))};
  return robots[index];
}

bool good(const RobotModel& model, const JointTargets& targets, const JointTargets& before,
          double dt) {
  bool good = true;
  for (LegId i = 0; i < model.num_legs(); ++i) {
    good = good && within_limits(model.legs[i], targets.q[i]);
    for (int k = 0; k < model.legs[i].num_joints(); ++k) {
      const JointLimits& limits = model.legs[i].limits[k];
      const double change = std::abs(targets.q[i][k] - before.q[i][k]);
      good = good && std::abs(targets.qd[i][k]) <= limits.velocity * (1.0 + 1e-9) &&
             std::abs(targets.effort[i][k]) <= limits.effort &&
             (change <= limits.velocity * dt * (1.0 + 1e-9) || before.mode[i] != targets.mode[i]);
    }
  }
  return good;
}

/// One number of an action, or of the frames in which it is given, becomes absurd.
struct Poison {
  int robot = 0, where = 0, what = 0, controller = 0;
  ActionSpec action;
};
std::ostream& operator<<(std::ostream& os, const Poison& p) {
  return os << '{' << p.robot << ',' << p.where << ',' << p.what << ',' << p.controller << ','
            << p.action << '}';
}

void play(const Poison& poison) {
  const RobotModel& model = robot(poison.robot);
  RunnerParams params;
  if (poison.controller == 0) params.executor.controller = WholeBodyController::virtual_model;
  ScriptedRobot scene(model, params);
  Frames& frames = scene.runner.frames();
  frames.registered[kFirstRegistered] = {kBase, {rotation_z(0.2), Vector3::Zero()}};

  action::Action action = testing::ActionWriter(model).action(poison.action);
  NumbersOf numbers(action);
  numbers.add(frames.X_OM);
  numbers.add(frames.registered[kFirstRegistered].X_PA);
  numbers.add(frames.registered[kFirstRegistered + 1].X_PA);
  numbers[static_cast<std::size_t>(poison.where) % numbers.size()] = kAbsurd[poison.what];
  scene.runner.submit(action);
  for (int k = 0; k < 1000 && !scene.runner.idle(); ++k) {
    const JointTargets before = scene.record().desired.targets;
    scene.tick();
    RC_ASSERT(good(model, scene.record().desired.targets, before, scene.dt()));
  }
  const ActionRecord& end = scene.record();
  RC_ASSERT(end.fault == Fault::none || end.fault == Fault::bad_command);
  RC_CLASSIFY(end.result.cause == Cause::not_finite, "not finite");
  RC_CLASSIFY(end.fault == Fault::bad_command, "bad command");
}

TEST(FiniteTargets, WhateverNumberOfAnActionIsAbsurd) {
  setenv("RC_PARAMS", "seed=20 max_success=300 max_size=100", 0);
  using rc::gen::inRange;
  const auto poisons = rc::gen::construct<Poison>(inRange(0, 2), inRange(0, 10'000),
                                                  inRange(0, static_cast<int>(std::size(kAbsurd))),
                                                  inRange(0, 4), testing::action_specs());
  const bool kept = rc::check([&] {
    const Poison poison = *rc::gen::resize(100, poisons).as("poison");
    play(poison);
  });
  EXPECT_TRUE(kept);
}

// The step isn't executed: the robot stands as before, and what comes next works.
TEST(NotFinite, FailsTheActionAndNamesTheLeg) {
  ScriptedRobot scene(robot(0));
  action::EndEffectorTarget target = testing::foot_target(2, scene.foot(2));
  target.target.p.x() = kNaN;
  scene.runner.submit(steps({step({{testing::leg_mode(3, true), {}}, {target, {}}})}));
  EXPECT_EQ(scene.finish().cause, Cause::not_finite);
  EXPECT_EQ(scene.record().result.leg, 2);
  EXPECT_EQ(scene.record().fault, Fault::none);
  scene.runner.submit(steps({step(testing::base_auto(0.32))}));
  EXPECT_EQ(scene.finish().outcome, Outcome::succeeded);
}

// A localisation that gives NaN: of the map, only what is given in it fails.
TEST(NotFinite, FailsWhatIsGivenInAFrameWithoutAPose) {
  ScriptedRobot scene(robot(0));
  scene.runner.frames().X_OM.p.y() = kNaN;
  scene.runner.submit(steps({step(testing::base_target(scene.record().state.X_OB, kMap))}));
  EXPECT_EQ(scene.finish().cause, Cause::not_finite);
  scene.runner.submit(steps({step(testing::base_target(scene.record().state.X_OB, kOdom))}));
  EXPECT_EQ(scene.finish().outcome, Outcome::succeeded);
}

// A height that is none is not the height of the BaseAutos after it.
TEST(NotFinite, HeightsAreForgotten) {
  ScriptedRobot scene(robot(0));
  scene.runner.submit(steps({step(testing::base_auto(kNaN))}));
  EXPECT_EQ(scene.finish().cause, Cause::not_finite);
  scene.runner.submit(steps({step(action::BaseAuto{})}));
  EXPECT_EQ(scene.finish().outcome, Outcome::succeeded);
}

// Nobody checks parameters in a tick: with a spring of NaN the efforts are none. It holds by
// position where it is, with a name, until it is started again.
TEST(BadCommand, HoldsTheLastGoodTargets) {
  RunnerParams params;
  params.executor.controller = WholeBodyController::virtual_model;
  params.executor.virtual_model.frequency = kNaN;
  ScriptedRobot scene(robot(0), params);
  const LegArray<LegJoints> q = scene.record().desired.targets.q;
  scene.runner.submit(steps({testing::wait(1.0)}));
  for (int k = 0; k < 5; ++k) {
    scene.tick();
    EXPECT_EQ(scene.record().fault, Fault::bad_command);
    EXPECT_STREQ(to_string(scene.record().fault), "bad command");
    EXPECT_EQ(scene.record().result.cause, Cause::plant);
    const JointTargets& targets = scene.record().desired.targets;
    for (LegId i = 0; i < 6; ++i) {
      EXPECT_LT((targets.q[i] - q[i]).norm(), 1e-9);
      EXPECT_EQ(targets.qd[i].norm(), 0.0);
      EXPECT_TRUE(targets.effort[i].allFinite());
      EXPECT_EQ(targets.mode[i], ControlMode::position);
    }
  }
}

}  // namespace
}  // namespace hexagait

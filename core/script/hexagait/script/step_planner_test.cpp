// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/script/fill_in.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <testing/action_words.hpp>
#include <testing/round_params.hpp>
#include <testing/scripted_robot.hpp>
#include <testing/source_path.hpp>

namespace hexagait::step_planner_test {
namespace {

using testing::base_target;
using testing::foot_target;
using testing::footstep;
using testing::leg_mode;
using testing::ScriptedRobot;
using testing::step;
using testing::wait;

constexpr double kUnload = 0.04;  // SwingParams::unload_time

// What BaseAuto asked of its strategy last, which leaves the base where it is, and how often.
StanceProblem asked;
int times_asked = 0;
StancePose stay(const RobotModel&, const StanceProblem& problem) {
  asked = problem;
  ++times_asked;
  StancePose stance;
  stance.X_OB = problem.X_OB;
  return stance;
}

struct Scene {
  ScriptedRobot robot;
  Frames frames;
  StepFrames step_frames;
  StepPlanner planner;
  Executor executor;

  explicit Scene(const char* name = "argos.urdf")
      : robot(load_urdf(testing::source_path("robots/" + std::string(name)))),
        planner(robot.model, {.stance = stay, .script = testing::round_params().script}),
        executor(robot.runner.executor()) {
    planner.reserve({}, executor);
  }
  const StepPlan& plan(const action::Step& step, const action::Step* next = nullptr) {
    action::Action action;
    action.steps = {step};
    if (next) action.steps.push_back(*next);
    fill_in(action.steps, testing::round_params().script);
    planner.reserve(action, executor);
    return planner.plan(action.steps[0], next ? &action.steps[1] : nullptr,
                        {robot.model, executor, state(), frames, step_frames});
  }
  const RobotState& state() const { return robot.record().state; }
  Pose moved(double x, double yaw = 0.0) const {
    const Pose& X = state().X_OB;
    return {X.R * rotation_z(yaw), X.p + Vector3(x, 0, 0)};
  }
};

// Way over average speed, but not less than the minimum; a leg that stands unloads first.
TEST(Durations, ComeFromRates) {
  Scene scene;
  const Vector3 p = scene.robot.foot(0);
  EXPECT_NEAR(scene.plan(step({{foot_target(0, p + Vector3(0, 0, 0.15)), {}}})).duration,
              0.15 / 0.3 + kUnload, 1e-9);
  EXPECT_NEAR(scene.plan(step({{foot_target(0, p), {}}})).duration, 0.05 + kUnload, 1e-9);
  EXPECT_NEAR(scene.plan(step({{footstep(0, p), {}}})).duration, 0.45 + kUnload, 1e-9);
  EXPECT_NEAR(scene.plan(step(base_target(scene.moved(0.1)))).duration, 0.1 / 0.05, 1e-9);
  EXPECT_NEAR(scene.plan(step(base_target(scene.moved(0.1, 0.3)))).duration, 0.3 / 0.1, 1e-9);
  EXPECT_NEAR(scene.plan(step(base_target(scene.moved(0.0)))).duration, 0.7, 1e-9);
  EXPECT_NEAR(scene.plan(wait(1.5)).duration, 1.5, 1e-12);
  EXPECT_NEAR(scene.plan(step({{leg_mode(3, false, 0.3), {}}})).duration, 0.3 + kUnload, 1e-12);

  action::JointTarget joints;
  joints.target.q = scene.state().q[2] + leg_joints({0.1, -0.6, 0.3});
  joints.leg = 2;
  joints.average_velocity = 0.5;
  EXPECT_NEAR(scene.plan(step({{joints, {}}})).duration, 0.6 / 0.5 + kUnload, 1e-9);
}

// The base takes 2 s, the foot 0.5 s: it is given the rest. And the other way round.
TEST(Durations, OfBaseAndLegsWaitForEachOther) {
  Scene scene;
  action::EndEffectorTarget up = foot_target(0, scene.robot.foot(0) + Vector3(0, 0, 0.15));
  const StepPlan& plan = scene.plan(step(base_target(scene.moved(0.1)), {{up, {}}}));
  EXPECT_NEAR(plan.legs[0].duration, 2.0 - kUnload, 1e-9);
  EXPECT_NEAR(plan.base.curve.duration(), 2.0, 1e-9);
  EXPECT_NEAR(plan.duration, 2.0, 1e-9);

  up.average_velocity = 0.05;
  EXPECT_NEAR(scene.plan(step(base_target(scene.moved(0.1)), {{up, {}}})).base.curve.duration(),
              3.0 + kUnload, 1e-9);

  action::BaseTarget hurries = base_target(scene.moved(0.1));
  hurries.ignore_timing_of_leg_motion = true;
  EXPECT_NEAR(scene.plan(step(hurries, {{up, {}}})).base.curve.duration(), 2.0, 1e-9);
  EXPECT_NEAR(plan.legs[0].duration, 3.0, 1e-9);
}

TEST(Durations, OfTrajectoriesAreTheirOwn) {
  Scene scene;
  action::EndEffectorTrajectory trajectory;
  trajectory.knots = {{0.3, scene.robot.foot(0) + Vector3(0, 0, 0.1), {}}};
  const StepPlan& plan = scene.plan(step(base_target(scene.moved(0.1)), {{trajectory, {}}}));
  EXPECT_NEAR(plan.legs[0].duration, 0.3, 1e-9);
  EXPECT_NEAR(plan.duration, 2.0, 1e-9);
}

// A velocity without a position, in a step that the base makes longer: the joint goes on as fast as
// it was asked to, it does not swing to and fro.
TEST(JointTarget, ByVelocityGoesOnAllTheTime) {
  Scene scene;
  action::JointTarget joints;
  joints.leg = 1;
  joints.ignore_contact = true;
  joints.target.qd = leg_joints({0.2, 0.0, 0.0});
  const StepPlan& plan = scene.plan(step(base_target(scene.moved(0.1)), {{joints, {}}}));
  EXPECT_EQ(plan.legs[1].mode, ControlMode::velocity);
  const double T = plan.legs[1].duration;
  double before = plan.legs[1].joints.at(0.0).q[0];
  for (double t = 0.05; t < T; t += 0.05) {
    const JointState now = plan.legs[1].joints.at(t);
    EXPECT_GE(now.q[0], before - 1e-9);
    EXPECT_LT(now.qd[0], 0.21);
    before = now.q[0];
  }
  EXPECT_NEAR(plan.legs[1].joints.at(T).qd[0], 0.2, 1e-9);
}

TEST(LegMode, OfALegThatStandsAlreadyGivesNothingToDo) {
  Scene scene;
  const StepPlan& plan = scene.plan(step({{leg_mode(1, true), {}}, {leg_mode(4, false), {}}}));
  EXPECT_EQ(plan.moving, LegSet(0b010010));
  EXPECT_EQ(plan.commanded, LegSet(0b010000));
  EXPECT_FALSE(plan.legs[4].lands);
}

TEST(BaseAuto, IsAskedForTheFeetAsTheyWillBe) {
  Scene scene;
  const Vector3 target = scene.robot.foot(0) + Vector3(0.05, 0.02, 0.0);
  action::Footstep ignored = footstep(3, target);
  ignored.ignore_for_pose_adaptation = true;
  (void)scene.plan(step(testing::base_auto(0.37), {{footstep(0, target), {}}, {ignored, {}}}));
  EXPECT_LT((asked.p_OF[0] - target).norm(), 1e-9);
  EXPECT_LT((asked.p_OF[1] - scene.robot.foot(1)).norm(), 1e-9);
  EXPECT_EQ(asked.reach, LegSet(0b110111));
  EXPECT_EQ(asked.support, LegSet(0b110110));
  EXPECT_EQ(asked.height, 0.37);
  EXPECT_EQ(asked.margin, 0.04);
}

// A step without leg motions prepares for those of the next: they carry no more. A step of its own
// that moves legs doesn't.
TEST(BaseAuto, PreparesForTheLegsOfTheNextStep) {
  Scene scene;
  const action::Step next = step({{footstep(5, scene.robot.foot(5)), {}}});
  (void)scene.plan(step(action::BaseAuto{}), &next);
  EXPECT_EQ(asked.support, LegSet(0b011111));
  EXPECT_EQ(asked.reach, LegSet::all(6)) << "it stands there still";
  (void)scene.plan(step(action::BaseAuto{}, {{footstep(0, scene.robot.foot(0)), {}}}), &next);
  EXPECT_EQ(asked.support, LegSet(0b111110));
}

// Whether the base moves on depends on where the next step wants it: where it is then already, if it
// stands on the same legs, as high and as safely.
TEST(BaseAuto, IsAskedOnceIfTheNextStepWantsTheSame) {
  Scene scene;
  const action::BaseAuto now = testing::base_auto(0.31);
  const auto times = [&](const action::BaseAuto& next,
                         const std::vector<action::LegCommand>& legs = {}) {
    const action::Step then = step(next, legs);
    times_asked = 0;
    (void)scene.plan(step(now), &then);
    return times_asked;
  };
  EXPECT_EQ(times(now), 1);
  EXPECT_EQ(times(now, {{footstep(5, scene.robot.foot(5)), {}}}), 1) << "which it prepares for";
  EXPECT_EQ(times(testing::base_auto(0.33)), 2);
  action::BaseAuto safer = now;
  safer.support_margin = 0.05;
  EXPECT_EQ(times(safer), 2);
  action::Footstep ignored = footstep(3, scene.robot.foot(3));
  ignored.ignore_for_pose_adaptation = true;
  EXPECT_EQ(times(now, {{ignored, {}}}), 2) << "one foot less to reach";
}

// Neither given nor known before: as high as it stands. The last one's afterwards.
TEST(BaseAuto, TakesTheHeightOfTheLastOne) {
  Scene scene;
  (void)scene.plan(step(action::BaseAuto{}));
  EXPECT_NEAR(asked.height, -scene.robot.model.legs[0].p_BC.z(), 1e-9);
  (void)scene.plan(step(testing::base_auto(0.31)));
  (void)scene.plan(step(action::BaseAuto{}));
  EXPECT_NEAR(asked.height, 0.31, 1e-12);
}

// Four legs without one, and the centre of mass in the middle, on the edge of the other three; from
// two of them it falls.
TEST(Stability, IsAskedBeforeLegsAreLifted) {
  Scene scene("quadruped.urdf");
  const auto up = [&scene](LegId leg) {
    return action::LegCommand{foot_target(leg, scene.robot.foot(leg) + Vector3(0, 0, 0.1)), {}};
  };
  EXPECT_EQ(scene.plan(step({up(0), up(1)})).cause, Cause::unstable);
  EXPECT_EQ(scene.plan(step({up(0), up(1)})).leg, 0);
  EXPECT_EQ(scene.plan(step({{leg_mode(0, true), {}}})).cause, Cause::none);
  EXPECT_EQ(scene.plan(step({up(0), up(1), up(2), up(3)})).cause, Cause::none)
      << "the body lies on something else";
}

TEST(BaseTarget, InTheBaseIsMeantFromWhereTheBaseIs) {
  Scene scene;
  const StepPlan& plan = scene.plan(step(base_target({rotation_z(0.1), {0.05, 0, 0}}, kBase)));
  const Pose end = plan.base.curve.at(plan.base.curve.duration()).X_AB;
  EXPECT_LT((end.p - scene.moved(0.05).p).norm(), 1e-9);
  EXPECT_NEAR(roll_pitch_yaw(end.R).z(), 0.1, 1e-9);
}

}  // namespace
}  // namespace hexagait::step_planner_test

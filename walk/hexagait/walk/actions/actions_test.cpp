// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The actions of actions/, one after the other, in physics.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <hexagait/load/load_action.hpp>
#include <hexagait/script/preview.hpp>
#include <hexagait/sim/random.hpp>
#include <hexagait/sim3d/world.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <hexagait/walk/actions/action_trial.hpp>
#include <hexagait/walk/start_posture.hpp>
#include <testing/source_path.hpp>

namespace hexagait::walk::actions_test {
namespace {

namespace fs = std::filesystem;

const fs::path kActions = testing::source_path("actions");

const RobotModel& robot(const std::string& name) {
  static std::map<std::string, RobotModel> models;
  if (!models.contains(name))
    models[name] = load_urdf(testing::source_path("robots/" + name + ".urdf"));
  return models[name];
}

struct Case {
  std::string action;
  std::string robot = "argos";
  StartKind start = StartKind::standing;
  const char* terrain = "flat";
  bool lies_down = false;
  bool stands_at_end = true;
  double least_margin = 0.1;  ///< by the truth [m]
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.action; }

action::Action load(const Case& c, const std::map<std::string, std::string>& placeholders = {}) {
  action::ActionVocabulary vocabulary;
  vocabulary.placeholders = placeholders;
  return action::load_action(kActions / (c.action + ".yaml"), robot(c.robot), vocabulary);
}

ActionSummary run(const Case& c, const action::Action& action, std::uint64_t seed = 1,
                  const ActionObserver& observer = {}, const RunnerParams& runner_params = {}) {
  const RobotModel& model = robot(c.robot);
  const StartPosture posture = start_posture(model, c.start, seed);
  sim3d::WorldParams params;
  params.start_height = posture.height;
  params.control_dt = runner_params.control_dt;
  sim3d::World world(model, sim3d::parse_terrain(c.terrain), params, posture.q);
  ActionRunner runner(model, runner_params);
  ActionTrialOptions options;
  options.rests_on = posture.rests_on;
  return run_action(runner, world, world.truth(), action, options, observer);
}

const Case kCases[] = {
    {.action = "body_circle"},
    {.action = "height"},
    {.action = "legs_x_to_o"},
    {.action = "look_around"},
    {.action = "nod"},
    {.action = "paw"},
    {.action = "push_up", .robot = "quadruped", .least_margin = 0.03},
    {.action = "push_up", .robot = "quadruped_rpp", .least_margin = 0.03},
    {.action = "push_up_six"},
    {.action = "push_up_six", .robot = "hexapod_4dof"},
    {.action = "recovery", .lies_down = true},
    {.action = "ripple"},
    {.action = "sit_down", .lies_down = true, .stands_at_end = false},
    {.action = "square_up"},
    {.action = "stand_up", .start = StartKind::sitting},
    {.action = "step_climb", .terrain = "step:12cm"},
    {.action = "transport", .lies_down = true, .stands_at_end = false},
    {.action = "tripod"},
    {.action = "wave"},
};

// The action, and the robot where it isn't the one that it was written for.
std::string name_of(const Case& c) {
  const bool serial = c.robot == "hexapod_4dof" || c.robot == "quadruped_rpp";
  return serial ? c.action + "_on_" + c.robot : c.action;
}

class Actions : public ::testing::TestWithParam<Case> {};

INSTANTIATE_TEST_SUITE_P(All, Actions, ::testing::ValuesIn(kCases),
                         [](const auto& info) { return name_of(info.param); });

TEST(ActionFiles, AreAllTested) {
  for (const fs::directory_entry& file : fs::directory_iterator(kActions)) {
    const auto is_it = [&](const Case& c) { return c.action + ".yaml" == file.path().filename(); };
    EXPECT_GE(std::ranges::count_if(kCases, is_it), 1) << file.path();
  }
}

Preview ahead_of(const Case& c, const action::Action& action, const RunnerParams& runner = {}) {
  const StartPosture posture = start_posture(robot(c.robot), c.start);
  PreviewParams params;
  params.runner = runner;
  params.rests_on = posture.rests_on;
  return preview(robot(c.robot), posture.q, action, params);
}

// The preview's time is the true one but for feet that come to the ground a little sooner or later,
// and `late` that it is known later.
void expect_as_previewed(const Case& c, const ActionSummary& summary, const Preview& ahead,
                         bool margin = true, double late = 0.0) {
  EXPECT_EQ(summary.result.outcome, Outcome::succeeded) << to_string(summary.result.cause);
  EXPECT_FALSE(summary.fell);
  EXPECT_FALSE(summary.leg_touched);
  EXPECT_EQ(summary.base_touched, c.lies_down);
  EXPECT_EQ(summary.stands_at_end, c.stands_at_end);
  if (margin) {
    EXPECT_GT(summary.margin_min, c.least_margin);
  }
  EXPECT_NEAR(summary.seconds, ahead.seconds, 0.03 * ahead.seconds + 0.02 + late);
}

// Checked ahead nothing is found.
TEST_P(Actions, AreCarriedOutAsPreviewed) {
  const action::Action action = load(GetParam());
  const Preview ahead = ahead_of(GetParam(), action);
  for (const Finding& finding : ahead.findings) ADD_FAILURE() << in_words(finding, action.source);
  expect_as_previewed(GetParam(), run(GetParam(), action), ahead);
}

// The same actions at 100 and at 50 Hz, the physics at 500 Hz as ever. Contact is known up to two
// periods late. The fourth foot of a quadruped that comes down at 0.2 m/s presses until then and
// lifts two others: for moments the body rests on a diagonal, and what counts is that it hardly
// tilts: by 8 mm at 50 Hz, over the 0.6 m of the other diagonal.
TEST_P(Actions, AreCarriedOutAtAnyControlPeriod) {
  const action::Action action = load(GetParam());
  const bool four_legs = robot(GetParam().robot).num_legs() == 4;
  const double tilt = four_legs ? run(GetParam(), action).tilt_max : 0.0;
  for (const double period : {0.010, 0.020}) {
    SCOPED_TRACE(period);
    RunnerParams params;
    params.control_dt = period;
    const ActionSummary summary = run(GetParam(), action, 1, {}, params);
    // A step ends with the tick in which its last foot is known to stand.
    expect_as_previewed(GetParam(), summary, ahead_of(GetParam(), action, params), !four_legs,
                        static_cast<double>(action.steps.size()) * period);
    if (four_legs) {
      EXPECT_LT(summary.tilt_max, tilt + 0.2 * 2.0 * period / 0.6);
    }
  }
}

// With the other controller the same actions, unchanged ([FG16] IV): the legs that stand are driven
// by torques alone.
TEST_P(Actions, AreCarriedOutByTorquesToo) {
  const action::Action action = load(GetParam());
  RunnerParams params;
  params.executor.controller = WholeBodyController::virtual_model;
  expect_as_previewed(GetParam(), run(GetParam(), action, 1, {}, params),
                      ahead_of(GetParam(), action));
}

// From random joint values, the belly on the ground, to the stance: the origin 0.3 m above the
// centres of feet of 2 cm. The feet are where the stance has them but for their rolling: the tibia
// turns by 0.52 rad as the body rises, 0.02 · 0.52 = 1.0 cm.
class Recovery : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Seeds, Recovery, ::testing::Range(0, 8));

TEST_P(Recovery, BringsTheRobotToItsFeetFromAnyPosture) {
  const Case c{.action = "recovery", .start = StartKind::lying};
  GroundTruth end;
  const auto watch = [&end](const ActionRecord&, const GroundTruth& truth) {
    end = truth;
    return true;
  };
  const ActionSummary summary = run(c, load(c), static_cast<std::uint64_t>(GetParam()), watch);
  EXPECT_TRUE(summary.ok());
  EXPECT_TRUE(summary.stands_at_end);
  EXPECT_NEAR(end.X_WB.p.z(), 0.32, 0.002);
  EXPECT_GT(end.X_WB.R(2, 2), std::cos(0.01));
  for (LegId i = 0; i < 6; ++i) {
    const Vector3 p_BF = end.X_WB.inverse() * end.feet[i].p_WF;
    EXPECT_NEAR((p_BF - robot("argos").legs[i].p_BC).norm(), 0.0, 0.012) << i;
  }
}

// Scripts of gaits: 0.2 m in a cycle, after a first one that starts from a square stance.
TEST(ActionTrial, WalksAStrideInEveryCycle) {
  for (const char* gait : {"tripod", "ripple", "wave"}) {
    const auto distance = [gait](const char* cycles) {
      const Case c{.action = gait};
      double x = 0.0;
      const auto watch = [&x](const ActionRecord&, const GroundTruth& truth) {
        x = truth.X_WB.p.x();
        return true;
      };
      EXPECT_TRUE(run(c, load(c, {{"cycles", cycles}}), 1, watch).ok());
      return x;
    };
    EXPECT_NEAR(distance("3") - distance("2"), 0.2, 0.02) << gait;
  }
}

// "Keeping the right front foot in the air at same position" while the body goes down and up
// ([FG16] IV-A): 0.2 m above the centres of the others, at 0.02 m.
TEST(ActionTrial, KeepsTheFootInItsPlaceInThePushUp) {
  const Case c{.action = "push_up", .robot = "quadruped"};
  double lowest = 1.0, highest = 0.0;
  const auto watch = [&](const ActionRecord& record, const GroundTruth& truth) {
    const int step = record.feedback.step;
    if (step != 3 && step != 4) return true;
    lowest = std::min(lowest, truth.feet[1].p_WF.z());
    highest = std::max(highest, truth.feet[1].p_WF.z());
    return true;
  };
  EXPECT_TRUE(run(c, load(c), 1, watch).ok());
  EXPECT_NEAR(lowest, 0.22, 0.005);
  EXPECT_NEAR(highest, 0.22, 0.005);
}

TEST(ActionTrial, BringsTheBodyUpTheStep) {
  const Case c{.action = "step_climb", .terrain = "step:12cm"};
  double z = 0.0;
  const auto watch = [&z](const ActionRecord&, const GroundTruth& truth) {
    z = truth.X_WB.p.z();
    return true;
  };
  EXPECT_TRUE(run(c, load(c), 1, watch).ok());
  EXPECT_NEAR(z, 0.12 + 0.32, 0.003);
}

// Put down 0.4 m above the ground, a foot searches downwards for 1.5 s at 0.15 m/s: in vain.
TEST(ActionTrial, FailsWhereTheGroundIsNotAsTheScriptHasIt) {
  const Case c{.action = "none"};
  const action::Action action = action::parse_action(
      "steps:\n- step:\n  - footstep: {name: LM, target: {frame: odom, position: [0, 0.53, "
      "0.4]}}\n",
      "test.yaml", robot("argos"));
  const ActionSummary summary = run(c, action);
  EXPECT_EQ(summary.result.outcome, Outcome::failed);
  EXPECT_FALSE(summary.ok());
  EXPECT_FALSE(summary.fell);
}

// Stopped at any time, feet in the air come down, and the robot stands.
TEST(ActionTrial, ComesToAStanceWhenItIsStopped) {
  const RobotModel& model = robot("argos");
  const Case c{.action = "tripod"};
  const action::Action action = load(c);
  RandomSequence random{.seed = 5};
  for (int k = 0; k < 5; ++k) {
    const double when = random.uniform(0.2, 3.5);
    const StartPosture posture = start_posture(model, c.start);
    sim3d::World world(model, {}, {}, posture.q);
    ActionRunner runner(model);
    const ActionSummary summary = run_action(runner, world, world.truth(), action, {},
                                             [&](const ActionRecord&, const GroundTruth& truth) {
                                               if (truth.time > when) runner.stop();
                                               return true;
                                             });
    EXPECT_EQ(summary.result.outcome, Outcome::preempted) << when;
    EXPECT_TRUE(summary.stands_at_end) << when;
    EXPECT_FALSE(summary.fell || summary.base_touched || summary.leg_touched) << when;
    EXPECT_LT(summary.seconds, when + 2.0);
  }
}

TEST(ActionTrial, EndsAtOnceWhenItsObserverSaysSoAndInTime) {
  const Case c{.action = "tripod"};
  const auto until = [](const ActionRecord&, const GroundTruth& truth) { return truth.time < 0.5; };
  const ActionSummary cut = run(c, load(c), 1, until);
  EXPECT_EQ(cut.result.outcome, Outcome::none);
  EXPECT_NEAR(cut.seconds, 0.3, 0.005) << "0.2 s before it the robot comes to rest";

  const RobotModel& model = robot("argos");
  sim3d::World world(model, {}, {}, start_posture(model, c.start).q);
  ActionRunner runner(model);
  const ActionSummary late = run_action(runner, world, world.truth(), load(c), {.seconds = 1.0});
  EXPECT_TRUE(late.out_of_time);
  EXPECT_FALSE(late.ok());
}

TEST(ActionTrial, HasTheSameBitsEveryTime) {
  const Case c{.action = "paw"};
  EXPECT_EQ(run(c, load(c)).state_hash, run(c, load(c)).state_hash);
}

}  // namespace
}  // namespace hexagait::walk::actions_test

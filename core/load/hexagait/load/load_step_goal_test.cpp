// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <hexagait/load/load_step_goal.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <testing/argos.hpp>

namespace hexagait::action::load_step_goal_test {
namespace {

using testing::argos;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

StepGoal parse(const std::string& text) { return parse_step_goal(text, "goal.yaml", argos()); }

std::string refusal(const std::string& text) {
  try {
    (void)parse(text);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

constexpr const char* kProfile = "profile: {target: {frame: odom, position: [1, 2, 3]}}";

std::string swing(const std::string& rest) {
  return "steps: [{step_number: 1, swing_data: [{" + rest + "}]}]";
}

TEST(LoadStepGoal, TakesZeroAndEmptyForTheDefault) {
  const StepGoal goal = parse(
      "steps:\n- step_number: 1\n  swing_data:\n  - name: leftFore\n"
      "    surface_normal: {frame: map, vector: [0, 0, 0]}\n"
      "    profile: {target: {frame: map, position: [1, 2, 3]}, height: 0, duration: 0, type: ''}\n"
      "    trajectory: {frame: map, knots: []}\n"
      "  - name: rightHind\n    surface_normal: {frame: map, vector: [0, 1, 1]}\n"
      "    profile: {target: {frame: map, position: [1, 2, 3]}, height: 0.1, duration: 2, "
      "type: square}\n");
  ASSERT_EQ(goal.action.steps.size(), 1U);
  ASSERT_EQ(goal.action.steps[0].legs.size(), 2U);
  const auto plain = std::get<Footstep>(goal.action.steps[0].legs[0].motion);
  EXPECT_EQ(plain.leg, 0);
  EXPECT_EQ(plain.target.frame, kMap);
  EXPECT_EQ(plain.target.p, Vector3(1, 2, 3));
  EXPECT_TRUE(is_derived(plain.profile_height));
  EXPECT_EQ(plain.profile, SwingProfile::triangle);
  EXPECT_EQ(plain.duration, std::nullopt);
  EXPECT_EQ(plain.surface_normal.frame, kOdom);
  EXPECT_EQ(plain.surface_normal.v, Vector3::UnitZ());
  const auto given = std::get<Footstep>(goal.action.steps[0].legs[1].motion);
  EXPECT_EQ(given.leg, 5);
  EXPECT_EQ(given.profile_height, 0.1);
  EXPECT_EQ(given.profile, SwingProfile::square);
  EXPECT_EQ(given.duration, 2.0);
  EXPECT_EQ(given.surface_normal.frame, kMap);
  EXPECT_EQ(given.surface_normal.v, Vector3(0, 1, 1));
}

TEST(LoadStepGoal, UsesATrajectoryThatContainsDataInsteadOfTheProfile) {
  const StepGoal goal =
      parse(swing("name: LM, trajectory: {frame: base, knots: [{time: 1, position: [1, 2, 3]}]}, " +
                  std::string(kProfile)));
  const auto motion = std::get<EndEffectorTrajectory>(goal.action.steps.at(0).legs.at(0).motion);
  EXPECT_EQ(motion.leg, 2);
  EXPECT_EQ(motion.frame, kBase);
  ASSERT_EQ(motion.knots.size(), 1U);
  EXPECT_EQ(motion.knots[0].p, Vector3(1, 2, 3));
}

// Argos has LF RF LM RM LR RR.
TEST(LoadStepGoal, KnowsTheLegsByTheNamesOfTheDraftAndByTheirOwn) {
  const std::pair<const char*, LegId> names[] = {
      {"leftFore", 0}, {"rightFore", 1}, {"leftMid", 2}, {"rightMid", 3},
      {"leftHind", 4}, {"rightHind", 5}, {"RM", 3}};
  for (const auto& [name, leg] : names) {
    const StepGoal goal = parse(swing("name: " + std::string(name) + ", " + kProfile));
    EXPECT_EQ(leg_motion(goal.action.steps.at(0).legs.at(0)).leg, leg) << name;
  }
}

// Shifts before and after are steps of their own; a duration makes a trajectory of one knot; a
// shift that says nothing is chosen automatically.
TEST(LoadStepGoal, ShiftsTheBaseBeforeWithAndAfterTheSwings) {
  const StepGoal goal = parse(
      "steps:\n- step_number: 1\n  swing_data:\n  - {name: leftFore, " + std::string(kProfile) +
      "}\n  shift_data:\n  - name: post_step\n  - name: step\n    profile:\n"
      "      target: {frame: odom, position: [1, 2, 3], orientation: [0, 0, 0.5]}\n"
      "      duration: 3\n  - name: pre_step\n    profile:\n"
      "      target: {frame: map, position: [1, 2, 3], orientation: [0, 0, 0]}\n"
      "- step_number: 4\n  shift_data: [{name: step}]\n");
  ASSERT_EQ(goal.action.steps.size(), 4U);
  EXPECT_THAT(goal.step_numbers, ElementsAre(1, 1, 1, 4));
  EXPECT_TRUE(goal.action.steps[0].legs.empty() && goal.action.steps[2].legs.empty());
  EXPECT_EQ(goal.action.steps[1].legs.size(), 1U);
  EXPECT_EQ(std::get<BaseTarget>(goal.action.steps[0].base->motion).frame, kMap);
  const auto with = std::get<BaseTrajectory>(goal.action.steps[1].base->motion);
  ASSERT_EQ(with.knots.size(), 1U);
  EXPECT_EQ(with.knots[0].time, 3.0);
  EXPECT_TRUE(with.knots[0].X_AB.R.isApprox(rotation_z(0.5)));
  EXPECT_TRUE(std::holds_alternative<BaseAuto>(goal.action.steps[2].base->motion));
  EXPECT_TRUE(std::holds_alternative<BaseAuto>(goal.action.steps[3].base->motion));
}

TEST(LoadStepGoal, RefusesWhatIsNoGoal) {
  const std::string two = "{name: leftFore, " + std::string(kProfile) + "}";
  const std::pair<std::string, const char*> faults[] = {
      {"", "goal.yaml:1:1: goal: is nothing; it must be a map of steps"},
      {"steps: []", "steps: is empty"},
      {"steps: [{step_number: 1}]", "goal.yaml:1:9: step: is empty"},
      {"steps: [{step_number: 2, shift_data: [{name: step}]}]",
       "goal.yaml:1:23: step_number: is \"2\"; it must be 1 in the first step"},
      {"steps: [{step_number: 1, shift_data: [{name: step}]}, "
       "{step_number: 1, shift_data: [{name: step}]}]",
       "it must be a whole number from 2 to 255, more than that of the step before"},
      {"steps: [{shift_data: [{name: step}]}]", "the key \"step_number\" is missing"},
      {"steps: [{step_number: 1, shift_data: [{name: stop}]}]",
       "unknown name \"stop\"; did you mean \"step\"?"},
      {"steps: [{step_number: 1, shift_data: [{name: step}, {name: step}]}]",
       "shift data step stands in this step already, at 1:39"},
      {"steps: [{step_number: 1, swing_data: [" + two + ", " + two + "]}]",
       "leg LF has swing data in this step already, at 1:39"},
      {swing("name: leftfore, " + std::string(kProfile)), "did you mean \"leftFore\"?"},
      {swing("name: leftFore"), "swing data: the key \"profile\" is missing"},
      {swing("name: leftFore, profile: {height: 0.1}"), "the key \"target\" is missing"},
      {swing("name: leftFore, profile: {target: {frame: odom, position: [1, 2, 3]}, height: -1}"),
       "height: is \"-1\""},
      {swing("name: leftFore, profil: {}"), "did you mean \"profile\"?"}};
  for (const auto& [text, message] : faults) EXPECT_THAT(refusal(text), HasSubstr(message)) << text;
}

}  // namespace
}  // namespace hexagait::action::load_step_goal_test

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/text_file.hpp>
#include <hexagait/viewer/tasks/checked_action.hpp>
#include <testing/argos_walk.hpp>
#include <testing/source_path.hpp>

namespace hexagait::viewer::checked_action_test {
namespace {

using testing::argos;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

CheckedAction checked(const std::string& yaml, bool cancelled = false) {
  const std::atomic<bool> stop = cancelled;
  const auto load = [](const std::string& name) -> RobotModel {
    if (name != "quadruped") throw InvalidInput("there is no robot " + name);
    return load_urdf(hexagait::testing::source_path("robots/quadruped.urdf"));
  };
  return check_action(yaml, {argos(), {}, load}, stop);
}

std::string shared(const std::string& name) {
  return read_text(hexagait::testing::source_path("actions/" + name + ".yaml"), 100'000);
}

TEST(CheckedAction, IsReadAndPlayedAhead) {
  const CheckedAction wave = checked(shared("wave"));
  ASSERT_TRUE(wave.action) << wave.why;
  EXPECT_GT(wave.action->steps.size(), 1U);
  EXPECT_THAT(wave.why, IsEmpty());
}

TEST(CheckedAction, IsRefusedWithTheLinesOfItsErrors) {
  const CheckedAction bad =
      checked("steps:\n- step:\n  - base_auto: {hieght: 0.2}\n- step:\n  - wait: {}\r\n");
  EXPECT_FALSE(bad.action);
  ASSERT_EQ(bad.findings.size(), 2U);
  EXPECT_EQ(bad.findings[0].line, 3);
  EXPECT_EQ(bad.findings[0].column, 17);
  EXPECT_TRUE(bad.findings[0].is_error);
  EXPECT_THAT(bad.findings[0].text, ::testing::StartsWith("unknown key of base_auto \"hieght\""));
  EXPECT_EQ(bad.findings[0].source, "  - base_auto: {hieght: 0.2}");
  EXPECT_EQ(bad.findings[1].line, 5);
  EXPECT_EQ(bad.findings[1].source, "  - wait: {}");
  EXPECT_EQ(bad.why, "2 errors");
}

// It can be read, but the robot can't do it.
TEST(CheckedAction, IsRefusedWithWhatThePreviewFinds) {
  const CheckedAction far = checked(
      "steps:\n- step:\n  - base_target:\n      target: {frame: footprint, position: [0, 0, 3], "
      "orientation: [0, 0, 0]}\n      average_linear_velocity: 1\n");
  EXPECT_FALSE(far.action);
  ASSERT_FALSE(far.findings.empty());
  EXPECT_EQ(far.findings[0].line, 3);
  EXPECT_THAT(far.findings[0].text, HasSubstr("beyond where the leg reaches"));
  EXPECT_THAT(far.findings[0].source, HasSubstr("base_target"));
}

TEST(CheckedAction, IsRefusedIfItIsTooLong) {
  const CheckedAction slow = checked("steps:\n- step:\n  - wait: {duration: 301}\n");
  EXPECT_FALSE(slow.action);
  ASSERT_EQ(slow.findings.size(), 1U);
  EXPECT_THAT(slow.findings[0].text, HasSubstr("has not ended after 300 s"));
}

TEST(CheckedAction, TellsNoMoreFindingsThanAPageShows) {
  std::string yaml = "steps:\n";
  for (int k = 0; k < 300; ++k) yaml += "- step:\n  - wait: {x: 1}\n";
  EXPECT_EQ(checked(yaml).findings.size(), CheckedAction::kMostFindings);
}

// Of the robot that it is written for only the name goes out: whoever loads it decides.
TEST(CheckedAction, OfARobotOfOtherLegsIsRefused) {
  const CheckedAction four = checked(shared("push_up"));
  EXPECT_FALSE(four.action);
  ASSERT_EQ(four.findings.size(), 1U);
  EXPECT_EQ(four.findings[0].line, 0);
  EXPECT_THAT(four.findings[0].text, HasSubstr("quadruped"));
  const CheckedAction none = checked("robot: /etc/passwd\nsteps:\n- step:\n  - base_auto:\n");
  EXPECT_FALSE(none.action);
  EXPECT_THAT(none.findings[0].text, HasSubstr("there is no robot /etc/passwd"));
}

TEST(CheckedAction, ThatIsCancelledHasNoAction) {
  const CheckedAction stopped = checked(shared("wave"), true);
  EXPECT_FALSE(stopped.action);
  EXPECT_THAT(stopped.findings, IsEmpty());
  EXPECT_THAT(stopped.why, HasSubstr("stopped"));
}

// A text of nonsense, and an alias bomb, end in words.
TEST(CheckedAction, IsNotBroughtDownByNonsense) {
  for (const char* const yaml : {"", "\t", "steps: 7", "a: &a [*a]", "{{{{", "\x01\x02"}) {
    const CheckedAction bad = checked(yaml);
    EXPECT_FALSE(bad.action) << yaml;
    EXPECT_FALSE(bad.findings.empty()) << yaml;
  }
  EXPECT_FALSE(checked(std::string(60000, '[')).action);
  std::string bomb = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
  for (int k = 1; k < 9; ++k)
    bomb += fmt::format("a{0}: &a{0} [*a{1}, *a{1}, *a{1}, *a{1}, *a{1}, *a{1}, *a{1}, *a{1}]\n", k,
                        k - 1);
  EXPECT_FALSE(checked(bomb + "steps: *a8\n").action);
}

}  // namespace
}  // namespace hexagait::viewer::checked_action_test

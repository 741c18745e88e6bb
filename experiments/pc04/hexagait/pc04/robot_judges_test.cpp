// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/pc04/robot_judges.hpp>

namespace hexagait::experiments::robot_judges_test {
namespace {

std::vector<bool> holding(const std::vector<Verdict>& verdicts) {
  std::vector<bool> all;
  for (const Verdict& verdict : verdicts) all.push_back(verdict.holds());
  return all;
}

RandomHeadings well_followed() {
  RandomHeadings walk{.summary = {},
                      .size = 0.7,
                      .speed = 0.2,
                      .acceleration = 1.0,
                      .sharpest = 2.8,
                      .longest_pause = 0.6,
                      .step_time = 0.5};
  walk.summary.seconds = 90.0;
  walk.summary.distance = 10.0;
  walk.summary.lateral_mean = 0.005;
  walk.summary.lateral_max = 0.035;
  return walk;
}

TEST(JudgeFig11, WantsThePathFollowedThroughSharpTurns) {
  using Words = std::vector<bool>;
  EXPECT_EQ(holding(judge_fig11(well_followed())), (Words{true, true, true}));
  const auto broken = [](auto change) {
    RandomHeadings walk = well_followed();
    change(walk);
    return holding(judge_fig11(walk));
  };
  EXPECT_EQ(broken([](auto& w) { w.summary.fell = true; }), (Words{false, true, false}));
  EXPECT_FALSE(broken([](auto& w) { w.summary.stuck = true; })[0]);
  EXPECT_FALSE(broken([](auto& w) { w.summary.distance = 1.0; })[0]);
  EXPECT_FALSE(broken([](auto& w) { w.summary.lateral_mean = 0.02; })[0]);
  EXPECT_FALSE(broken([](auto& w) { w.summary.lateral_max = 0.05; })[1]) << "0.2²/1.0 = 4 cm";
  EXPECT_FALSE(broken([](auto& w) { w.sharpest = 0.5; })[1]);
  EXPECT_FALSE(broken([](auto& w) { w.longest_pause = 2.0; })[1]);
  EXPECT_FALSE(broken([](auto& w) { w.summary.neighbour_flight = 2.0; })[2]);
  EXPECT_FALSE(broken([](auto& w) { w.summary.rule1_violations = 4; })[2]);
}

std::vector<DisplacementWalk> displacement_walks() {
  std::vector<DisplacementWalk> walks;
  for (const char* heading : {"ahead", "turn in place"})
    for (const double period : {0.0, 0.05, 0.2}) {
      DisplacementWalk walk{heading, period, {}, std::vector<double>(100, 0.001)};
      walk.summary.distance = walks.size() < 3 ? 3.0 : 0.0;
      walk.summary.turned = walks.size() < 3 ? 0.0 : -6.0;
      walk.summary.lateral_max = 0.002;
      walks.push_back(walk);
    }
  return walks;
}

TEST(JudgeFig12, WantsFeetToSlipByLessThanACentimetre) {
  using Words = std::vector<bool>;
  EXPECT_EQ(holding(judge_fig12(displacement_walks(), 0.05)), (Words{true, true}));
  const auto broken = [](std::size_t which, auto change) {
    auto walks = displacement_walks();
    change(walks[which]);
    return holding(judge_fig12(walks, 0.05));
  };
  EXPECT_EQ(broken(1, [](auto& w) { w.slips[7] = 0.011; }), (Words{false, true})) << "a single one";
  EXPECT_EQ(broken(2, [](auto& w) { w.slips[7] = 0.011; }), (Words{true, true})) << "of 200 ms";
  EXPECT_FALSE(broken(4, [](auto& w) { w.slips = {}; })[0]) << "none is no proof";
  EXPECT_FALSE(broken(5, [](auto& w) { w.summary.fell = true; })[0]);
  EXPECT_FALSE(broken(1, [](auto& w) { w.summary.distance = 2.8; })[1]);
  EXPECT_FALSE(broken(4, [](auto& w) { w.summary.turned = -5.5; })[1]);
  EXPECT_FALSE(broken(1, [](auto& w) { w.summary.lateral_max = 0.01; })[1]);
}

}  // namespace
}  // namespace hexagait::experiments::robot_judges_test

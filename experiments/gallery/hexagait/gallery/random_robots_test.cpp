// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <hexagait/gallery/random_robots.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <set>

/// Robots that nobody has seen before: sizes, proportions, axes, limits and masses by lot.
namespace hexagait::experiments {
namespace {

TEST(RandomRobots, WalkIfTheyCanStand) {
  constexpr int kRobots = 3;
  int stand = 0;
  for (std::uint64_t seed = 1; seed <= kRobots; ++seed) {
    const RobotTrial trial = try_robot(random_robot(seed), nullptr);
    stand += trial.stands() ? 1 : 0;
    EXPECT_TRUE(trial.walks_all() || !trial.stands()) << to_line(trial);
    EXPECT_LT(trial.off_path(), 0.02) << to_line(trial);
    EXPECT_EQ(to_line(parse_trial(to_line(trial))), to_line(trial));
  }
  EXPECT_GE(stand, 2);
}

// Each URDF is read, with the legs that were drawn, and each layout occurs.
TEST(RandomRobots, AreReadAsTheyWereDrawn) {
  std::set<LegLayout> layouts;
  std::set<int> legs;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const RandomRobot random = random_robot(seed);
    EXPECT_EQ(random.urdf, random_robot(seed).urdf);
    layouts.insert(random.layout);
    legs.insert(random.legs);
    try {
      const RobotModel robot = parse_urdf(random.urdf, "random");
      EXPECT_EQ(robot.num_legs(), random.legs) << seed;
      const int joints = random.layout == LegLayout::four_joints ? 4 : 3;
      EXPECT_EQ(robot.legs[0].num_joints(), joints) << seed;
    } catch (const InvalidInput&) {  // legs that don't get down, for instance
    }
  }
  EXPECT_EQ(layouts.size(), 4U);
  EXPECT_THAT(legs, ::testing::ElementsAre(4, 6, 8, 10));
}

std::vector<RobotTrial> good_trials(std::size_t count) {
  const WalkEnd walk{.outcome = "walked", .seconds = 10.0, .way = 1.0, .off_path = 0.01};
  return std::vector<RobotTrial>(count, {.seed = 1,
                                         .legs = 6,
                                         .layout = "leaning",
                                         .size = 1.0,
                                         .mass = 2.0,
                                         .pace = 0.5,
                                         .cannot_stand = "",
                                         .walks = {walk, walk, walk}});
}

TEST(JudgeRandomRobots, AllowsTwoOfAHundred) {
  std::vector<RobotTrial> trials = good_trials(100);
  EXPECT_EQ(judge_random_robots(trials).word(), "holds");
  trials[3].walks[2].outcome = trials[5].walks[0].outcome = "stuck";
  EXPECT_EQ(judge_random_robots(trials).word(), "holds");
  trials[7].walks[1].outcome = "too slow";
  EXPECT_EQ(judge_random_robots(trials).word(), "FAILS");
}

TEST(JudgeRandomRobots, CountsFallsInShortFormsToo) {
  std::vector<RobotTrial> trials = good_trials(10);
  trials[3].walks[2].outcome = "fell";
  EXPECT_EQ(judged_in_full_only(judge_random_robots(trials), true).word(), "FAILS");
}

TEST(JudgeRandomRobots, TakesTheWorstOfThreeWalks) {
  std::vector<RobotTrial> trials = good_trials(10);
  for (RobotTrial& trial : trials) trial.walks[1].off_path = 0.021;
  EXPECT_EQ(judge_random_robots(trials).word(), "FAILS");
}

TEST(JudgeRandomRobots, LeavesOutWhoCannotStand) {
  std::vector<RobotTrial> trials = good_trials(10);
  trials[3].cannot_stand = "joint a needs 2 N m, and has 1 N m";
  trials[3].walks.clear();
  EXPECT_EQ(judge_random_robots(trials).word(), "holds");
  EXPECT_THAT(judge_random_robots(trials).remark, ::testing::HasSubstr("9 of 10 can stand"));
  EXPECT_THAT(table(trials).text(), ::testing::HasSubstr("joint a needs"));
}

}  // namespace
}  // namespace hexagait::experiments

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <hexagait/rough/rough.hpp>
#include <hexagait/rough/tally.hpp>
#include <hexagait/sweep/results.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <testing/source_path.hpp>

namespace hexagait::experiments {
namespace {

RobotModel argos() { return load_urdf(testing::source_path("robots/argos.urdf")); }

TEST(RoughSweep, GoesToFourFifthsOfTheReachOfALeg) {
  const RobotModel robot = argos();
  const RoughSize size = rough_size(robot, 0, false);
  EXPECT_THAT(size.heights,
              ::testing::Pointwise(::testing::DoubleNear(1e-9),
                                   {0.0, 0.05, 0.10, 0.15, 0.20, 0.25, 0.30, 0.40, 0.50}));
  EXPECT_NEAR(size.heights.back() / leg_reach(robot), 0.8, 0.04);
  const sweep::Sweep sweep = rough_sweep(robot, size, {{}, recording::parse_plant("real")});
  EXPECT_EQ(sweep::num_trials(sweep), 4U * 2U * 9U * 200U);
  EXPECT_EQ(rough_size(robot, 20, false).seeds, 20U);
}

// Four controllers on the same terrain are neighbours, so that they are compared in pairs.
TEST(RoughSweep, GivesAllControllersTheSameTerrains) {
  const RobotModel robot = argos();
  const sweep::Sweep sweep = rough_sweep(robot, rough_size(robot, 3, false), {{}});
  for (std::uint64_t k = 0; k < sweep::num_trials(sweep); ++k) {
    const sweep::TrialConfig trial = sweep::trial(sweep, k), first = sweep::trial(sweep, k - k % 4);
    EXPECT_EQ(trial.seed, first.seed);
    EXPECT_EQ(trial.terrain, first.terrain);
    EXPECT_LE(trial.seed, 3U);
  }
}

// Some real walks: what the tally has is what their rows say.
TEST(RoughTally, CountsTheWalksOfASweep) {
  const RobotModel robot = argos();
  const std::filesystem::path directory =
      std::filesystem::path(::testing::TempDir()) / "rough_tally_test";
  std::filesystem::remove_all(directory);
  const sweep::Sweep sweep = rough_sweep(robot, {{0.0, 0.10}, 2, 0.2, 6.0}, {{}});
  ASSERT_TRUE(sweep::run_shard(sweep, {}, directory, {}).complete());
  sweep::publish(directory);
  const std::vector<RoughPoint> points = tally(directory);
  ASSERT_EQ(points.size(), 8U);
  for (const RoughPoint& p : points) EXPECT_EQ(p.arrived.trials, 2) << p.controller;
  const RoughPoint* const free = point(points, "ideal", "free", 0.0);
  ASSERT_NE(free, nullptr);
  EXPECT_EQ(free->arrived.count, 2);
  EXPECT_GT(free->speed.value, 0.05);
  EXPECT_GT(free->cost.value, 0.1);
  EXPECT_LT(free->slip.value, 0.001);
  EXPECT_GT(free->touchdown.value, 0.05);
  EXPECT_LT(free->touchdown.value, 0.15);
  const RoughPoint* const tripod = point(points, "ideal", "tripod", 0.0);
  EXPECT_NEAR(free->lead.value, free->speed.value - tripod->speed.value, 1e-9);
  std::filesystem::remove_all(directory);
}

}  // namespace
}  // namespace hexagait::experiments

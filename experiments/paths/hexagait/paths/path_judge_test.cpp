// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/paths/path_judge.hpp>

namespace hexagait::experiments {
namespace {

using walk::LocalisedBy;

PathWalk good(const char* shape, const char* terrain, LocalisedBy by) {
  PathWalk walk{.shape = shape, .terrain = terrain, .localised_by = by, .look_ahead = 0.25};
  walk.summary.arrived = true;
  walk.summary.lateral_mean = 0.001;
  walk.summary.path = walk::PathSummary{.believed_mean = 0.001, .missed = 0.05};
  return walk;
}

std::vector<PathWalk> all_good() {
  std::vector<PathWalk> walks;
  for (const char* shape : {"figure of eight", "square"})
    for (const char* terrain : {"flat", "boxes:0.15"})
      for (const LocalisedBy by : {LocalisedBy::odometry, LocalisedBy::truth})
        walks.push_back(good(shape, terrain, by));
  return walks;
}

std::vector<bool> holding(const std::vector<PathWalk>& walks) {
  std::vector<bool> all;
  for (const Verdict& verdict : judge_paths(walks)) all.push_back(verdict.holds());
  return all;
}

// In the order of all_good(): 0, 1 the eight on flat ground, 2, 3 over boxes, 4 … 7 the square.
TEST(JudgePaths, WantsBothShapesKeptOnBothGrounds) {
  using Words = std::vector<bool>;
  EXPECT_EQ(holding(all_good()), (Words{true, true}));
  const auto broken = [](std::size_t k, auto change) {
    std::vector<PathWalk> walks = all_good();
    change(walks[k].summary);
    return holding(walks);
  };
  EXPECT_EQ(broken(0, [](auto& s) { s.fell = true; }), (Words{false, true}));
  EXPECT_EQ(broken(0, [](auto& s) { s.arrived = false; }), (Words{false, true}));
  EXPECT_EQ(broken(1, [](auto& s) { s.lateral_mean = 0.02; }), (Words{false, true}));
  EXPECT_EQ(broken(4, [](auto& s) { s.lateral_mean = 0.02; }), (Words{false, true}));
  EXPECT_EQ(broken(5, [](auto& s) { s.path->missed = 0.2; }), (Words{false, true}));
  EXPECT_EQ(broken(3, [](auto& s) { s.lateral_mean = 0.05; }), (Words{true, false}));
  EXPECT_EQ(broken(6, [](auto& s) { s.path->believed_mean = 0.05; }), (Words{true, false}));
  EXPECT_EQ(broken(2, [](auto& s) { s.lateral_mean = 0.05; }), (Words{true, true}))
      << "odometry drifts: no claim";
  std::vector<PathWalk> stuck = all_good();
  for (const std::size_t k : {2U, 6U}) stuck[k].summary.stuck = true;
  EXPECT_EQ(holding(stuck), (Words{true, false}));
}

}  // namespace
}  // namespace hexagait::experiments

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/viewer/walking/simulated_walk.hpp>
#include <testing/argos_walk.hpp>

namespace hexagait::viewer {
namespace {

using heading_control::Heading;
using testing::argos;
using ::testing::HasSubstr;
using testing::kInfinite;

path_following::PathTask drawn(std::vector<Vector2> points, bool closed = false,
                               const PlanarPose& X_WB = {}) {
  static const StepParams step = params_for(argos()).step;
  return drawn_path(points, closed, argos(), step, X_WB);
}

std::string refusal(const std::vector<Vector2>& points, bool closed = false) {
  try {
    drawn(points, closed);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "taken";
}

// As of a file, by the same words.
TEST(FollowedPath, RefusesWhatIsNoPath) {
  EXPECT_THAT(refusal({{0.0, 0.0}, {2.0, 0.0}, {1.9, 0.0}}),
              HasSubstr("(0, 0): the path turns by 180° within"));
  EXPECT_THAT(refusal({{0.0, 0.0}, {1.0, 0.0}, {1.0, 0.0}}), HasSubstr("points in a row"));
  EXPECT_THAT(refusal({{0.0, 0.0}, {1.0, 0.0}}, true), HasSubstr("at least 3"));
  EXPECT_THAT(refusal({{0.0, 0.0}, {1e4, 0.0}}), HasSubstr("point 2 is 1e+04 m from argos"));
  EXPECT_EQ(refusal({{0.0, 0.0}, {1.0, 0.0}, {1.5, 0.5}}), "taken");
}

// Points are in the world, wherever the robot is and looks.
TEST(FollowedPath, IsWalkedToItsEnd) {
  recording::Simulation simulation;
  SimulatedWalk walk(argos(), simulation, {{0.5 * std::numbers::pi, {3.0, -2.0}}, 0.0, 0});
  const Vector2 begin = walk.place().shift, end = begin + Vector2(0.5, 0.6);
  walk.follow(drawn({begin, begin + Vector2(0.0, 0.4), end}, false, walk.place()), {});
  EXPECT_LT((walk.path()->picture().front() - begin).norm(), 1e-9);
  EXPECT_LT((walk.path()->picture().back() - end).norm(), 1e-9);
  double worst = 0.0;
  int ticks = 0;
  for (; walk.path()->steers() && ticks < 10000; ++ticks) {
    walk.tick({Heading::stop(), kInfinite});
    worst = std::max(worst, std::abs(walk.frame().lateral));
    EXPECT_EQ((walk.frame().flags & PoseFrame::follows) != 0, walk.path()->steers());
  }
  EXPECT_TRUE(walk.path()->arrived());
  EXPECT_LT((walk.place().shift - end).norm(), 0.03);
  EXPECT_GT(worst, 1e-4);
  EXPECT_LT(worst, 0.08);
}

TEST(FollowedPath, KeepsToTheSpeedLimitAndObeysAfterIt) {
  recording::Simulation simulation;
  SimulatedWalk walk(argos(), simulation);
  walk.follow(drawn({{0.0, 0.0}, {5.0, 0.0}}), {});
  for (int k = 0; k < 1500; ++k) walk.tick({Heading::stop(), 0.05});
  EXPECT_LT(walk.place().shift.x(), 0.05 * 3.0 + 0.02);
  EXPECT_GT(walk.place().shift.x(), 0.05);
  walk.path()->interrupt();
  for (int k = 0; k < 500; ++k) walk.tick({Heading::stop(), kInfinite});
  const double there = walk.place().shift.x();
  for (int k = 0; k < 500; ++k) walk.tick({Heading::stop(), kInfinite});
  EXPECT_NEAR(walk.place().shift.x(), there, 0.01);
  walk.leave_path();
  EXPECT_EQ(walk.path(), nullptr);
}

TEST(FollowedPath, AClosedOneGoesRound) {
  const auto task = drawn({{0.0, 0.0}, {2.0, 0.0}, {2.0, 2.0}, {0.0, 2.0}}, true);
  EXPECT_GT(task.end(), 100.0 * task.path.length());
  const FollowedPath path(task, {});
  EXPECT_TRUE(path.closed());
  EXPECT_LT((path.picture().front() - path.picture().back()).norm(), 1e-6);
}

}  // namespace
}  // namespace hexagait::viewer

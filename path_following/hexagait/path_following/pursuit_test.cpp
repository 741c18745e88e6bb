// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <testing/counted_allocations.hpp>
#include <testing/kinematic_pursuit.hpp>

namespace hexagait::path_following {
namespace {

using heading_control::Heading;
using testing::Follower;

constexpr double kL = 0.3;  // look-ahead [m]

PathTask task(Path path, FacingRule facing = {}) { return {std::move(path), facing, 1, kL}; }

Heading first_command(const PathTask& task, const PlanarPose& X_PB) {
  PathProgress progress;
  progress.on_path = true;
  return pursue(progress, task, X_PB, 0.0).command.heading;
}

TEST(Pursuit, OnALineGoesStraight) {
  const Heading heading = first_command(task(testing::line(5.0)), {});
  EXPECT_NEAR(heading.curvature(), 0.0, 1e-12);
  EXPECT_NEAR(heading.crab_angle(), 0.0, 1e-12);
}

// (path 2), (path 3) have no error on a circle: on it, r is its radius and α = 0; and who keeps its
// facing goes along the tangent.
TEST(Pursuit, OnACircleIsExact) {
  const double s = 1.0;
  for (const double radius : {0.5, 1.0, 3.0}) {
    PathTask along = task(testing::circle(radius));
    const PlanarPose on_it{s / radius, along.path.at(s)};
    const PathProgress progress{.s = s, .on_path = true};
    const Heading turning = pursue(progress, along, on_it, 0.0).command.heading;
    EXPECT_NEAR(turning.curvature(), 1.0 / radius, 0.02 / radius);
    EXPECT_NEAR(turning.crab_angle(), 0.0, 0.01);
    along.facing = {Facing::fixed, 0.0};
    const Heading keeping = pursue(progress, along, {0.0, on_it.shift}, 0.0).command.heading;
    EXPECT_NEAR(keeping.crab_angle(), wrap_angle(s / radius), 0.01);
    EXPECT_NEAR(keeping.curvature(), 0.0, 1e-9);
  }
}

// With e = 6 cm to the right and L = 30 cm, β = atan(0.2), and α = 2 β.
TEST(Pursuit, SetsOffAlongTheCircleThatTouchesThePathAtTheGoal) {
  const Heading heading = first_command(task(testing::line(5.0)), {0.0, {0.0, -0.06}});
  EXPECT_NEAR(heading.crab_angle(), 2.0 * std::atan(0.2), 1e-9);
}

TEST(Pursuit, FarFromAPathGoesAcrossToIt) {
  PathTask far = task(testing::line(5.0));
  const PathProgress progress{.s = 2.0, .on_path = true};
  const Heading heading = pursue(progress, far, {0.0, {2.0, -3.0}}, 0.0).command.heading;
  EXPECT_NEAR(heading.crab_angle(), 0.5 * std::numbers::pi, 1e-9);
}

// A car: 1/r = 2 y / |g|², no crab.
TEST(Pursuit, AsACarIsCoultersPurePursuit) {
  const PathTask car = task(testing::line(5.0), {Facing::car, 0.0});
  const Heading heading = first_command(car, {0.0, {0.0, -0.06}});
  EXPECT_EQ(heading.crab_angle(), 0.0);
  EXPECT_NEAR(heading.curvature(), 2.0 * 0.06 / (kL * kL + 0.06 * 0.06), 1e-12);
}

TEST(Pursuit, AsACarTurnsInPlaceToAGoalBehind) {
  const PathTask car = task(testing::line(5.0), {Facing::car, 0.0});
  const Heading left = first_command(car, {-2.0, {0.0, 0.0}}),
                right = first_command(car, {2.0, {0.0, 0.0}});
  EXPECT_EQ(left.rho(), 0.0);
  EXPECT_EQ(left.turn(), heading_control::Turn::ccw);
  EXPECT_EQ(right.turn(), heading_control::Turn::cw);
}

// It sets off from the path where corner and goal are as far apart as corner and base, L/2. If the goal
// waited there, the fillet would miss the corner by (√2 − 1) L/2 = 0.21 L; it goes on, and it is 0.27 L,
// and the fillet at most 0.2 L off the path.
TEST(Pursuit, CutsASquareCornerByAQuarterOfItsLookAhead) {
  Follower follower{.task = task({{{{0.0, 0.0}}, {{1.0, 0.0}}, {{1.0, 1.0}}}, Shape::lines, false},
                                 {Facing::fixed, 0.0})};
  double to_corner = 1.0;
  while (!follower.progress.arrived) {
    follower.follow(1, 0.001);
    to_corner = std::min(to_corner, (follower.X_PB.shift - Vector2(1.0, 0.0)).norm());
  }
  EXPECT_NEAR(to_corner, 0.27 * kL, 0.01 * kL);
  EXPECT_NEAR(follower.farthest, 0.193 * kL, 0.01 * kL);
}

TEST(Pursuit, KeepsAFigureOfEightAndASquareInAllWaysOfFacing) {
  std::vector<Waypoint> eight;
  for (int k = 0; k < 32; ++k) {
    const double t = 2.0 * std::numbers::pi * k / 32.0;
    eight.push_back({{std::sin(2.0 * t), 1.5 * std::sin(t)}});
  }
  for (const FacingRule facing : {FacingRule{Facing::along, 0.0},
                                  {Facing::along, 1.0},
                                  {Facing::fixed, 0.0},
                                  {Facing::fixed, -2.0},
                                  {Facing::car, 0.0}}) {
    Follower follower{.task = task({eight, Shape::spline, true}, facing)};
    follower.task.laps = 2;
    follower.follow(20'000);
    EXPECT_TRUE(follower.progress.arrived);
    const bool car = facing.kind == Facing::car;  // it begins across the path
    EXPECT_LT(follower.farthest, car ? 0.5 * kL : 0.07 * kL) << static_cast<int>(facing.kind);
    Follower square{.task = task(testing::square(2.0), facing)};
    square.follow(20'000);
    EXPECT_TRUE(square.progress.arrived);
    EXPECT_LT(square.farthest, car ? 0.5 * kL : 0.2 * kL) << static_cast<int>(facing.kind);
  }
}

// Evenly by 90° on 2 m; on the last L, where the goal turns no farther, what is left decays by e.
TEST(Pursuit, TurnsToTheFacingOfThePoints) {
  const Waypoint from{{0.0, 0.0}, 0.0}, to{{2.0, 0.0}, 0.5 * std::numbers::pi};
  Follower follower{.task = task({{from, to}, Shape::lines, false}, {Facing::points, 0.0})};
  follower.follow(10'000, 0.001);
  EXPECT_NEAR(follower.X_PB.angle, 0.5 * std::numbers::pi,
              0.25 * kL / std::numbers::e * std::numbers::pi * 1.05);
  EXPECT_LT(follower.farthest, 2e-3);
}

// The path begins 3 m ahead and goes back past the start, which is nearer.
TEST(Pursuit, FirstGoesToTheFirstPoint) {
  Follower follower{.task =
                        task({{{{3.0, 0.0}}, {{3.0, 1.0}}, {{-3.0, 0.5}}}, Shape::lines, false})};
  follower.follow(100);
  EXPECT_FALSE(follower.progress.on_path);
  EXPECT_EQ(follower.progress.s, 0.0);
  follower.follow(10'000);
  EXPECT_TRUE(follower.progress.arrived);
  EXPECT_NEAR((follower.X_PB.shift - Vector2(-3.0, 0.5)).norm(), 0.0, 0.02);
}

TEST(Pursuit, DoesNotTakeTheOtherBranchOfACrossing) {
  const PathTask eight =
      task({{{{0.0, 0.0}}, {{2.0, 0.0}}, {{2.0, 1.0}}, {{1.0, 1.0}}, {{1.0, -1.0}}},
            Shape::lines,
            false});
  Follower follower{.task = eight};
  double before = 0.0;
  while (!follower.progress.arrived) {
    follower.follow(1);
    EXPECT_LT(follower.progress.s - before, kL);
    before = follower.progress.s;
  }
  EXPECT_NEAR((follower.X_PB.shift - Vector2(1.0, -1.0)).norm(), 0.0, 0.02);
}

TEST(Pursuit, StopsAtTheEndForGood) {
  Follower follower{.task = task(testing::line(1.0))};
  follower.follow(1000);
  ASSERT_TRUE(follower.progress.arrived);
  EXPECT_NEAR(follower.X_PB.shift.x(), 1.0, 0.01);
  const Pursuit later = pursue(follower.progress, follower.task, {0.0, {0.3, 0.2}}, 0.0);
  EXPECT_FALSE(later.command.heading.moving());
  EXPECT_EQ(later.command.speed_limit, 0.0);
  EXPECT_TRUE(later.progress.arrived);
}

TEST(Pursuit, StopsAsMuchEarlierAsItCoasts) {
  PathProgress progress;
  const PathTask one = task(testing::line(1.0));
  progress.on_path = true;
  progress.s = 0.8;
  EXPECT_FALSE(pursue(progress, one, {0.0, {0.84, 0.0}}, 0.15).progress.arrived);
  EXPECT_TRUE(pursue(progress, one, {0.0, {0.86, 0.0}}, 0.15).progress.arrived);
}

TEST(Pursuit, WalksAllLaps) {
  Follower follower{.task = task(testing::square(1.0))};
  follower.task.laps = 3;
  follower.follow(100'000);
  EXPECT_TRUE(follower.progress.arrived);
  EXPECT_NEAR(follower.progress.s, 12.0, 0.01);
}

TEST(Pursuit, BoundsTheSpeedAsThePathSays) {
  PathTask slow =
      task({{{{0.0, 0.0}, {}, 0.1}, {{1.0, 0.0}, {}, 0.2}, {{2.0, 0.0}}}, Shape::lines, false});
  PathProgress progress{.s = 0.5, .on_path = true};
  EXPECT_EQ(pursue(progress, slow, {0.0, {0.5, 0.0}}, 0.0).command.speed_limit, 0.1);
  progress.s = 1.5;
  EXPECT_EQ(pursue(progress, slow, {0.0, {1.5, 0.0}}, 0.0).command.speed_limit, 0.2);
}

// A localisation that fails for a while.
TEST(Pursuit, StandsWhileThePoseIsNoNumber) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const PathTask one = task(testing::line(1.0));
  const PathProgress before{.s = 0.5, .on_path = true, .heading = Heading::straight(0.0)};
  const PlanarPose broken[] = {{none, {0.5, 0.0}},
                               {0.0, {none, 0.0}},
                               {0.0, {0.5, std::numeric_limits<double>::infinity()}}};
  for (const PlanarPose& pose : broken) {
    const Pursuit now = pursue(before, one, pose, 0.0);
    EXPECT_FALSE(now.command.heading.moving());
    EXPECT_EQ(now.progress.s, 0.5);
    EXPECT_TRUE(pursue(now.progress, one, {0.0, {0.5, 0.0}}, 0.0).command.heading.moving());
  }
}

TEST(Pursuit, AllocatesNothing) {
  Follower follower{.task = task(testing::square(1.0))};
  const long before = hexagait::testing::allocations;
  follower.follow(2000);
  EXPECT_EQ(hexagait::testing::allocations, before);
}

}  // namespace
}  // namespace hexagait::path_following

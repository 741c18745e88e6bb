// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <hexagait/path_following/path.hpp>
#include <numbers>
#include <random>
#include <testing/kinematic_pursuit.hpp>

namespace hexagait::path_following {
namespace {

Path corner() { return {{{{0.0, 0.0}}, {{2.0, 0.0}}, {{2.0, 1.0}}}, Shape::lines, false}; }

// 2 m ahead, then 1 m to the left.
TEST(Path, HasItsLengthFromTheFirstWaypoint) {
  const Path path = corner();
  EXPECT_DOUBLE_EQ(path.length(), 3.0);
  EXPECT_TRUE(path.at(0.5).isApprox(Vector2(0.5, 0.0)));
  EXPECT_TRUE(path.at(2.25).isApprox(Vector2(2.0, 0.25)));
  EXPECT_DOUBLE_EQ(path.direction(1.9), 0.0);
  EXPECT_DOUBLE_EQ(path.direction(2.1), 0.5 * std::numbers::pi);
}

TEST(Path, GoesOnStraightBeyondItsEnds) {
  const Path path = corner();
  EXPECT_TRUE(path.at(3.5).isApprox(Vector2(2.0, 1.5)));
  EXPECT_TRUE(path.at(-0.5).isApprox(Vector2(-0.5, 0.0)));
}

TEST(Path, RepeatsItselfWhenClosed) {
  const Path path = testing::square(2.0);
  EXPECT_DOUBLE_EQ(path.length(), 8.0);
  EXPECT_TRUE(path.at(7.5).isApprox(Vector2(0.0, 0.5)));
  EXPECT_TRUE(path.at(17.0).isApprox(path.at(1.0)));
  EXPECT_DOUBLE_EQ(path.direction(15.5), path.direction(7.5));
}

// The spline of 64 points of a circle is the circle to 1e-4 of its radius, and so are its directions.
TEST(Path, OfASplineGoesSmoothlyThroughAllWaypoints) {
  constexpr double kRadius = 2.0;
  const Path path = testing::circle(kRadius);
  EXPECT_NEAR(path.length(), 2.0 * std::numbers::pi * kRadius, 1e-3);
  for (int k = 0; k < 1000; ++k) {
    const double s = 0.001 * k * path.length();
    const Vector2 arm = path.at(s) - Vector2(0.0, kRadius);
    EXPECT_NEAR(arm.norm(), kRadius, 3e-4);
    EXPECT_NEAR(wrap_angle(path.direction(s) - s / kRadius), 0.0, 0.004);
  }
  for (int k = 0; k < 64; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / 64.0;
    const Vector2 waypoint(kRadius * std::sin(angle), kRadius * (1.0 - std::cos(angle)));
    const double s = path.nearest(waypoint, 0.0, path.length());
    EXPECT_LT((path.at(s) - waypoint).norm(), 1e-9);
  }
}

// The directions of its pieces join, and no piece turns by more than 6°.
TEST(Path, OfASplineHasNoCorners) {
  const Path path({{{0.0, 0.0}}, {{1.0, 0.0}}, {{1.2, 1.0}}, {{0.0, 1.5}}}, Shape::spline, false);
  for (std::size_t k = 1; k < path.pieces().size(); ++k) {
    const Path::Piece &before = path.pieces()[k - 1], &after = path.pieces()[k];
    EXPECT_NEAR(wrap_angle(after.direction - before.direction - before.turn), 0.0, 1e-9) << k;
    EXPECT_LT(std::abs(before.turn), 0.1) << k;
  }
}

// From 170° to −170° by way of 180°, evenly.
TEST(Path, TurnsTheFacingTheShorterWay) {
  const Path path({{{0.0, 0.0}, 170.0 * std::numbers::pi / 180.0},
                   {{1.0, 0.0}},
                   {{2.0, 0.0}, -170.0 * std::numbers::pi / 180.0}},
                  Shape::lines, false);
  EXPECT_TRUE(path.has_facing());
  EXPECT_NEAR(std::abs(path.facing(1.0)), std::numbers::pi, 1e-12);
  EXPECT_NEAR(path.facing(0.5), 175.0 * std::numbers::pi / 180.0, 1e-12);
  EXPECT_NEAR(path.facing(5.0), -170.0 * std::numbers::pi / 180.0, 1e-12);
}

TEST(Path, TurnsTheFacingAlongTheLastPieceOfAClosedOne) {
  Waypoint first{{0.0, 0.0}, 0.0}, second{{1.0, 0.0}, 0.5 * std::numbers::pi};
  const Path path({first, second, {{1.0, 1.0}}, {{0.0, 1.0}}}, Shape::lines, true);
  EXPECT_NEAR(path.facing(0.5), 0.25 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(path.facing(2.5), 0.25 * std::numbers::pi, 1e-12);  // half-way back
  EXPECT_NEAR(path.facing(4.5), 0.25 * std::numbers::pi, 1e-12);  // the second lap
}

TEST(Path, KeepsASpeedUntilTheNextOne) {
  const Path path({{{0.0, 0.0}}, {{1.0, 0.0}, {}, 0.1}, {{2.0, 0.0}}, {{3.0, 0.0}, {}, 0.2}},
                  Shape::lines, false);
  EXPECT_TRUE(std::isinf(path.speed(0.5)));
  EXPECT_EQ(path.speed(1.5), 0.1);
  EXPECT_EQ(path.speed(2.5), 0.1);
}

// Against 20 000 points.
TEST(Path, FindsTheNearestPlace) {
  std::mt19937 draws(3);
  std::uniform_real_distribution<double> anywhere(-1.5, 3.5);
  for (const Path& path : {testing::square(2.0), corner(), testing::circle(1.0)})
    for (int trial = 0; trial < 20; ++trial) {
      const Vector2 p(anywhere(draws), anywhere(draws));
      const double from = 0.3 * path.length(), to = 1.2 * path.length();
      double least = 1e9;
      for (int k = 0; k <= 20'000; ++k)
        least = std::min(least, (path.at(from + (to - from) * k / 20'000.0) - p).norm());
      const double s = path.nearest(p, from, to);
      EXPECT_LE(from, s);
      EXPECT_LE(s, to);
      EXPECT_NEAR((path.at(s) - p).norm(), least, 1e-3);
    }
}

}  // namespace
}  // namespace hexagait::path_following

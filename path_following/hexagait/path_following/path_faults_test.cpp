// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <hexagait/path_following/path_faults.hpp>
#include <limits>
#include <numbers>

namespace hexagait::path_following {
namespace {

using ::testing::HasSubstr;
using Points = std::vector<Waypoint>;

constexpr double kStride = 0.2;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::vector<PathFault> faults(const Points& points, bool closed = false,
                              Shape shape = Shape::lines) {
  return faults_of(points, shape, closed, kStride);
}

TEST(PathFaults, AreNoneInGoodPaths) {
  EXPECT_TRUE(faults({{{0.0, 0.0}}, {{1.0, 0.0}}}).empty());
  EXPECT_TRUE(faults({{{0.0, 0.0}}, {{1.0, 0.0}}, {{1.0, 1.0}}}, true).empty());
  EXPECT_TRUE(faults({{{0.0, 0.0}}, {{1.0, 0.0}}, {{1.0, 1.0}}}, true, Shape::spline).empty());
}

TEST(PathFaults, NameTooFewPoints) {
  EXPECT_THAT(faults({})[0].problem, HasSubstr("has 0 points; a path must have at least 2"));
  EXPECT_THAT(faults({{{1.0, 0.0}}})[0].problem, HasSubstr("has 1 point;"));
  EXPECT_THAT(faults({{{0.0, 0.0}}, {{1.0, 0.0}}}, true)[0].problem,
              HasSubstr("has 2 points; a closed path must have at least 3"));
}

TEST(PathFaults, NameEachNumberThatIsNone) {
  Points points = {{{0.0, kNaN}}, {{1.0, 0.0}, kNaN}, {{2.0, 0.0}, {}, -1.0}};
  const auto found = faults(points);
  ASSERT_EQ(found.size(), 3U);
  EXPECT_THAT(found[0].problem, HasSubstr("point 1, (0, nan)"));
  EXPECT_EQ(found[1].waypoint, 1U);
  EXPECT_THAT(found[2].problem, HasSubstr("speed is -1; it must be more than 0"));
}

TEST(PathFaults, NameCoincidentPoints) {
  const auto found = faults({{{0.0, 0.0}}, {{1.0, 0.5}}, {{1.0, 0.5}}, {{2.0, 0.0}}});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].waypoint, 2U);
  EXPECT_THAT(found[0].problem, HasSubstr("point 3, (1, 0.5), is where the one before is"));
}

TEST(PathFaults, NameAFirstPointThatIsRepeatedToCloseThePath) {
  const auto found = faults({{{0.0, 0.0}}, {{1.0, 0.0}}, {{1.0, 1.0}}, {{0.0, 0.0}}}, true);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found[0].problem, HasSubstr("leave the last one out"));
}

TEST(PathFaults, NameWhereThePathDoublesBack) {
  const auto found = faults({{{0.0, 0.0}}, {{1.0, 0.0}}, {{0.2, 0.01}}, {{0.2, 1.0}}});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].waypoint, 1U);
  EXPECT_THAT(found[0].problem, HasSubstr("point 2, (1, 0)"));
  EXPECT_THAT(found[0].problem, HasSubstr("179° within 0.2 m"));
}

// Two corners of 90° to one side are a U-turn: too narrow if they are within a stride, and not to
// different sides.
TEST(PathFaults, CountTurnsWithinAStrideTogether) {
  const auto u_turn = [](double width) {
    return Points{{{0.0, 0.0}}, {{1.0, 0.0}}, {{1.0, width}}, {{0.0, width}}};
  };
  EXPECT_EQ(faults(u_turn(0.9 * kStride)).size(), 1U);
  EXPECT_TRUE(faults(u_turn(1.1 * kStride)).empty());
  EXPECT_TRUE(faults({{{0.0, 0.0}}, {{1.0, 0.0}}, {{1.0, 0.1}}, {{2.0, 0.1}}}).empty());
}

// A corner of 150°, more than kMostTurn = 149°, and one of 148°.
TEST(PathFaults, AllowTurnsUpToABound) {
  const auto corner = [](double degrees) {
    const double angle = degrees * std::numbers::pi / 180.0;
    return Points{{{0.0, 0.0}}, {{1.0, 0.0}}, {{1.0 + std::cos(angle), std::sin(angle)}}};
  };
  EXPECT_TRUE(faults(corner(148.0)).empty());
  EXPECT_TRUE(faults(corner(-148.0)).empty());
  EXPECT_EQ(faults(corner(150.0)).size(), 1U);
  EXPECT_EQ(faults(corner(-150.0)).size(), 1U);
}

TEST(PathFaults, LookAtTheCornerWhereAClosedPathBegins) {
  const auto found = faults({{{0.0, 0.0}}, {{1.0, 0.2}}, {{1.0, -0.2}}}, true);  // 157° at (0, 0)
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].waypoint, 0U);
}

TEST(PathFaults, OfASplineAreItsTightTurns) {
  const Points points = {{{0.0, 0.0}}, {{1.0, 0.0}}, {{1.05, 0.05}}, {{1.0, 0.1}}, {{0.0, 0.1}}};
  EXPECT_FALSE(faults(points, false, Shape::spline).empty());
}

}  // namespace
}  // namespace hexagait::path_following

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <hexagait/balance/detail/stable_region.hpp>
#include <hexagait/sim/random.hpp>
#include <vector>

namespace hexagait {
namespace {

using Points = std::vector<Vector2>;

bool contains(const StableRegion& region, const Vector2& p, double tolerance = 1e-12) {
  for (int j = 0; j < region.size; ++j) {
    const HalfPlane& edge = region.edges[static_cast<std::size_t>(j)];
    if (edge.normal.dot(p) > edge.bound + tolerance) return false;
  }
  return true;
}

// The region is where the stability margin is at least the margin.
TEST(StableRegion, IsWhereTheStabilityMarginIsKept) {
  RandomSequence random{.seed = 1};
  int inside = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    Points points(static_cast<std::size_t>(3 + trial % 10));
    for (Vector2& point : points) point = {random.uniform(-1, 1), random.uniform(-1, 1)};
    const StableRegion region = stable_region(support_polygon(points), random.uniform(0.0, 0.2));
    const Vector2 p(random.uniform(-1, 1), random.uniform(-1, 1));
    const bool kept = stability_margin(region.polygon, p) >= region.margin;
    ASSERT_EQ(contains(region, p), kept) << trial;
    inside += kept;
  }
  EXPECT_GT(inside, 500);
}

// A rectangle 0.8 × 0.6: half of the shorter side; three feet in a row on each side are the same.
TEST(StableRegion, HasTheInscribedCircleOfARectangle) {
  const Points feet{{0.4, 0.3}, {0.0, 0.3}, {-0.4, 0.3}, {0.4, -0.3}, {0.0, -0.3}, {-0.4, -0.3}};
  EXPECT_NEAR(inscribed_radius(stable_region(support_polygon(feet), 0.0)), 0.3, 1e-12);
  const StableRegion region = stable_region(support_polygon(feet), 0.5);
  EXPECT_TRUE(region.shrunk);
  EXPECT_NEAR(region.margin, 0.3 - 1e-6, 1e-12);
  EXPECT_TRUE(contains(region, {0.1, 0.0}));
}

/// The largest value of a concave function on [−1, 1], by thirds.
template <class F>
double largest(F f) {
  double low = -1.0, high = 1.0;
  for (int k = 0; k < 45; ++k) {
    const double a = (2.0 * low + high) / 3.0, b = (low + 2.0 * high) / 3.0;
    (f(a) < f(b) ? low : high) = f(a) < f(b) ? a : b;
  }
  return f(low);
}

// (region 1) against its primal: the largest stability margin that any point has. The margin is
// concave, and so is its maximum over y as a function of x.
TEST(StableRegion, HasTheInscribedCircleOfAnyPolygon) {
  RandomSequence random{.seed = 2};
  for (int trial = 0; trial < 12; ++trial) {
    Points points(static_cast<std::size_t>(3 + trial % 10));
    for (Vector2& point : points) point = {random.uniform(-1, 1), random.uniform(-1, 1)};
    const StableRegion region = stable_region(support_polygon(points), 0.0);
    const double best = largest([&](double x) {
      return largest([&](double y) { return stability_margin(region.polygon, {x, y}); });
    });
    ASSERT_NEAR(inscribed_radius(region), best, 1e-7) << trial;
  }
}

// However large the margin, something is left, and it has the margin that is reported.
TEST(StableRegion, IsNeverEmpty) {
  RandomSequence random{.seed = 3};
  for (int trial = 0; trial < 1000; ++trial) {
    const double flat = std::pow(10.0, random.uniform(-8.0, 0.0));
    Points points(static_cast<std::size_t>(3 + trial % 10));
    for (Vector2& point : points) point = {random.uniform(-1, 1), flat * random.uniform(-1, 1)};
    const StableRegion region = stable_region(support_polygon(points), 2.0);
    StableRegion unmoved = region;
    for (HalfPlane& edge : unmoved.edges) edge.bound += region.margin;
    ASSERT_TRUE(region.shrunk);
    ASSERT_GE(region.margin, 0.0);
    ASSERT_LT(region.margin, std::max(inscribed_radius(unmoved), 1e-300)) << trial;
  }
}

TEST(StableRegion, OfASegmentOrAPointIsItself) {
  const Points points{{0.1, 0.2}, {0.5, 0.5}};
  const StableRegion segment = stable_region(support_polygon(points), 0.04);
  EXPECT_TRUE(contains(segment, {0.3, 0.35}));
  EXPECT_FALSE(contains(segment, {0.3, 0.36}));
  EXPECT_FALSE(contains(segment, {0.9, 0.8}));
  EXPECT_TRUE(segment.shrunk);

  const StableRegion point = stable_region(support_polygon(Points{{0.1, 0.2}}), 0.04);
  EXPECT_TRUE(contains(point, {0.1, 0.2}));
  EXPECT_FALSE(contains(point, {0.1001, 0.2}));
  EXPECT_EQ(stable_region(support_polygon(Points{}), 0.04).size, 0);
}

}  // namespace
}  // namespace hexagait

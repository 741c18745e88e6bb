// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <hexagait/balance/support_polygon.hpp>
#include <hexagait/sim/random.hpp>
#include <limits>
#include <vector>

namespace hexagait::support_polygon_test {
namespace {

using Points = std::vector<Vector2>;

// Signed distance to the hull of at least three points not on a line, straight from the definition,
// in O(n³): an ordered pair with no point on its right is an edge line of the hull. The margin is
// the least distance to the edge lines if inside, and minus the distance to the nearest pair's
// segment otherwise (the boundary is made of such segments, all others are inside).
double to_segment(const Vector2& p, const Vector2& a, const Vector2& b) {
  const Vector2 d = b - a;
  const double t = d.norm() == 0.0 ? 0.0 : d.dot(p - a) / d.squaredNorm();
  return (p - a - std::min(std::max(t, 0.0), 1.0) * d).norm();
}
double oracle_margin(const Points& points, const Vector2& p) {
  double inside = std::numeric_limits<double>::infinity();
  double outside = std::numeric_limits<double>::infinity();
  bool flat = true;
  for (const Vector2& a : points) {
    for (const Vector2& b : points) {
      outside = std::min(outside, to_segment(p, a, b));
      bool edge = a != b;
      for (const Vector2& c : points) {
        edge = edge && cross(b - a, c - a) >= 0.0;
        flat = flat && cross(b - a, c - a) == 0.0;
      }
      if (edge) inside = std::min(inside, cross(b - a, p - a) / (b - a).norm());
    }
  }
  return flat || inside < 0.0 ? -outside : inside;
}

double margin(const Points& points, const Vector2& p) {
  return stability_margin(support_polygon(points), p);
}

void expect_convex_and_counter_clockwise(const SupportPolygon& hull) {
  const auto at = [&](int i) { return hull.vertices[static_cast<std::size_t>(i % hull.size)]; };
  for (int i = 0; hull.size >= 3 && i < hull.size; ++i)
    EXPECT_GT(cross(at(i + 1) - at(i), at(i + 2) - at(i + 1)), 0.0);
}

// Every choice of 1 … 5 points, repetitions included, from a 3 × 3 grid: the multisets are those
// whose base-9 digits don't increase, given in turned order. Seen from 49 places (5 by turns for
// the many).
TEST(SupportPolygon, AgreesWithTheDefinitionOnEverySmallGrid) {
  int sets = 0;
  for (int n = 1, codes = 9; n <= 5; ++n, codes *= 9) {
    for (int code = 0; code < codes; ++code) {
      Points points;
      bool sorted = true;
      for (int i = 0, digits = code; i < n; ++i, digits /= 9) {
        sorted = sorted && (i == n - 1 || digits % 9 >= digits / 9 % 9);
        points.push_back({digits % 9 / 3, digits % 3});
      }
      if (!sorted) continue;
      std::rotate(points.begin(), points.begin() + ++sets % n, points.end());
      const SupportPolygon hull = support_polygon(points);
      expect_convex_and_counter_clockwise(hull);
      for (int i = 0; i < (n <= 3 ? 49 : 5); ++i) {
        const int place = (i + sets) % 49;
        const Vector2 p(-1.0 + 0.75 * (place / 7), -1.1 + 0.7 * (place % 7));
        ASSERT_NEAR(stability_margin(hull, p), oracle_margin(points, p), 1e-14)
            << code << ", " << n;
      }
    }
  }
  EXPECT_EQ(sets, 9 + 45 + 165 + 495 + 1287);
}

TEST(SupportPolygon, AgreesWithTheDefinitionOnRandomFeet) {
  RandomSequence random{.seed = 1};
  for (int k = 0; k < 1000; ++k) {
    Points points(static_cast<std::size_t>(3 + k % 10));
    for (Vector2& point : points) point = {random.uniform(-1, 1), random.uniform(-1, 1)};
    const Vector2 p(random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5));
    EXPECT_NEAR(margin(points, p), oracle_margin(points, p), 1e-14);
    expect_convex_and_counter_clockwise(support_polygon(points));
  }
}

// Twelve feet on a circle are all vertices: the most there can be.
TEST(SupportPolygon, HoldsAllFeetOfTheLargestRobot) {
  Points points;
  for (int i = 0; i < kMaxLegs; ++i)
    points.push_back({std::cos(0.5236 * i * 5), std::sin(0.5236 * i * 5)});
  EXPECT_EQ(support_polygon(points).size, kMaxLegs);
  EXPECT_NEAR(margin(points, {0, 0}), std::cos(0.2618), 1e-4);
}

// Six feet, three in a row on each side: four corners, and the margin of the middle is half a
// width.
TEST(SupportPolygon, HasFourCornersForTwoRowsOfThree) {
  const Points feet{{0.4, 0.3}, {0.4, -0.3}, {0.0, 0.3}, {0.0, -0.3}, {-0.4, 0.3}, {-0.4, -0.3}};
  EXPECT_EQ(support_polygon(feet).size, 4);
  EXPECT_NEAR(margin(feet, {0.0, 0.0}), 0.3, 1e-15);
  EXPECT_NEAR(margin(feet, {0.35, 0.0}), 0.05, 1e-15);
  EXPECT_NEAR(margin(feet, {0.5, 0.0}), -0.1, 1e-15);
  EXPECT_NEAR(margin(feet, {0.4, 0.1}), 0.0, 1e-15);
}

// The same rows with rounding noise in them, turned to any angle: the margin keeps to it.
TEST(SupportPolygon, IsNotMovedByNoiseInARow) {
  RandomSequence random{.seed = 2};
  for (int k = 0; k < 2000; ++k) {
    const double noise = std::pow(10.0, random.uniform(-17.0, -6.0)), angle = random.uniform(-4, 4);
    const Matrix3 R = rotation_z(angle);
    Points feet;
    for (int i = 0; i < 12; ++i) {  // each foot twice, nearly
      const Vector3 at(0.4 * (i % 3 - 1) + noise * random.uniform(-1, 1),
                       (i % 2 == 0 ? 0.3 : -0.3) + noise * random.uniform(-1, 1), 0.0);
      feet.push_back((R * at).head<2>());
    }
    EXPECT_NEAR(margin(feet, (R * Vector3(0.1, 0.1, 0)).head<2>()), 0.2, 2 * noise + 4e-9);
    EXPECT_NEAR(margin(feet, (R * Vector3(0.9, 0.1, 0)).head<2>()), -0.5, 2 * noise + 4e-9);
  }
}

// A row alone, with the same noise, has no inside: minus the distance to the segment, also beyond
// its ends, where a sliver's edges would all be a rounding error away.
TEST(SupportPolygon, IsASegmentForARowWithRoundingNoise) {
  RandomSequence random{.seed = 3};
  for (int k = 0; k < 2000; ++k) {
    const double noise = std::pow(10.0, random.uniform(-17.0, -10.0)),
                 angle = random.uniform(-4, 4);
    const Vector2 along(std::cos(angle), std::sin(angle)), across = perpendicular(along);
    Points feet;
    for (const double x : {0.0, -0.4, 0.4, 0.0})
      feet.push_back(x * along + noise * random.uniform(-1, 1) * across);
    EXPECT_EQ(support_polygon(feet).size, 2);
    EXPECT_NEAR(margin(feet, 0.1 * along + 0.2 * across), -0.2, 1e-9);
    EXPECT_NEAR(margin(feet, 0.7 * along), -0.3, 1e-9);
  }
}

TEST(StabilityMargin, IsMinusTheDistanceWhereThereIsNoInside) {
  EXPECT_EQ(margin({}, {0, 0}), -std::numeric_limits<double>::infinity());
  EXPECT_NEAR(margin({{3, 4}}, {0, 0}), -5.0, 1e-15);
  EXPECT_NEAR(margin({{3, 4}, {3, 4}, {3, 4}}, {0, 0}), -5.0, 1e-15);
  EXPECT_NEAR(margin({{-1, 1}, {1, 1}}, {0, 0}), -1.0, 1e-15);
  EXPECT_NEAR(margin({{-1, 1}, {1, 1}}, {0, 1}), 0.0, 1e-15);
}

// Of all edges it is the one whose line the point is farthest beyond, or nearest to.
TEST(NearestEdge, IsTheOneThatThePointIsBeyond) {
  const Points square{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
  const SupportPolygon polygon = support_polygon(square);
  EXPECT_EQ(nearest_edge(polygon, {0.5, 1.2}).inwards, Vector2(0.0, -1.0));
  EXPECT_EQ(nearest_edge(polygon, {1.3, 0.9}).inwards, Vector2(-1.0, 0.0));
  EXPECT_EQ(nearest_edge(polygon, {0.1, 0.5}).inwards, Vector2(1.0, 0.0)) << "from inside";
  const SupportPolygon segment = support_polygon(Points{{0.0, 0.0}, {1.0, 0.0}});
  EXPECT_EQ(nearest_edge(segment, {0.5, 0.1}).inwards, Vector2(0.0, -1.0));
  EXPECT_EQ(nearest_edge(segment, {0.5, -0.1}).inwards, Vector2(0.0, 1.0));
}

TEST(SupportPolygon, IsOfTheFeetThatSupport) {
  LegArray<Vector3> feet(4);
  feet[0] = {1, 1, 5};
  feet[1] = {1, -1, 6};
  feet[2] = {-1, 1, 7};
  feet[3] = {-1, -1, 8};
  EXPECT_EQ(support_polygon(feet, LegSet::all(4)).size, 4);
  EXPECT_NEAR(stability_margin(support_polygon(feet, LegSet(0b0111)), {0.5, 0.5}), 0.5, 1e-15);
  EXPECT_NEAR(stability_margin(support_polygon(feet, LegSet(0b0111)), {-0.5, -0.5}),
              -std::sqrt(0.5), 1e-15);
  EXPECT_EQ(support_polygon(feet, LegSet()).size, 0);
}

// Moving feet and point together changes nothing; widening the base never lessens the margin.
TEST(StabilityMargin, IsRigidAndGrowsWithTheBase) {
  RandomSequence random{.seed = 4};
  for (int k = 0; k < 1000; ++k) {
    Points points(6), moved(6);
    const Matrix3 R = rotation_z(random.uniform(-4, 4));
    const auto move = [&](const Vector2& p) -> Vector2 {
      return (R * Vector3(p.x(), p.y(), 0)).head<2>() + Vector2(0.3, -0.2);
    };
    for (std::size_t i = 0; i < 6; ++i) {
      points[i] = {random.uniform(-1, 1), random.uniform(-1, 1)};
      moved[i] = move(points[i]);
    }
    const Vector2 p(random.uniform(-1, 1), random.uniform(-1, 1));
    EXPECT_NEAR(margin(moved, move(p)), margin(points, p), 1e-14);
    const double five = margin({points.begin(), points.begin() + 5}, p);
    EXPECT_GE(margin(points, p), five - 1e-15);
  }
}

}  // namespace
}  // namespace hexagait::support_polygon_test

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/sim/random.hpp>
#include <hexagait/walk/referee/reference_path.hpp>

namespace hexagait::walk {
namespace {

using heading_control::Heading;
using heading_control::Turn;

constexpr double kTiny = 1e-12;

Vector2 unit(double angle) { return {std::cos(angle), std::sin(angle)}; }

// A line from (1, 2) in the direction 0.3 + 0.5: the pose that is s along it and d to its left has
// progress s, lateral d, and a heading error of what its yaw differs from 0.3.
TEST(ReferencePath, MeasuresAlongAndAcrossALine) {
  ReferencePath path({0.3, {1.0, 2.0}});
  path.follow(Heading::straight(0.5));
  const Vector2 along = unit(0.8);
  const auto deviation =
      path.deviation({0.34, Vector2(1.0, 2.0) + 1.7 * along + 0.02 * perpendicular(along)});
  EXPECT_NEAR(deviation.progress, 1.7, kTiny);
  EXPECT_NEAR(deviation.lateral, 0.02, kTiny);
  EXPECT_NEAR(deviation.heading, 0.04, kTiny);
  EXPECT_NEAR(deviation.turned, 0.04, kTiny);
  EXPECT_NEAR((path.ideal().shift - Vector2(1.0, 2.0) - 1.7 * along).norm(), 0.0, kTiny);
  EXPECT_DOUBLE_EQ(path.ideal().angle, 0.3);
}

// r = 2 from the origin along x: the centre is (0, 2), and after the angle 0.5 the circle is at
// (2 sin 0.5, 2 − 2 cos 0.5) and 2 · 0.5 = 1 m on. Outside the circle is to its right.
TEST(ReferencePath, MeasuresAlongAndAcrossAnArcToTheLeft) {
  ReferencePath path({});
  path.follow(Heading::arc(2.0, 0.0));
  const Vector2 centre(0.0, 2.0), arm = unit(0.5 - std::numbers::pi / 2.0);
  const auto outside = path.deviation({0.53, centre + 2.1 * arm});
  EXPECT_NEAR(outside.progress, 1.0, kTiny);
  EXPECT_NEAR(outside.lateral, -0.1, kTiny);
  EXPECT_NEAR(outside.heading, 0.03, kTiny);
  EXPECT_NEAR(path.deviation({0.5, centre + 1.9 * arm}).lateral, 0.1, kTiny);
  EXPECT_NEAR((path.ideal().shift - centre - 2.0 * arm).norm(), 0.0, kTiny);
}

// The mirror image: outside a circle to the right is to its left.
TEST(ReferencePath, MeasuresAlongAndAcrossAnArcToTheRight) {
  ReferencePath path({});
  path.follow(Heading::arc(-2.0, 0.0));
  const auto outside =
      path.deviation({-0.53, Vector2(0.0, -2.0) + 2.1 * unit(std::numbers::pi / 2.0 - 0.5)});
  EXPECT_NEAR(outside.progress, 1.0, kTiny);
  EXPECT_NEAR(outside.lateral, 0.1, kTiny);
  EXPECT_NEAR(outside.heading, -0.03, kTiny);
}

// A lap and a half of r = 1 is 3π m, and the ideal heading has turned by 3π.
TEST(ReferencePath, CountsLapsOfACircle) {
  ReferencePath path({});
  path.follow(Heading::arc(1.0, 0.0));
  ReferencePath::Deviation deviation;
  for (int k = 1; k <= 30; ++k) {
    const double angle = k * 0.1 * std::numbers::pi;
    deviation = path.deviation(
        {wrap_angle(angle), Vector2(0.0, 1.0) + unit(angle - std::numbers::pi / 2.0)});
  }
  EXPECT_NEAR(deviation.progress, 3.0 * std::numbers::pi, 1e-9);
  EXPECT_NEAR(deviation.heading, 0.0, 1e-9);
}

TEST(ReferencePath, StaysWhereATurnInPlaceBegan) {
  ReferencePath path({0.2, {3.0, 0.0}});
  path.follow(Heading::spin(Turn::ccw));
  const auto deviation = path.deviation({1.2, {3.0, 0.04}});
  EXPECT_NEAR(deviation.lateral, 0.04, kTiny);
  EXPECT_NEAR(deviation.turned, 1.0, kTiny);
  EXPECT_EQ(deviation.heading, 0.0);
  EXPECT_EQ(deviation.progress, 0.0);
  EXPECT_EQ(path.ideal().shift, Vector2(3.0, 0.0));
}

// Stopped, the ideal pose is the one it stopped at, heading too.
TEST(ReferencePath, HoldsPoseAndHeadingWhenStopped) {
  ReferencePath path({0.2, {3.0, 0.0}});
  path.follow(Heading::stop());
  const auto deviation = path.deviation({0.25, {3.0, 0.01}});
  EXPECT_NEAR(deviation.heading, 0.05, kTiny);
  EXPECT_NEAR(deviation.lateral, 0.01, kTiny);
  EXPECT_EQ(deviation.progress, 0.0);
}

// 1 m along x, walked 2 cm to the left: the next line starts on the first one, not where the base
// is, and the error is not forgotten.
TEST(ReferencePath, ChainsLinesAtTheirIdealEnds) {
  ReferencePath path({});
  path.follow(Heading::straight(0.0));
  (void)path.deviation({0.01, {1.0, 0.02}});
  path.follow(Heading::straight(std::numbers::pi / 2.0));
  const auto deviation = path.deviation({0.01, {1.0, 0.52}});
  EXPECT_NEAR(deviation.progress, 0.52, kTiny);
  EXPECT_NEAR(deviation.lateral, 0.0, kTiny);
  EXPECT_NEAR(deviation.heading, 0.01, kTiny);
}

// A turn in place ends at whatever yaw it has got to; the line after it sets off in that direction.
TEST(ReferencePath, GoesOnInTheDirectionThatATurnInPlaceLeft) {
  ReferencePath path({});
  path.follow(Heading::spin(Turn::ccw));
  (void)path.deviation({1.1, {0.03, 0.0}});
  path.follow(Heading::straight(0.0));
  const auto deviation = path.deviation({1.1, 2.0 * unit(1.1)});
  EXPECT_NEAR(deviation.progress, 2.0, kTiny);
  EXPECT_NEAR(deviation.lateral, 0.0, kTiny);
  EXPECT_NEAR(deviation.heading, 0.0, kTiny);
}

// The oracle is the exponential map: at progress s the ideal pose is start · exp(s (v, w)) with
// v = (cos α, sin α), w = 1/r. A base that is d beside it, across the direction of motion, has
// lateral d, whatever the start, the crab angle and the radius, for less than half a lap a tick.
TEST(ReferencePath, AgreesWithTheExponentialMap) {
  RandomSequence random{.seed = 7};
  for (int trial = 0; trial < 300; ++trial) {
    const PlanarPose start{random.uniform(-3.0, 3.0),
                           {random.uniform(-9.0, 9.0), random.uniform(-9.0, 9.0)}};
    const double curvature = trial % 10 == 0 ? 0.0 : random.uniform(-3.0, 3.0);
    const double alpha = random.uniform(-std::numbers::pi, std::numbers::pi);
    ReferencePath path(start);
    path.follow(Heading::arc(1.0 / curvature, alpha));

    double s = 0.0;
    for (int k = 0; k < 40; ++k) {
      s += random.uniform(0.0, 0.3);
      const double beside = random.uniform(-0.2, 0.2), turned = random.uniform(-0.3, 0.3);
      const PlanarPose ideal = start * exponential({unit(alpha), curvature}, s);
      const Vector2 left = perpendicular(unit(ideal.angle + alpha));
      const auto deviation =
          path.deviation({wrap_angle(ideal.angle + turned), ideal.shift + beside * left});
      ASSERT_NEAR(deviation.progress, s, 1e-9);
      ASSERT_NEAR(deviation.lateral, beside, 1e-9);
      ASSERT_NEAR(deviation.heading, turned, 1e-9);
      ASSERT_NEAR((path.ideal().shift - ideal.shift).norm(), 0.0, 1e-9);
    }
  }
}

}  // namespace
}  // namespace hexagait::walk

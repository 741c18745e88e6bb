// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <hexagait/heading_control/heading.hpp>
#include <hexagait/sim/random.hpp>
#include <limits>
#include <stdexcept>
#include <string>

namespace hexagait::heading_control {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// r = ρ/k and ρ² + k² = 1: for r = 3/4 m, (ρ, k) = (3, 4)/5.
TEST(Heading, HoldsTheRadiusAsAPointOnTheUnitCircle) {
  const Heading left = Heading::arc(0.75, 0.1), right = Heading::arc(-0.75, 0.1);
  EXPECT_DOUBLE_EQ(left.rho(), 0.6);
  EXPECT_DOUBLE_EQ(left.k(), 0.8);
  EXPECT_DOUBLE_EQ(right.rho(), 0.6);
  EXPECT_DOUBLE_EQ(right.k(), -0.8);
  EXPECT_EQ(left.turn(), Turn::ccw);
  EXPECT_EQ(right.turn(), Turn::cw);
}

TEST(Heading, GivesBackItsRadiusAndCrabAngle) {
  RandomSequence random{.seed = 1};
  for (int k = 0; k < 1000; ++k) {
    const double sign = k % 2 == 0 ? 1.0 : -1.0;
    const double r = sign * std::pow(10.0, random.uniform(-9.0, 9.0));
    const double alpha = random.uniform(-std::numbers::pi, std::numbers::pi);
    const Heading heading = Heading::arc(r, alpha);
    EXPECT_NEAR(heading.radius() / r, 1.0, 1e-15);
    EXPECT_NEAR(heading.curvature() * r, 1.0, 1e-15);
    EXPECT_EQ(heading.crab_angle(), alpha);
    EXPECT_NEAR(std::hypot(heading.rho(), heading.k()), 1.0, 1e-15);
  }
}

TEST(Heading, IsTheSameStraightLineForBothInfiniteRadii) {
  EXPECT_EQ(Heading::arc(kInf, 0.3), Heading::straight(0.3));
  EXPECT_EQ(Heading::arc(-kInf, 0.3), Heading::straight(0.3));
  EXPECT_EQ(Heading::straight(0.3).radius(), kInf);
  EXPECT_EQ(Heading::straight(0.3).curvature(), 0.0);
}

TEST(Heading, SpinSaysItsTurnOtherThanByTheSignOfZero) {
  EXPECT_EQ(Heading::spin(Turn::ccw).turn(), Turn::ccw);
  EXPECT_EQ(Heading::spin(Turn::cw).turn(), Turn::cw);
  EXPECT_FALSE(std::signbit(Heading::spin(Turn::cw).radius()));
  EXPECT_EQ(Heading::spin(Turn::ccw).curvature(), kInf);
  EXPECT_EQ(Heading::spin(Turn::cw).curvature(), -kInf);
}

TEST(Heading, WrapsTheCrabAngle) {
  EXPECT_NEAR(Heading::arc(2.0, 0.5 + 2.0 * std::numbers::pi).crab_angle(), 0.5, 1e-15);
  EXPECT_NEAR(Heading::straight(1.5 * std::numbers::pi).crab_angle(), -0.5 * std::numbers::pi,
              1e-15);
}

// Extremes of double: no overflow, no 0/0.
TEST(Heading, IsFiniteForEveryRadius) {
  for (const double r : {5e-324, 1e-300, 1e300, std::numeric_limits<double>::max()}) {
    for (const double sign : {1.0, -1.0}) {
      const Heading heading = Heading::arc(sign * r, 0.0);
      EXPECT_NEAR(heading.rho() * heading.rho() + heading.k() * heading.k(), 1.0, 1e-15);
      EXPECT_EQ(heading.turn(), sign > 0.0 ? Turn::ccw : Turn::cw);
    }
  }
}

TEST(Heading, StopKeepsItsLine) {
  const Heading heading = Heading::arc(-2.0, 0.4), stopped = heading.stopped();
  EXPECT_TRUE(heading.moving());
  EXPECT_FALSE(stopped.moving());
  EXPECT_EQ(stopped.radius(), heading.radius());
  EXPECT_EQ(stopped.crab_angle(), heading.crab_angle());
  EXPECT_EQ(Heading::stop(), Heading::straight(0.0).stopped());
}

// o = (−vy, vx)/w = r (−sin α, cos α): v = 2 m along α while turning by −0.5 gives r = −4 m.
TEST(Heading, AlongAMotionHasTheRatioAsRadius) {
  const Heading heading = Heading::along({2.0 * std::cos(0.7), 2.0 * std::sin(0.7)}, -0.5);
  EXPECT_NEAR(heading.radius(), -4.0, 1e-15);
  EXPECT_NEAR(heading.crab_angle(), 0.7, 1e-15);
  EXPECT_TRUE(heading.moving());
}

TEST(Heading, AlongTurnOrShiftAloneIsSpinOrStraight) {
  EXPECT_EQ(Heading::along({0.0, 0.0}, 1e-3), Heading::spin(Turn::ccw));
  EXPECT_EQ(Heading::along({0.0, 0.0}, -1e3), Heading::spin(Turn::cw));
  EXPECT_EQ(Heading::along({0.0, 2.0}, 0.0), Heading::straight(0.5 * std::numbers::pi));
}

TEST(Heading, AlongNothingOrNonsenseIsStop) {
  EXPECT_EQ(Heading::along({0.0, 0.0}, 0.0), Heading::stop());
  EXPECT_EQ(Heading::along({kNaN, 0.0}, 1.0), Heading::stop());
  EXPECT_EQ(Heading::along({1.0, 0.0}, kNaN), Heading::stop());
  EXPECT_EQ(Heading::along({kInf, 0.0}, 1.0), Heading::stop());
  EXPECT_EQ(Heading::along({1.0, 0.0}, -kInf), Heading::stop());
}

std::string refusal(double r, double alpha) {
  try {
    static_cast<void>(Heading::arc(r, alpha));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Heading, RefusesWhatIsNoHeadingAndSaysWhy) {
  using ::testing::HasSubstr;
  EXPECT_THAT(refusal(0.0, 0.0), HasSubstr("radius 0"));
  EXPECT_THAT(refusal(-0.0, 0.0), HasSubstr("spin"));
  EXPECT_THAT(refusal(kNaN, 0.0), HasSubstr("radius must be a number"));
  EXPECT_THAT(refusal(1.0, kNaN), HasSubstr("crab angle must be finite [rad], is nan"));
  EXPECT_THAT(refusal(1.0, kInf), HasSubstr("crab angle must be finite [rad], is inf"));
  EXPECT_THROW(static_cast<void>(Heading::straight(kNaN)), std::invalid_argument);
  EXPECT_EQ(refusal(1.0, 100.0), "");
}

}  // namespace
}  // namespace hexagait::heading_control

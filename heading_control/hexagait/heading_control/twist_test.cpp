// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/heading_control/twist.hpp>
#include <hexagait/sim/random.hpp>
#include <limits>

namespace hexagait::heading_control::twist_test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// Not symmetric front to rear, so that the sense of a turn shows in the speed: corners at x = 0.5,
// −0.3.
Stance six_legs() {
  Stance w{LegArray<Vector3>(6), LegArray<double>(6, 0.2)};
  for (LegId leg = 0; leg < 6; ++leg)
    w.p_BC[leg] = {0.5 - 0.4 * (leg / 2), leg % 2 == 0 ? 0.3 : -0.3, -0.25};
  return w;
}

// 0.2 m/s ahead and 0.1 rad/s left: o = (0, 2). The front right corner is √(0.5² + 2.3²) from it.
TEST(FromTwist, HasTheTurningCentreAtVOverW) {
  const HeadingCommand command = from_twist({{0.2, 0.0}, 0.1}, six_legs());
  EXPECT_NEAR(command.heading.radius(), 2.0, 1e-15);
  EXPECT_EQ(command.heading.crab_angle(), 0.0);
  EXPECT_NEAR(command.speed_limit, 0.1 * std::hypot(0.5, 2.3), 1e-15);
}

TEST(FromTwist, IsUndoneByToTwist) {
  RandomSequence random{.seed = 1};
  for (int k = 0; k < 2000; ++k) {
    const double v_size = std::pow(10.0, random.uniform(-9.0, 1.0));
    const double w_size = std::pow(10.0, random.uniform(-9.0, 1.0));
    const PlanarTwist twist{{v_size * random.uniform(-1, 1), v_size * random.uniform(-1, 1)},
                            w_size * random.uniform(-1, 1)};
    const HeadingCommand command = from_twist(twist, six_legs());
    const PlanarTwist back = to_twist(path_arc(command.heading, six_legs()), command.speed_limit);
    EXPECT_NEAR((back.v - twist.v).norm(), 0.0, 1e-15 * std::max(v_size, w_size));
    EXPECT_NEAR(back.w, twist.w, 4e-15 * std::max(v_size, w_size));
  }
}

TEST(ToTwist, IsUndoneByFromTwist) {
  RandomSequence random{.seed = 2};
  for (int k = 0; k < 2000; ++k) {
    const double r = (k % 2 == 0 ? 1.0 : -1.0) * std::pow(10.0, random.uniform(-6.0, 6.0));
    const double alpha = random.uniform(-std::numbers::pi, std::numbers::pi),
                 speed = random.uniform(0.01, 1.0);
    const PlanarTwist twist = to_twist(path_arc(Heading::arc(r, alpha), six_legs()), speed);
    const HeadingCommand back = from_twist(twist, six_legs());
    EXPECT_NEAR(back.heading.radius() / r, 1.0, 4e-15);
    EXPECT_NEAR(wrap_angle(back.heading.crab_angle() - alpha), 0.0, 1e-15);
    EXPECT_NEAR(back.speed_limit / speed, 1.0, 4e-15);
  }
}

// Both limits of a joystick: turning alone and shifting alone, at the speed of the farthest centre.
TEST(FromTwist, TurnsAloneOnASpinAndShiftsAloneOnAStraightLine) {
  const HeadingCommand spin = from_twist({{0.0, 0.0}, -0.4}, six_legs());
  EXPECT_EQ(spin.heading, Heading::spin(Turn::cw));
  EXPECT_NEAR(spin.speed_limit, 0.4 * std::hypot(0.5, 0.3), 1e-15);
  const HeadingCommand line = from_twist({{0.0, -0.3}, 0.0}, six_legs());
  EXPECT_EQ(line.heading, Heading::straight(-std::numbers::pi / 2));
  EXPECT_NEAR(line.speed_limit, 0.3, 1e-15);
}

TEST(FromTwist, StopsOnTheLastLineForNoTwistOrNonsense) {
  const Heading last = Heading::arc(3.0, 0.1);
  for (const PlanarTwist& twist :
       {PlanarTwist{}, PlanarTwist{{kNaN, 0.0}, 0.0}, PlanarTwist{{0.0, 0.0}, kNaN}}) {
    const HeadingCommand command = from_twist(twist, six_legs(), last);
    EXPECT_EQ(command.heading, last.stopped());
    EXPECT_EQ(command.speed_limit, 0.0);
  }
}

TEST(ToTwist, IsZeroWhenStopped) {
  const PlanarTwist twist = to_twist(path_arc(Heading::arc(2.0, 0.1).stopped(), six_legs()), 0.3);
  EXPECT_EQ(twist.v, Vector2::Zero());
  EXPECT_EQ(twist.w, 0.0);
}

}  // namespace
}  // namespace hexagait::heading_control::twist_test

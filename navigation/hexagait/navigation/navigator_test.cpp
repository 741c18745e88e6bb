// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <hexagait/navigation/navigator.hpp>
#include <limits>
#include <numbers>

namespace hexagait::navigation {
namespace {

using heading_control::Heading;
using heading_control::Turn;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kPeriod = 0.1;  // [s]

NavigationParams params() {
  NavigationParams p;
  p.to_floor = {0.4, 0.35, 0.35, 0.4};
  p.retreat = 0.1;
  p.retreat_from_steep = 0.3;
  p.least_run = 1.0;
  p.most_run = 3.0;
  p.patience = 2.0;
  p.progress = 0.01;
  p.foot_circle = 0.2;
  return p;
}

Senses floor_senses() {
  Senses senses;
  senses.range = params().to_floor;
  return senses;
}

// A point that does what the navigation says, at 0.1 m/s and 0.5 rad/s.
class Point {
 public:
  explicit Point(double lot = 0.75) : lot_(lot) { senses_ = floor_senses(); }

  // One tick with these senses; odometry and time are its own.
  void tick(const Senses& senses) {
    senses_.touches = senses.touches;
    senses_.range = senses.range;
    senses_.pitch = senses.pitch;
    state_ = navigate(state_, senses_, params(), lot_);
    senses_.time += kPeriod;
    if (!free_) return;
    const PlanarTwist twist =
        state_.act == Act::turn
            ? PlanarTwist{Vector2::Zero(), state_.turn == Turn::ccw ? 0.5 : -0.5}
            : PlanarTwist{Vector2(state_.act == Act::ahead ? 0.1 : -0.1, 0.0), 0.0};
    senses_.odometry = senses_.odometry * exponential(twist, kPeriod);
  }
  void walk(double seconds, const Senses& senses = floor_senses()) {
    for (double t = 0.0; t < seconds - 1e-9; t += kPeriod) tick(senses);
  }
  void hold() { free_ = false; }

  const NavigationState& state() const { return state_; }
  double x() const { return senses_.odometry.shift.x(); }
  double yaw() const { return senses_.odometry.angle; }
  long met(Reason reason) const { return state_.met[static_cast<std::size_t>(reason)]; }

 private:
  double lot_;
  bool free_ = true;
  NavigationState state_;
  Senses senses_;
};

Senses with_cliff(std::size_t beam) {
  Senses senses = floor_senses();
  senses.range[beam] = kInfinity;
  return senses;
}

Senses with_wall(std::size_t beam) {
  Senses senses = floor_senses();
  senses.range[beam] *= 0.5;
  return senses;
}

Senses with_touch(std::size_t whisker) {
  Senses senses = floor_senses();
  senses.touches[whisker] = true;
  return senses;
}

TEST(Danger, IsNoneOnTheFloorNorOnAFloorThatSways) {
  EXPECT_FALSE(danger(floor_senses(), params()).any);
  for (const double sway : {0.65, 1.3}) {
    Senses senses = floor_senses();
    for (double& range : senses.range) range *= sway;
    senses.pitch = 0.2;
    EXPECT_FALSE(danger(senses, params()).any);
  }
}

TEST(Danger, SaysWhatItIsAndOnWhichSide) {
  for (std::size_t k = 0; k < kBeams; ++k) {
    const Danger cliff = danger(with_cliff(k), params()), wall = danger(with_wall(k), params());
    EXPECT_EQ(cliff.reason, Reason::cliff);
    EXPECT_EQ(wall.reason, Reason::wall);
    for (const Danger& one : {cliff, wall}) {
      EXPECT_TRUE(one.any);
      EXPECT_EQ(one.left, k < 2);
      EXPECT_EQ(one.right, k >= 2);
    }
  }
  const Danger touch = danger(with_touch(1), params());
  EXPECT_EQ(touch.reason, Reason::touch);
  EXPECT_FALSE(touch.left);
  EXPECT_TRUE(touch.right);
}

// A layer subsumes all below it.
TEST(Danger, IsTheMostUrgentOne) {
  Senses senses = with_wall(0);
  EXPECT_EQ(danger(senses, params()).reason, Reason::wall);
  senses.touches[1] = true;
  EXPECT_EQ(danger(senses, params()).reason, Reason::touch);
  senses.range[3] = kInfinity;
  EXPECT_EQ(danger(senses, params()).reason, Reason::cliff);
  senses.pitch = -0.5;
  EXPECT_EQ(danger(senses, params()).reason, Reason::steep);
}

// A sensor that fails is taken for the worst that it could have said.
TEST(Danger, IsWhatIsNotANumber) {
  Senses senses = floor_senses();
  senses.range[2] = std::nan("");
  EXPECT_EQ(danger(senses, params()).reason, Reason::cliff);
  senses.pitch = std::nan("");
  EXPECT_EQ(danger(senses, params()).reason, Reason::steep);
}

TEST(Navigation, WalksStraightOnUntilItTurnsByItself) {
  Point point;  // a run of 1 + 0.75 · 2 m = 2.5 m
  point.walk(24.0);
  EXPECT_EQ(heading_of(point.state()), Heading::straight(0.0));
  EXPECT_EQ(point.met(Reason::wander), 0);
  point.walk(2.0);
  EXPECT_EQ(point.met(Reason::wander), 1);
  EXPECT_EQ(heading_of(point.state()), Heading::spin(Turn::cw)) << "by lot: 0.75 is to the right";
  EXPECT_NEAR(point.x(), 2.5, 0.02);
}

// Back by 10 cm, the way that it came; then away from the cliff, until there is none ahead.
TEST(Navigation, GoesBackFromACliffAndTurnsAwayFromIt) {
  for (const std::size_t beam : {0U, 3U}) {
    Point point;
    point.walk(5.0);
    const double reached = point.x();
    point.tick(with_cliff(beam));
    EXPECT_EQ(heading_of(point.state()), Heading::straight(std::numbers::pi));
    point.walk(1.2, with_cliff(beam));
    EXPECT_EQ(point.state().act, Act::turn);
    EXPECT_EQ(point.state().turn, beam == 0 ? Turn::cw : Turn::ccw) << "away from it";
    EXPECT_NEAR(point.x(), reached - 0.1, 0.015);

    point.walk(8.0, with_cliff(beam));
    EXPECT_EQ(point.state().act, Act::turn) << "as long as there is a cliff ahead";
    EXPECT_GT(std::abs(point.yaw()), params().most_turn);
    point.walk(0.2);
    EXPECT_EQ(heading_of(point.state()), Heading::straight(0.0));
    EXPECT_EQ(point.met(Reason::cliff), 1);
  }
}

// What is behind it, it has not seen, but for the way that it came.
TEST(Navigation, GoesBackNoFartherThanItHasCome) {
  Point point;
  point.tick(with_cliff(1));
  EXPECT_EQ(point.state().act, Act::turn) << "at the start: not at all";

  Point other;
  other.walk(0.4);
  other.walk(6.0, with_cliff(1));
  EXPECT_GE(other.x(), -0.011);
  EXPECT_EQ(other.state().act, Act::turn);
}

TEST(Navigation, TurnsFromAWallWithoutGoingBackAndGoesBackFromATouch) {
  Point wall;
  wall.walk(5.0);
  wall.tick(with_wall(2));
  EXPECT_EQ(heading_of(wall.state()), Heading::spin(Turn::ccw));

  Point touch;
  touch.walk(5.0);
  touch.tick(with_touch(0));
  EXPECT_EQ(touch.state().act, Act::back);
  touch.walk(1.3);
  EXPECT_EQ(heading_of(touch.state()), Heading::spin(Turn::cw));
}

TEST(Navigation, GoesBackFromWhatIsTooSteep) {
  for (const double pitch : {0.4, -0.4}) {
    Point point;
    point.walk(5.0);
    const double reached = point.x();
    Senses steep = floor_senses();
    steep.pitch = pitch;
    point.tick(steep);
    EXPECT_EQ(point.state().act, Act::back);
    EXPECT_EQ(point.met(Reason::steep), 1);
    point.walk(4.0);
    EXPECT_EQ(point.state().act, Act::turn);
    EXPECT_NEAR(point.x(), reached - 0.3, 0.015) << "farther than from a cliff: off the slope";
  }
}

// Straight ahead of it, either way is as good: by lot, and by an angle by lot.
TEST(Navigation, TurnsByLotWhereBothSidesAreAlike) {
  for (const auto& [lot, turn, angle] :
       {std::tuple{0.0, Turn::ccw, 0.8}, {0.25, Turn::ccw, 1.7}, {0.75, Turn::cw, 1.7}}) {
    Point point(lot);
    point.walk(5.0);
    Senses senses = with_wall(1);
    senses.range[2] = senses.range[1];
    point.tick(senses);
    EXPECT_EQ(point.state().turn, turn);
    EXPECT_NEAR(point.state().goal, angle, 1e-9);
    const double before = point.yaw();
    point.walk(angle / 0.5 + 0.3);
    EXPECT_EQ(point.state().act, Act::ahead);
    EXPECT_NEAR(std::abs(point.yaw() - before), angle, 0.11);
  }
}

// Something that no sensor sees holds it: it gives up what it does after its patience.
TEST(Navigation, DoesSomethingElseIfItMakesNoProgress) {
  Point point;
  point.walk(5.0);
  point.hold();
  point.walk(1.8);
  EXPECT_EQ(point.state().act, Act::ahead);
  point.walk(0.4);
  EXPECT_EQ(point.state().act, Act::back);
  EXPECT_EQ(point.met(Reason::blocked), 1);
  point.walk(2.2);
  EXPECT_EQ(point.state().act, Act::turn);
  const Turn first = point.state().turn;
  point.walk(2.2);
  EXPECT_NE(point.state().turn, first) << "the other way round";
}

}  // namespace
}  // namespace hexagait::navigation

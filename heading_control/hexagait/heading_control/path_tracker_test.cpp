// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/heading_control/path_tracker.hpp>
#include <hexagait/math/geometry.hpp>
#include <hexagait/sim/random.hpp>
#include <numbers>
#include <vector>

namespace hexagait::heading_control {
namespace {

constexpr double kTick = 0.001;  // path between updates [m]

/// A straight line, an arc to the left, one to the right, a spin, backwards, crabwise round a
/// curve.
const std::vector<PlanarTwist> kLines = {{{1.0, 0.0}, 0.0}, {{1.0, 0.0}, 2.0},  {{0.8, 0.3}, -1.5},
                                         {{0.0, 0.0}, 1.7}, {{-1.0, 0.0}, 0.0}, {{-0.5, 0.6}, 0.4}};
const PlanarPose kStart{2.5, {3.0, -1.0}};

double size(const PlanarTwist& twist) { return twist.v.norm() + std::abs(twist.w); }

double distance(const PlanarPose& a, const PlanarPose& b) {
  return (a.shift - b.shift).norm() + std::abs(wrap_angle(a.angle - b.angle));
}

PathTracker following(const PlanarTwist& line, const PlanarPose& start = kStart) {
  PathTracker tracker(0.5);
  tracker.reset(start);
  tracker.follow(line);
  return tracker;
}

// X(s) = X_anchor exp(V s) by the product of small motions, 8 m of it: a spin goes round twice.
TEST(PathTracker, SeesNoDeviationOnTheCurve) {
  for (const PlanarTwist& line : kLines) {
    PathTracker tracker = following(line);
    PlanarPose X_OB = kStart;
    for (int k = 1; k <= 8000; ++k) {
      X_OB = X_OB * exponential(line, kTick);
      X_OB.angle = wrap_angle(X_OB.angle);  // as odometry gives it
      ASSERT_LT(size(tracker.update(X_OB)), 1e-9) << "at " << k * kTick;
      ASSERT_NEAR(tracker.progress(), k * kTick, 1e-9);
    }
    EXPECT_LT(distance(tracker.ideal(), X_OB), 1e-9);
  }
}

// Anywhere before a command, or at rest, the deviation is back to the start: X_OB · exp(it) =
// start.
TEST(PathTracker, WithoutAPathAsksForTheStart) {
  PathTracker tracker(0.5);
  tracker.reset(kStart);
  const PlanarPose X_OB{2.2, {3.1, -1.2}};
  EXPECT_LT(distance(X_OB * exponential(tracker.update(X_OB), 1.0), kStart), 1e-12);
}

// 5 cm to the left of a straight line: back to the right, −y in the body frame. Turned to the left
// by 0.1: back to the right, w = −0.1.
TEST(PathTracker, AsksForTheWayBackNotForTheWayOff) {
  PathTracker tracker = following({{1.0, 0.0}, 0.0});
  for (int k = 1; k <= 100; ++k) {
    const PlanarTwist back = tracker.update(kStart * PlanarPose{0.0, {k * kTick, 0.05}});
    ASSERT_NEAR(back.v.x(), 0.0, 1e-12);
    ASSERT_NEAR(back.v.y(), -0.05, 1e-12);
    ASSERT_NEAR(back.w, 0.0, 1e-12);
  }
  EXPECT_NEAR(tracker.update(kStart * PlanarPose{0.1, {0.1, 0.0}}).w, -0.1, 1e-12);
}

// What is returned leads from the base to the ideal pose, by (tracker 1) and its own definition.
TEST(PathTracker, ReturnsTheTwistFromTheBaseToTheIdealPose) {
  RandomSequence random{.seed = 9};
  for (const PlanarTwist& line : kLines) {
    PathTracker tracker = following(line);
    PlanarPose on = kStart;
    for (int k = 1; k <= 500; ++k) {
      on = on * exponential(line, kTick);
      const PlanarPose X_OB =
          on * PlanarPose{random.uniform(-0.1, 0.1), {random.uniform(-0.05, 0.05), 0.03}};
      const PlanarTwist back = tracker.update(X_OB);
      ASSERT_LT(distance(X_OB * exponential(back, 1.0), tracker.ideal()), 1e-12);
    }
  }
}

// A base at the distance d beside the curve, its heading along it: the nearest pose differs by a
// shift at right angles alone. The oracle knows only circles: | |p − o| − |r| |, o the turning
// centre in odom; or the line's normal. The tracker takes one Newton step a tick, which is short by
// d/r of it: it trails by at most tick · (d/r) / (1 − d/r), 5 % of a millimetre here.
TEST(PathTracker, MeasuresTheDistanceToTheCircleOrLine) {
  RandomSequence random{.seed = 10};
  for (int trial = 0; trial < 300; ++trial) {
    const double alpha = random.uniform(-std::numbers::pi, std::numbers::pi),
                 d = random.uniform(-0.08, 0.08);
    const double r = trial % 3 == 0 ? 1e12 : std::copysign(random.uniform(0.8, 5.0), alpha);
    const Vector2 ahead(std::cos(alpha), std::sin(alpha)), left = perpendicular(ahead);
    const PlanarPose start{random.uniform(-std::numbers::pi, std::numbers::pi),
                           {random.u01(), random.u01()}};
    const Vector2 o = start * Vector2(r * left);
    PathTracker tracker = following({ahead, 1.0 / r}, start);
    for (int k = 1; k <= 300; ++k) {
      const PlanarPose X_OB =
          start * exponential({ahead, 1.0 / r}, k * kTick) * PlanarPose{0.0, d * left};
      const PlanarTwist back = tracker.update(X_OB);
      const double oracle = trial % 3 == 0 ? d : r - std::copysign((X_OB.shift - o).norm(), r);
      ASSERT_NEAR(back.v.dot(left), -oracle, 1e-6);
      ASSERT_NEAR(back.v.dot(ahead), 0.0, 0.11 * kTick);
    }
  }
}

// A new command starts at the ideal pose, not at the base: a base that is 4 cm off stays 4 cm off
// the new curve, however often it is steered.
TEST(PathTracker, DoesNotForgiveAnErrorForSteering) {
  PathTracker tracker = following({{1.0, 0.0}, 0.0});
  PlanarPose ideal = kStart;
  for (int k = 1; k <= 1000; ++k) {
    const PlanarTwist line =
        k % 2 == 0 ? PlanarTwist{{1.0, 0.0}, 0.3} : PlanarTwist{{1.0, 0.0}, -0.3};
    tracker.follow(line);
    EXPECT_LT(distance(tracker.ideal(), ideal), 1e-9) << "no jump";
    ideal = ideal * exponential(line, kTick);
    const PlanarTwist back = tracker.update(ideal * PlanarPose{0.0, {0.0, 0.04}});
    ASSERT_NEAR(back.v.y(), -0.04, 1e-4);
    ideal = tracker.ideal();
  }
}

// A metre of each line, one after the other: a base on the joined curve has no deviation.
TEST(PathTracker, JoinsTheCurveOfEachCommandToThatBefore) {
  PathTracker tracker(0.5);
  tracker.reset(kStart);
  PlanarPose X_OB = kStart;
  for (const PlanarTwist& line : kLines) {
    tracker.follow(line);
    for (int k = 1; k <= 1000; ++k) {
      X_OB = X_OB * exponential(line, kTick);
      ASSERT_LT(size(tracker.update(X_OB)), 1e-9);
    }
  }
}

// A base that has been pushed ahead along its line is not off it.
TEST(PathTracker, LetsTheBaseBeAnywhereAlongTheCurve) {
  PathTracker tracker = following({{1.0, 0.0}, 0.5});
  const PlanarPose ahead = kStart * exponential({{1.0, 0.0}, 0.5}, 0.3);
  EXPECT_LT(size(tracker.update(ahead)), 1e-9);
  EXPECT_LT(size(tracker.update(kStart)), 1e-9) << "nor behind";
}

// Wherever odom is and however it is turned, the deviation in the body frame is the same.
TEST(PathTracker, SeesTheSameInEveryOdomFrame) {
  const PlanarPose moved{-2.9, {7.0, 5.0}};
  for (const PlanarTwist& line : kLines) {
    PathTracker a = following(line), b = following(line, moved * kStart);
    for (int k = 1; k <= 500; ++k) {
      const PlanarPose X_OB =
          kStart * exponential(line, k * kTick) * PlanarPose{0.05, {0.02, -0.03}};
      const PlanarTwist one = a.update(X_OB), other = b.update(moved * X_OB);
      ASSERT_LT(size({one.v - other.v, one.w - other.w}), 1e-11);
    }
  }
}

// 0.1 m to the left of it, a point 0.1 m ahead is seen under 45°; backwards the same turn points the
// motion to that side.
TEST(ByTurning, TurnsTowardsThePathThatItCannotShiftTo) {
  constexpr double kArm = 0.1;
  for (const double way : {1.0, -1.0}) {
    const PlanarTwist ahead{{way, 0.0}, 0.0};
    const PlanarTwist turned = by_turning({{0.03, 0.1 * way}, 0.2}, ahead, kArm);
    EXPECT_NEAR(turned.v.x(), 0.03, 1e-15);
    EXPECT_EQ(turned.v.y(), 0.0);
    EXPECT_NEAR(turned.w, 0.2 + 0.25 * std::numbers::pi, 1e-12);
  }
  const PlanarTwist turned = by_turning({{0.03, 0.1}, 0.2}, {{0.0, 0.0}, 1.0}, kArm);
  EXPECT_EQ(turned.v.norm(), 0.0);
  EXPECT_EQ(turned.w, 0.2);
}

}  // namespace
}  // namespace hexagait::heading_control

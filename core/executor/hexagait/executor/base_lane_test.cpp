// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/executor/base_lane.hpp>
#include <hexagait/sim/random.hpp>
#include <numbers>
#include <testing/control_period.hpp>
#include <testing/round_params.hpp>

namespace hexagait {
namespace {

using testing::kDt;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

BaseAutoCommand straight_ahead() {
  BaseAutoCommand command;
  command.path.v = {1.0, 0.0};
  return command;
}

/// Largest change of the velocity of any point within outer_radius, in one tick [m/s].
double change(const BaseLane& a, const BaseLane& b, const BaseParams& params) {
  return (a.planar.v - b.planar.v).norm() + params.outer_radius * std::abs(a.planar.w - b.planar.w);
}

TEST(BaseLane, NeverAcceleratesMoreThanItsBoundWhateverIsAsked) {
  const BaseParams params = testing::round_params().base;
  RandomSequence random{.seed = 4};
  const auto u = [&](double bound) { return random.uniform(-bound, bound); };
  BaseLane lane;
  for (int tick = 0; tick < 20000; ++tick) {
    BaseAutoCommand command;
    command.path = {{u(1.0), u(1.0)}, u(3.0)};
    command.correction = {{u(0.1), u(0.1)}, u(0.5)};
    command.max_speed = random.u01();
    command.max_advance = random.u01() < 0.5 ? kInfinity : random.uniform(0.0, 0.2);
    command.max_braking = random.u01() < 0.5 ? 0.0 : random.uniform(0.0, 5.0);
    const BaseLane before = lane;
    advance(lane, command, {u(0.3), u(0.1), u(0.3), u(0.3)}, kDt, params);
    const double most = params.acceleration * kDt * (1.0 + 1e-12);
    const bool brakes_hard = command.max_braking > params.acceleration;
    const double braking = std::numbers::sqrt2 * command.max_braking * kDt * (1.0 + 1e-12);
    ASSERT_LE(change(lane, before, params), brakes_hard ? std::max(most, braking) : most);
    ASSERT_LE(std::abs(lane.vertical - before.vertical), most);
    ASSERT_LE(params.outer_radius * std::abs(lane.roll - before.roll), most);
    ASSERT_LE(params.outer_radius * std::abs(lane.pitch - before.pitch), most);
  }
}

// The law is that of the end of the tick, so it never passes the goal: with no period, and with no
// goal that the body could stop at.
TEST(BaseLane, StopsAtTheGoalWithoutPassingItAtAnyPeriod) {
  const BaseParams params = testing::round_params().base;
  for (const double dt : {0.001, 0.002, 0.005, 0.010, 0.020}) {
    for (const double distance : {1e-4, 0.01, 0.0375, 0.1, 0.5, 2.0, -0.3}) {
      BaseLane lane;
      double x = 0.0, farthest = 0.0, fastest = 0.0;
      for (double t = 0.0; t < 10.0; t += dt) {
        advance(lane, straight_ahead(), {.advance = distance - x}, dt, params);
        x += lane.planar.v.x() * dt;
        farthest = std::max(farthest, (x - distance) * std::copysign(1.0, distance));
        fastest = std::max(fastest, std::abs(lane.planar.v.x()));
      }
      EXPECT_LE(farthest, 1e-12) << distance << " m, " << dt << " s";
      EXPECT_LE(fastest, params.max_speed * (1.0 + 1e-12));
      EXPECT_NEAR(x, distance, 1e-6);
      EXPECT_NEAR(lane.planar.v.x(), 0.0, 1e-6);
    }
  }
}

// Height and tilt, too, and all of it in the same time: within a period.
TEST(BaseLane, TiltsAndLiftsWithoutPassingTheGoalAtAnyPeriod) {
  const BaseParams params = testing::round_params().base;
  double first[3] = {};
  for (const double dt : {0.001, 0.002, 0.005, 0.010, 0.020}) {
    BaseLane lane;
    Vector3 x = Vector3::Zero();
    const Vector3 goal(0.1, 0.3, -0.2);
    double reached[3] = {};
    for (double t = 0.0; t < 5.0; t += dt) {
      advance(lane, {}, {0.0, goal[0] - x[0], goal[1] - x[1], goal[2] - x[2]}, dt, params);
      x += dt * Vector3(lane.vertical, lane.roll, lane.pitch);
      for (int k = 0; k < 3; ++k) {
        ASSERT_LE(std::abs(x[k]), std::abs(goal[k]) + 1e-12);
        if (reached[k] == 0.0 && std::abs(x[k]) > 0.9 * std::abs(goal[k])) reached[k] = t + dt;
      }
    }
    for (int k = 0; k < 3; ++k) {
      if (first[k] == 0.0) first[k] = reached[k];
      EXPECT_NEAR(reached[k], first[k], 1.01 * dt) << k;
    }
  }
}

// A heading changes at full speed: the motion of before ends after 2 s ln(v/v₁) + s, where s is the
// braking distance and v₁² = 2 a s, if the polygon allows it; else after v²/(2 b).
TEST(BaseLane, LeavesThePathBySoMuchAtASharpChangeOfHeadingAtAnyPeriod) {
  BaseParams params = testing::round_params().base;
  params.braking_distance = 0.005;  // a tick of 20 ms is not all of it
  constexpr double kSpeed = 0.45;
  const double s = params.braking_distance, left = std::sqrt(2.0 * params.acceleration * s);
  const double gentle = 2.0 * s * std::log(kSpeed / left) + s;
  struct Case {
    double max_braking, way;
  };
  for (const auto& [max_braking, way] : {Case{kInfinity, gentle}, Case{3.0, kSpeed * kSpeed / 6.0},
                                         Case{0.0, kSpeed * kSpeed / (2.0 * params.acceleration)}})
    for (const double dt : {0.001, 0.002, 0.005, 0.010, 0.020}) {
      BaseAutoCommand command;
      command.path.v = {0.0, 1.0};
      command.max_braking = max_braking;
      BaseLane lane;
      lane.planar.v.x() = kSpeed;
      double x = 0.0;
      for (double t = 0.0; t < 2.0; t += dt) {
        advance(lane, command, {}, dt, params);
        x += lane.planar.v.x() * dt;
        ASSERT_GE(lane.planar.v.x(), 0.0);
      }
      EXPECT_LT(x, 1.3 * way) << max_braking << " m/s², " << dt << " s";
      EXPECT_GT(x, 0.6 * way) << max_braking << " m/s², " << dt << " s";
    }
}

// Only what is besides the path: on a tighter arc the part of straight motion that follows it goes on.
TEST(BaseLane, BrakesWhatIsBesidesThePath) {
  constexpr double kArm = 0.8;
  BaseLane lane;
  lane.planar = {{0.3, 0.4}, 0.5};
  const PlanarTwist path{{0.6, 0.0}, 1.0};
  const PlanarTwist off = off_path(lane, path, kArm);
  EXPECT_NEAR(off.v.dot(path.v) + kArm * kArm * off.w * path.w, 0.0, 1e-15);
  const PlanarTwist on{lane.planar.v - off.v, lane.planar.w - off.w};
  EXPECT_NEAR(on.v.x() / path.v.x(), on.w / path.w, 1e-15);
  EXPECT_NEAR(on.v.y(), 0.0, 1e-15);

  const PlanarTwist backwards = off_path(lane, {-path.v, -path.w}, kArm);
  EXPECT_EQ(backwards.v, lane.planar.v);
  EXPECT_EQ(backwards.w, lane.planar.w);
  EXPECT_EQ(off_path(lane, {}, kArm).v, lane.planar.v);
}

// Half way at the bound, half way back: the time to stop is that of the bounds, d = a t²/4 each
// half, plus the linear end, some 1/advance_rate.
TEST(BaseLane, TakesNotMuchLongerThanTheBoundsAsk) {
  const BaseParams params = testing::round_params().base;
  const double distance = 0.2, least = 2.0 * std::sqrt(distance / params.acceleration);
  BaseLane lane;
  double x = 0.0, t = 0.0;
  while (distance - x > 0.002 && t < 10.0) {
    advance(lane, straight_ahead(), {.advance = distance - x}, kDt, params);
    x += lane.planar.v.x() * kDt;
    t += kDt;
  }
  EXPECT_LT(t, least + 2.0 / params.advance_rate);
}

TEST(BaseLane, GoesNoFartherThanMaxAdvanceAndNoFasterThanMaxSpeed) {
  const BaseParams params = testing::round_params().base;
  BaseAutoCommand command = straight_ahead();
  command.max_speed = 0.2;
  BaseLane lane;
  double x = 0.0;
  for (int tick = 0; tick < 3000; ++tick) {
    command.max_advance = std::max(0.0, 0.15 - x);
    advance(lane, command, {.advance = 1.0}, kDt, params);
    x += lane.planar.v.x() * kDt;
    ASSERT_LE(lane.planar.v.x(), 0.2 * (1.0 + 1e-12));
    ASSERT_LE(x, 0.15 + 0.2 * kDt);
  }
  EXPECT_NEAR(x, 0.15, 1e-4);
}

// A large deviation is made good at the bound, in its own direction; a small one in proportion.
TEST(BaseLane, CorrectsTowardsThePathWithinItsBounds) {
  const BaseParams params = testing::round_params().base;
  BaseAutoCommand command = straight_ahead();
  command.correction = {{0.3, 0.4}, -2.0};
  BaseLane lane;
  for (int tick = 0; tick < 1000; ++tick) advance(lane, command, {}, kDt, params);
  EXPECT_NEAR(lane.planar.v.x(), 0.6 * params.correction_speed, 1e-12);
  EXPECT_NEAR(lane.planar.v.y(), 0.8 * params.correction_speed, 1e-12);
  EXPECT_NEAR(lane.planar.w, -params.correction_turn, 1e-12);

  // Near the path the deviation decays by 1 − exp(−k dt) in a tick.
  const double rate = -std::expm1(-params.correction_rate * kDt) / kDt;
  command.correction = {{0.003, -0.004}, 0.01};
  for (int tick = 0; tick < 1000; ++tick) advance(lane, command, {}, kDt, params);
  EXPECT_NEAR(lane.planar.v.x(), 0.003 * rate, 1e-12);
  EXPECT_NEAR(lane.planar.v.y(), -0.004 * rate, 1e-12);
  EXPECT_NEAR(lane.planar.w, 0.01 * rate, 1e-12);
}

// Height, roll and pitch: at the bound towards a far goal, then to rest at it. A first-order law of
// rate 2/s under a generous bound doesn't overshoot, but for a tick.
TEST(BaseLane, RaisesAndLevelsTheBodyWithoutOvershoot) {
  const BaseParams params = testing::round_params().base;
  const BaseGoal goal{.height = 0.2, .roll = -0.4, .pitch = 0.5};
  BaseLane lane;
  Vector3 at = Vector3::Zero();
  const Vector3 to(goal.height, goal.roll, goal.pitch);
  for (int tick = 0; tick < 5000; ++tick) {
    const Vector3 left = to - at;
    advance(lane, {}, {.height = left[0], .roll = left[1], .pitch = left[2]}, kDt, params);
    at += kDt * Vector3(lane.vertical, lane.roll, lane.pitch);
    ASSERT_LE(std::abs(lane.vertical), params.height_speed);
    ASSERT_LE(std::abs(lane.roll), params.tilt_speed);
    ASSERT_LE(std::abs(lane.pitch), params.tilt_speed);
    for (int k = 0; k < 3; ++k) ASSERT_LE(at[k] / to[k], 1.0 + 0.3 * kDt / std::abs(to[k]));
  }
  EXPECT_LT((at - to).norm(), 1e-6);
}

TEST(BaseLane, MirrorsLeftAndRight) {
  const BaseParams params = testing::round_params().base;
  BaseAutoCommand left, right;
  left.path = {{0.6, 0.3}, 0.5}, right.path = {{0.6, -0.3}, -0.5};
  left.correction = {{0.01, 0.02}, 0.03}, right.correction = {{0.01, -0.02}, -0.03};
  BaseLane a, b;
  for (int tick = 0; tick < 200; ++tick) {
    advance(a, left, {.advance = 0.1, .roll = 0.1, .pitch = 0.2}, kDt, params);
    advance(b, right, {.advance = 0.1, .roll = -0.1, .pitch = 0.2}, kDt, params);
    ASSERT_EQ(a.planar.v.x(), b.planar.v.x());
    ASSERT_EQ(a.planar.v.y(), -b.planar.v.y());
    ASSERT_EQ(a.planar.w, -b.planar.w);
    ASSERT_EQ(a.roll, -b.roll);
    ASSERT_EQ(a.pitch, b.pitch);
  }
}

}  // namespace
}  // namespace hexagait

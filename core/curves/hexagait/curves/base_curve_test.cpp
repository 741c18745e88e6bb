// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/curves/base_curve.hpp>
#include <hexagait/sim/random.hpp>
#include <testing/counted_allocations.hpp>
#include <testing/random_vector.hpp>

namespace hexagait {
namespace {

using testing::random_vector;

Pose random_pose(RandomSequence& random, double angle) {
  const Vector3 axis = random_vector(random, 1.0).normalized();
  return {rotation(angle * axis), random_vector(random, 1.0)};
}
Twist random_twist(RandomSequence& random) {
  return {random_vector(random, 0.5), random_vector(random, 1.0)};
}
double distance(const Pose& a, const Pose& b) { return (a.R - b.R).norm() + (a.p - b.p).norm(); }
double distance(const Twist& a, const Twist& b) { return (a.v - b.v).norm() + (a.w - b.w).norm(); }

// Knots that turn by nothing, a little, much, and as good as π.
std::vector<BaseKnot> random_knots(RandomSequence& random, const Pose& start, int n) {
  const double turns[] = {0.0, 1e-9, 0.3, 1.5, 3.0, std::numbers::pi - 1e-9};
  std::vector<BaseKnot> knots;
  Pose pose = start;
  double time = 0.0;
  for (int k = 0; k < n; ++k) {
    const Pose step = random_pose(random, turns[static_cast<int>(6 * random.u01())]);
    pose = {pose.R * step.R, step.p};
    knots.push_back({time += random.uniform(0.3, 2.0), pose});
  }
  return knots;
}

template <class Check>
void for_random_curves(std::uint64_t seed, int count, Check check) {
  RandomSequence random{.seed = seed};
  BaseCurve curve;
  curve.reserve(5);
  for (int k = 0; k < count; ++k) {
    const BaseState start{random_pose(random, random.uniform(0, 3)), random_twist(random)};
    const Twist end = random_twist(random);
    const auto knots = random_knots(random, start.X_AB, 1 + k % 5);
    curve.plan(start, knots, end);
    check(curve, start, knots, end);
    if (::testing::Test::HasFatalFailure()) return;
  }
}

// 0.5 m at 0.2 m/s, 0.9 rad at 0.3 rad/s.
TEST(BaseDuration, IsTheLongerOfWayAndTurn) {
  const Pose to{rotation({0, 0, 0.9}), {0.3, 0.4, 0.0}};
  EXPECT_NEAR(base_duration({}, to, 0.2, 1.0, 0.1), 2.5, 1e-15);
  EXPECT_NEAR(base_duration({}, to, 0.2, 0.3, 0.1), 3.0, 1e-14);
  EXPECT_EQ(base_duration({}, to, 0.2, 0.3, 7.0), 7.0);
}

// From rest to rest about one axis and along one line: 3τ² − 2τ³ of both.
TEST(BaseCurve, FromRestToRestIsTheCubicStep) {
  BaseCurve curve;
  const std::vector<BaseKnot> knots = {{2.0, {rotation({0.2, 0.1, -0.8}), {0.4, -0.2, 0.1}}}};
  curve.plan({}, knots);
  for (double x = 0.0; x <= 1.0; x += 0.125) {
    const double s = x * x * (3 - 2 * x);
    const Pose expected{rotation(s * Vector3(0.2, 0.1, -0.8)), s * Vector3(0.4, -0.2, 0.1)};
    EXPECT_LT(distance(curve.at(2.0 * x).X_AB, expected), 1e-14);
  }
  EXPECT_LT((curve.at(1.0).V_B.w - 0.75 * Vector3(0.2, 0.1, -0.8)).norm(), 1e-14);
}

TEST(BaseCurve, PassesItsKnotsAndHasTheTwistsOfItsEnds) {
  for_random_curves(1, 1000,
                    [](const BaseCurve& curve, const BaseState& start, auto& knots, auto& end) {
                      const double T = curve.duration(), e = 1e-9;
                      ASSERT_EQ(T, knots.back().time);
                      ASSERT_LT(distance(curve.at(0.0).X_AB, start.X_AB), 1e-15);
                      ASSERT_LT(distance(curve.at(e).V_B, start.V_B), 1e-6);
                      ASSERT_LT(distance(curve.at(T - e).V_B, end), 1e-6);
                      ASSERT_LT(distance(curve.at(T + 1.0).V_B, end), 1e-15);
                      for (const BaseKnot& knot : knots)
                        for (const double t : {knot.time - e, knot.time, knot.time + e})
                          ASSERT_LT(distance(curve.at(t).X_AB, knot.X_AB), 1e-7);
                    });
}

// Differences over 2e-5 s: the error is e²/6 times the third derivative. Also across knots: C1.
TEST(BaseCurve, HasTheTwistOfItsPoseAndNoJumpOfIt) {
  for_random_curves(2, 500, [](const BaseCurve& curve, const BaseState&, auto& knots, auto&) {
    const double e = 1e-5;
    for (double t = 0.02; t < curve.duration() - e; t += 0.07) {
      const Pose left = curve.at(t - e).X_AB, right = curve.at(t + e).X_AB;
      const BaseState now = curve.at(t);
      const Vector3 v = now.X_AB.R.transpose() * (right.p - left.p) / (2 * e);
      const Vector3 w = rotation_vector(left.R.transpose() * right.R) / (2 * e);
      // Near a knot, where the acceleration jumps, a difference is worth less.
      ASSERT_LT(distance(now.V_B, {v, w}), 5e-3) << t;
    }
    for (const BaseKnot& knot : knots) {
      if (&knot == &knots.back()) continue;
      ASSERT_LT(distance(curve.at(knot.time - 1e-9).V_B, curve.at(knot.time + 1e-9).V_B), 1e-5);
    }
  });
}

// Runge-Kutta of order 4 over the twist alone, with quaternions: q' = ½ q (0, w), p' = R v.
TEST(BaseCurve, IsWhatItsTwistIntegratesTo) {
  for_random_curves(3, 100, [](const BaseCurve& curve, const BaseState& start, auto& knots, auto&) {
    Eigen::Vector4d q = Eigen::Quaterniond(start.X_AB.R).coeffs();
    Vector3 p = start.X_AB.p;
    const auto rate = [&](double t, const Eigen::Vector4d& c) {
      const Twist V = curve.at(t).V_B;
      const Eigen::Quaterniond turn(c), w(0.0, V.w.x(), V.w.y(), V.w.z());
      return std::pair(Eigen::Vector4d(0.5 * (turn * w).coeffs()),
                       Vector3(turn.toRotationMatrix() * V.v));
    };
    double begin = 0.0;
    for (const BaseKnot& knot : knots) {
      const int n = 300;
      const double h = (knot.time - begin) / n;
      for (int i = 0; i < n; ++i) {
        const double t = begin + i * h;
        const auto [q1, p1] = rate(t, q);
        const auto [q2, p2] = rate(t + h / 2, q + h / 2 * q1);
        const auto [q3, p3] = rate(t + h / 2, q + h / 2 * q2);
        const auto [q4, p4] = rate(t + h, q + h * q3);
        q += h / 6 * (q1 + 2 * q2 + 2 * q3 + q4);
        p += h / 6 * (p1 + 2 * p2 + 2 * p3 + p4);
      }
      begin = knot.time;
      const Pose integrated{Eigen::Quaterniond(q).normalized().toRotationMatrix(), p};
      ASSERT_LT(distance(integrated, knot.X_AB), 1e-5);
    }
  });
}

// Along a line, steps 0 … 1 m: a cubic within three times the mean velocities is monotone.
TEST(BaseCurve, NeverRunsBackwardsThroughRisingKnots) {
  RandomSequence random{.seed = 4};
  BaseCurve curve;
  curve.reserve(10);
  for (int k = 0; k < 300; ++k) {
    std::vector<BaseKnot> knots;
    double time = 0.0, way = 0.0;
    for (int i = 0; i < 10; ++i) {
      way += random.u01() * random.u01() * random.u01();
      const Vector3 along = way * Vector3(0.6, 0.0, 0.8);
      knots.push_back({time += random.uniform(0.1, 1.0), {rotation(0.2 * along), along}});
    }
    curve.plan({}, knots);
    for (double t = 0.0; t < time; t += 0.02) {
      const BaseState now = curve.at(t);
      ASSERT_GE((now.X_AB.R * now.V_B.v).dot(Vector3(0.6, 0.0, 0.8)), -1e-12);
      ASSERT_GE(now.V_B.w.dot(Vector3(0.6, 0.0, 0.8)), -1e-7);
    }
  }
}

// The same curve seen from elsewhere: poses move, twists in B don't.
TEST(BaseCurve, IsTheSameInEveryFrame) {
  const Pose X{rotation({0.3, -0.8, 1.9}), {5.0, -3.0, 1.0}};
  RandomSequence random{.seed = 5};
  for (int k = 0; k < 100; ++k) {
    BaseCurve curve, moved;
    curve.reserve(3), moved.reserve(3);
    const BaseState start{random_pose(random, 1.0), random_twist(random)};
    std::vector<BaseKnot> knots = {{1.0, random_pose(random, 1.2)},
                                   {1.7, random_pose(random, 0.5)},
                                   {3.0, random_pose(random, 0.8)}};
    curve.plan(start, knots);
    for (BaseKnot& knot : knots) knot.X_AB = X * knot.X_AB;
    moved.plan({X * start.X_AB, start.V_B}, knots);
    for (double t = 0.0; t < 3.0; t += 0.1) {
      ASSERT_LT(distance(moved.at(t).X_AB, X * curve.at(t).X_AB), 1e-12);
      ASSERT_LT(distance(moved.at(t).V_B, curve.at(t).V_B), 1e-12);
    }
  }
}

TEST(BaseCurve, CanBeCopiedWithItsRoomAndAllocatesOnlyWhenItReserves) {
  RandomSequence random{.seed = 6};
  const auto knots = random_knots(random, {}, 50);
  BaseCurve first;
  first.reserve(50);
  BaseCurve curve = first;
  const long before = testing::allocations;
  curve.plan({}, knots);
  first = curve;
  EXPECT_EQ(testing::allocations, before);
  EXPECT_EQ(first.duration(), knots.back().time);
  EXPECT_LT(distance(first.at(99.0).X_AB, knots.back().X_AB), 1e-15);
  curve.plan({{rotation_z(1.0), {1, 2, 3}}, {}}, {});
  EXPECT_LT(distance(curve.at(1.0).X_AB, {rotation_z(1.0), {1, 2, 3}}), 1e-15);
}

}  // namespace
}  // namespace hexagait

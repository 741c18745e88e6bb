// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/curves/foot_curve.hpp>
#include <hexagait/sim/random.hpp>
#include <testing/counted_allocations.hpp>
#include <testing/random_vector.hpp>
#include <vector>

namespace hexagait {
namespace {

using testing::random_vector;

constexpr SwingProfile kProfiles[] = {SwingProfile::straight, SwingProfile::triangle,
                                      SwingProfile::square, SwingProfile::trapezoid};

// Rest to rest over 0.3 m: half the way at half the time, with 1.875 times the mean speed.
TEST(FootTarget, IsReachedByMinimumJerk) {
  FootCurve curve;
  const PointState target{{0.3, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  curve.plan_target({}, target, 0.5);
  EXPECT_NEAR(curve.at(0.25).p.x(), 0.15, 1e-15);
  EXPECT_NEAR(curve.at(0.25).v.x(), kMinimumJerkPeak * 0.6, 1e-14);
  EXPECT_EQ(curve.at(9.0).p, target.p);
}

TEST(FootTarget, MeetsBothEndsStates) {
  RandomSequence random{.seed = 8};
  FootCurve curve;
  for (int k = 0; k < 100; ++k) {
    const PointState a{random_vector(random, 1), random_vector(random, 1),
                       random_vector(random, 1)};
    const PointState b{random_vector(random, 1), random_vector(random, 1),
                       random_vector(random, 1)};
    curve.plan_target(a, b, 0.7);
    EXPECT_LT((curve.at(1e-9).a - a.a).norm(), 1e-5);
    EXPECT_LT((curve.at(0.7 - 1e-9).p - b.p).norm(), 1e-8);
    EXPECT_LT((curve.at(0.7 - 1e-9).v - b.v).norm(), 1e-7);
    EXPECT_LT((curve.at(0.7 - 1e-9).a - b.a).norm(), 1e-5);
  }
}

std::vector<FootKnot> random_trajectory(RandomSequence& random, int n) {
  std::vector<FootKnot> knots;
  double time = 0.0;
  for (int k = 0; k < n; ++k) {
    time += random.uniform(0.05, 0.3);
    knots.push_back({time, random_vector(random, 0.3), {}});
    if (k % 3 == 0) knots.back().v = random_vector(random, 0.3);
  }
  return knots;
}

TEST(FootTrajectory, PassesAThousandKnotsWithTheirVelocities) {
  RandomSequence random{.seed = 9};
  FootCurve curve;
  curve.reserve(1000);
  const auto knots = random_trajectory(random, 1000);
  curve.plan_trajectory({}, knots);
  ASSERT_EQ(curve.duration(), knots.back().time);
  for (const FootKnot& knot : knots) {
    ASSERT_LT((curve.at(knot.time).p - knot.p).norm(), 1e-12);
    if (knot.v) {
      ASSERT_LT((curve.at(knot.time).v - *knot.v).norm(), 1e-12);
    }
  }
}

// Accelerations up to 100 m/s² and jerks up to 60 · 0.6 / 0.05³ on both sides of a knot.
TEST(FootTrajectory, IsContinuousUpToItsAccelerationAlsoAtKnots) {
  RandomSequence random{.seed = 10};
  FootCurve curve;
  curve.reserve(30);
  for (int k = 0; k < 100; ++k) {
    const auto knots = random_trajectory(random, 30);
    const PointState start{random_vector(random, 1), random_vector(random, 1),
                           random_vector(random, 9)};
    curve.plan_trajectory(start, knots);
    ASSERT_EQ(curve.at(0.0).a, start.a);
    const double e = 1e-7;
    for (const FootKnot& knot : knots) {
      const PointState left = curve.at(knot.time - e), right = curve.at(knot.time + e);
      ASSERT_LT((right.v - left.v - 2 * e * curve.at(knot.time).a).norm(), 1e-6);
      if (&knot != &knots.back()) {
        ASSERT_LT((right.a - left.a).norm(), 2 * e * 3e5);
      }
    }
    ASSERT_EQ(curve.at(99.0).v, Vector3::Zero());
  }
}

// p(t) = (1, 2, 3) t + (−1, 0, 2) t² at uneven times; the last knot's velocity is given, its
// acceleration can't be, so the last interval may differ.
TEST(FootTrajectory, ReproducesAParabola) {
  const auto p = [](double t) { return Vector3(t - t * t, 2 * t, 3 * t + 2 * t * t); };
  const auto v = [](double t) { return Vector3(1 - 2 * t, 2, 3 + 4 * t); };
  std::vector<FootKnot> knots;
  for (const double t : {0.1, 0.25, 0.3, 0.5, 0.8}) knots.push_back({t, p(t), {}});
  knots.back().v = v(0.8);
  FootCurve curve;
  curve.reserve(5);
  curve.plan_trajectory({p(0), v(0), {-2, 0, 4}}, knots);
  for (double t = 0.0; t < 0.5; t += 0.01) EXPECT_LT((curve.at(t).p - p(t)).norm(), 1e-14);
}

// At time 0 the start state stands; the knot that goes back in time and those behind it are left
// out; so are those beyond the room.
TEST(FootTrajectory, LeavesOutKnotsItCannotUse) {
  FootCurve curve;
  curve.plan_trajectory(
      {},
      std::vector<FootKnot>{
          {0.0, {9, 9, 9}, {}}, {0.5, {1, 0, 0}, {}}, {0.5, {2, 0, 0}, {}}, {0.9, {3, 0, 0}, {}}});
  EXPECT_EQ(curve.duration(), 0.5);
  EXPECT_EQ(curve.at(0.0).p, Vector3::Zero());
  EXPECT_EQ(curve.at(0.5).p, Vector3(1, 0, 0));
  RandomSequence random{.seed = 11};
  const auto knots = random_trajectory(random, 40);
  curve.reserve(20);
  curve.plan_trajectory({}, knots);
  EXPECT_EQ(curve.duration(), knots[19].time);
  EXPECT_EQ(curve.at(9.0).v, Vector3::Zero()) << "rests there";
  curve.plan_trajectory({}, {});
  EXPECT_EQ(curve.duration(), 0.0);
}

// Forwards, back again, before the start and behind the end; planned anew, and copied on the way.
TEST(FootCurve, IsTheSameForWhoGoesAlong) {
  RandomSequence random{.seed = 14};
  FootCurve along;
  along.reserve(20);
  for (int n = 1; n < 20; ++n) {
    along.plan_trajectory({}, random_trajectory(random, n));
    double t = -0.1;
    for (int k = 0; k < 200; ++k) {
      t += random.uniform(-0.1, 0.2) * along.duration() / 10.0;
      const PointState is = along.along(t), expected = along.at(t);
      ASSERT_LT((is.p - expected.p).norm(), 1e-12) << t;
      ASSERT_LT((is.v - expected.v).norm(), 1e-11) << t;
      ASSERT_LT((is.a - expected.a).norm(), 1e-9) << t;
      if (k == 100) along = FootCurve(along);
    }
  }
}

TEST(FootCurve, CanBeCopiedWithItsRoom) {
  RandomSequence random{.seed = 12};
  const auto knots = random_trajectory(random, 100);
  FootCurve first;
  first.reserve(100);
  FootCurve copy = first, assigned;
  assigned = first;
  for (FootCurve* curve : {&copy, &assigned}) {
    curve->plan_trajectory({}, knots);
    EXPECT_EQ(curve->duration(), knots.back().time);
  }
  EXPECT_EQ(first.duration(), 0.0);
}

TEST(FootCurve, AllocatesOnlyWhenItReserves) {
  RandomSequence random{.seed = 13};
  const auto knots = random_trajectory(random, 100);
  FootCurve curve, other;
  curve.reserve(100);
  other.reserve(100);
  const long before = testing::allocations;
  for (const SwingProfile profile : kProfiles)
    curve.plan_swing({}, {.target = {0.3, 0, 0}, .profile = profile}, 0.5);
  curve.plan_target({}, {}, 0.5);
  curve.plan_trajectory({}, knots);
  other = curve;
  (void)other.at(0.3);
  EXPECT_EQ(testing::allocations, before);
}

}  // namespace
}  // namespace hexagait

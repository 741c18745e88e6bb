// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/curves/joint_curve.hpp>
#include <hexagait/sim/random.hpp>
#include <testing/counted_allocations.hpp>

namespace hexagait {
namespace {

LegJoints random_joints(RandomSequence& random, double size) {
  LegJoints joints;
  for (double& joint : joints) joint = random.uniform(-size, size);
  return joints;
}

JointCurve curve_of(const JointState& start, const std::vector<JointKnot>& knots) {
  JointCurve curve;
  curve.reserve(static_cast<int>(knots.size()));
  curve.plan(start, knots);
  return curve;
}

JointKnot knot_at(double time, const LegJoints& q) {
  JointKnot knot;
  knot.time = time;
  knot.q = q;
  return knot;
}

// The second joint has 0.6 rad to go, 0.3 rad/s: 2 s. Its peak there: 1.875 · 0.6 / 2.
TEST(JointDuration, IsThatOfTheLongestWay) {
  const LegJoints from = leg_joints({0.1, 0.2, 0.3}), to = leg_joints({0.2, -0.4, 0.3});
  EXPECT_NEAR(joint_duration(from, to, 0.3, 0.5), 2.0, 1e-15);
  EXPECT_EQ(joint_duration(from, to, 3.0, 0.5), 0.5);
  EXPECT_NEAR(peak_joint_velocity(from, to, 2.0)[1], 0.5625, 1e-15);
}

// The bound is reached, in the middle, and not passed.
TEST(JointTarget, IsReachedAtRestWithThePredictedPeakVelocity) {
  const LegJoints from = leg_joints({0.1, 0.2, 0.3}), to = leg_joints({0.5, -0.4, 1.0});
  const JointCurve curve = curve_of({.q = from}, {knot_at(0.8, to)});
  LegJoints fastest = LegJoints::Zero();
  for (int i = 0; i <= 1000; ++i)
    fastest = fastest.cwiseMax(curve.at(0.8 * i / 1000).qd.cwiseAbs());
  EXPECT_LT((fastest - peak_joint_velocity(from, to, 0.8)).norm(), 1e-14);
  EXPECT_EQ(curve.at(0.8).q, to);
  EXPECT_EQ(curve.at(9.0).qd, LegJoints::Zero());
  EXPECT_EQ(curve.at(-1.0).q, from);
}

// Knots with and without velocities, accelerations, efforts. Derivatives by differences; across
// knots the acceleration changes by no more than a jerk allows: 60 · 2 rad / (0.05 s)³ and the
// like.
TEST(JointTrajectory, IsContinuousUpToItsAccelerationAndPassesWhatIsGiven) {
  RandomSequence random{.seed = 1};
  for (int k = 0; k < 300; ++k) {
    std::vector<JointKnot> knots;
    double time = 0.0;
    for (int i = 0; i < 12; ++i) {
      time += random.uniform(0.05, 0.4);
      knots.push_back(knot_at(time, random_joints(random, 1.0)));
      if (random.u01() < 0.3) knots.back().qd = random_joints(random, 1.0);
      if (random.u01() < 0.3) knots.back().qdd[1] = random.uniform(-1.0, 1.0);
    }
    const JointState start{
        random_joints(random, 1), random_joints(random, 1), random_joints(random, 1), {}};
    const JointCurve curve = curve_of(start, knots);
    ASSERT_EQ(curve.at(0.0).qdd, start.qdd);
    for (const JointKnot& knot : knots) {
      const JointState now = curve.at(knot.time);
      ASSERT_LT((now.q - knot.q).norm(), 1e-14);
      if (knot.qd.allFinite()) {
        ASSERT_LT((now.qd - knot.qd).norm(), 1e-13);
      }
      if (std::isfinite(knot.qdd[1])) {
        ASSERT_NEAR(now.qdd[1], knot.qdd[1], 1e-11);
      }
    }
    const double e = 1e-7;
    for (double t = e; t < time - e; t += 0.013)
      for (const double at : {t, knots[static_cast<std::size_t>(t / time * 11)].time}) {
        const JointState left = curve.at(at - e), now = curve.at(at), right = curve.at(at + e);
        ASSERT_LT((right.q - left.q - 2 * e * now.qd).norm(), 1e-10);
        ASSERT_LT((right.qd - left.qd - 2 * e * now.qdd).norm(), 1e-7);
        ASSERT_LT((right.qdd - left.qdd).norm(), 2 * e * 2e6);
      }
  }
}

// 0, 0, 0, 1, 1, 1: rests where the data rest, rises in between, passes nothing.
TEST(JointTrajectory, DoesNotOvershootAStep) {
  std::vector<JointKnot> knots;
  for (const double time : {1.0, 2.0, 3.0, 4.0, 5.0})
    knots.push_back(knot_at(time, LegJoints::Constant(time > 2.5 ? 1.0 : 0.0)));
  const JointCurve curve = curve_of({}, knots);
  for (double t = 0.0; t <= 5.0; t += 0.01) {
    ASSERT_GE(curve.at(t).q[0], -1e-15);
    ASSERT_LE(curve.at(t).q[0], 1.0 + 1e-15);
    ASSERT_GE(curve.at(t).qd[0], -1e-14);
  }
}

// Random rising data, steps 0 … 1, uneven times. A parabola's acceleration at a knot can turn the
// joint back near it, by some percent of a step.
TEST(JointTrajectory, OvershootsRisingDataByAFewPercentOfAStepAtMost) {
  RandomSequence random{.seed = 2};
  double worst = 0.0;
  for (int k = 0; k < 500; ++k) {
    std::vector<JointKnot> knots;
    double time = 0.0, q = 0.0;
    for (int i = 0; i < 10; ++i) {
      time += random.uniform(0.1, 0.4);
      q += random.u01();
      knots.push_back(knot_at(time, LegJoints::Constant(q)));
    }
    const JointCurve curve = curve_of({}, knots);
    double highest = 0.0;
    for (double t = 0.0; t <= time; t += 0.002) {
      highest = std::max(highest, curve.at(t).q[0]);
      worst = std::max(worst, highest - curve.at(t).q[0]);
    }
  }
  EXPECT_LT(worst, 0.05);
}

// q = 0.3 t + 0.5 t², where it rises fast enough everywhere for no bound; the last interval brakes.
TEST(JointTrajectory, ReproducesDenseSamplesOfAParabola) {
  const auto q = [](double t) { return LegJoints(LegJoints::Constant(0.3 * t + 0.5 * t * t)); };
  std::vector<JointKnot> knots;
  for (int i = 1; i <= 20; ++i) knots.push_back(knot_at(0.1 * i, q(0.1 * i)));
  const JointState start{q(0), LegJoints::Constant(0.3), LegJoints::Constant(1.0), {}};
  const JointCurve curve = curve_of(start, knots);
  for (double t = 0.0; t < 1.9; t += 0.01) ASSERT_LT((curve.at(t).q - q(t)).norm(), 1e-13);
}

// From 2 N m to 6 N m in 1 s, then as before; only the first joint is told.
TEST(JointTrajectory, LeadsEffortsLinearly) {
  std::vector<JointKnot> knots = {knot_at(1.0, LegJoints::Zero()), knot_at(2.0, LegJoints::Zero())};
  knots[0].effort[0] = 6.0;
  const JointCurve curve = curve_of({.effort = leg_joints({2, 3, 4})}, knots);
  EXPECT_NEAR(curve.at(0.25).effort[0], 3.0, 1e-15);
  EXPECT_EQ(curve.at(0.25).effort[1], 3.0);
  EXPECT_NEAR(curve.at(1.5).effort[0], 6.0, 1e-15);
  EXPECT_EQ(curve.at(7.0).effort, leg_joints({6, 3, 4}));
}

// 0 → 1 rad/s in 1 s: ½ rad; then 1 rad/s for 2 s. The other joints stay.
TEST(JointTrajectory, IntegratesVelocitiesWithoutPositions) {
  std::vector<JointKnot> knots(2);
  knots[0].time = 1.0, knots[1].time = 3.0;
  knots[0].qd[1] = knots[1].qd[1] = 1.0;
  const JointCurve curve = curve_of({.q = leg_joints({0.1, 0.2, 0.3})}, knots);
  EXPECT_LT((curve.at(1.0).q - leg_joints({0.1, 0.7, 0.3})).norm(), 1e-15);
  EXPECT_LT((curve.at(3.0).q - leg_joints({0.1, 2.7, 0.3})).norm(), 1e-15);
  EXPECT_TRUE(curve.at(2.0).q.allFinite());
}

TEST(JointCurve, CanBeCopiedWithItsRoomAndAllocatesOnlyWhenItReserves) {
  std::vector<JointKnot> knots;
  for (int i = 1; i <= 50; ++i) knots.push_back(knot_at(0.1 * i, LegJoints::Constant(i)));
  JointCurve first;
  first.reserve(50);
  JointCurve curve = first;
  const long before = testing::allocations;
  curve.plan({}, knots);
  first = curve;
  EXPECT_EQ(testing::allocations, before);
  EXPECT_EQ(first.duration(), knots.back().time);
  EXPECT_EQ(first.at(9.0).q[0], 50.0);
  curve.plan({.q = leg_joints({1, 2, 3}), .effort = leg_joints({4, 5, 6})}, {});
  EXPECT_EQ(curve.at(1.0).q, leg_joints({1, 2, 3}));
  EXPECT_EQ(curve.at(1.0).effort, leg_joints({4, 5, 6}));
}

}  // namespace
}  // namespace hexagait

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/model/kinematics.hpp>
#include <hexagait/model/leg_pair.hpp>
#include <hexagait/sim/random.hpp>

namespace hexagait::leg_pair_test {
namespace {

// Of any lengths, signs, zeros and place of its hip. The knee bends one way.
LegModel random_leg(RandomSequence& random) {
  LegModel leg;
  leg.coxa = random.uniform(0.0, 0.2);
  leg.femur = random.uniform(0.1, 0.5);
  leg.tibia = leg.femur * random.uniform(0.8, 1.25);
  for (int k = 0; k < 3; ++k) {
    leg.joint_sign[k] = random.u01() < 0.5 ? -1.0 : 1.0;
    leg.joint_offset[k] = random.uniform(-1.0, 1.0);
    leg.X_BH.p[k] = random.uniform(-0.5, 0.5);
    leg.limits[k] = {-4.0, 4.0, 8.0, 100.0};
  }
  leg.X_BH.R = rotation({random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-3, 3)});
  leg.min_reach = 1.05 * std::abs(leg.femur - leg.tibia) + 0.02;
  leg.max_reach = 0.96 * (leg.femur + leg.tibia);
  return leg;
}

// Joint values of canonical yaw ±0.8, hip ±0.8 and knee 0.5 … 2.
LegJoints random_joints(const LegModel& leg, RandomSequence& random) {
  const Vector3 k(random.uniform(-0.8, 0.8), random.uniform(-0.8, 0.8), random.uniform(0.5, 2.0));
  LegJoints q = LegJoints::Zero();
  q.head<3>() = leg.joint_sign.cwiseProduct(k - leg.joint_offset);
  return q;
}

void expect_same(const LaneVector& values, int lane, const LegJoints& expected) {
  LegJoints joints = expected;
  put(values, lane, joints);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(joints[k], expected[k]) << "joint " << k;
}

LegPair::Angles angles(const LegJoints q[2], const LegTrig trig[2]) {
  return {three_lanes(q[0], q[1]), three_lanes(trig[0].c, trig[1].c),
          three_lanes(trig[0].s, trig[1].s)};
}

TEST(LegPair, HasTheTrigOfEachLegToTheLastBit) {
  RandomSequence random{.seed = 1};
  for (int trial = 0; trial < 2000; ++trial) {
    const LegModel leg[] = {random_leg(random), random_leg(random)};
    LegJoints q[] = {random_joints(leg[0], random), random_joints(leg[1], random)};
    if (trial % 7 == 0) q[trial % 2][1] = 1e7;  // beyond what is computed in pairs
    const LegPair::Angles both = LegPair(leg[0], leg[1]).trig(q[0], q[1]);
    for (int k = 0; k < 2; ++k) {
      const LegTrig expected = leg_trig(leg[k], q[k]);
      expect_same(both.c, k, expected.c);
      expect_same(both.s, k, expected.s);
    }
  }
}

// Feet that move by up to 3 cm: most are reached by little turns, and then to the last bit as by one
// leg; where one leg can't go on, the pair does not. Both must happen.
TEST(LegPair, GoesOnWhereBothLegsDoToTheLastBit) {
  RandomSequence random{.seed = 2};
  int went = 0, stayed = 0;
  for (int trial = 0; trial < 5000; ++trial) {
    LegModel leg[] = {random_leg(random), random_leg(random)};
    LegJoints q[2];
    LegTrig trig[2];
    Vector3 p_BF[2];
    LegSolution expected[2];
    for (int k = 0; k < 2; ++k) {
      q[k] = random_joints(leg[k], random);
      trig[k] = leg_trig(leg[k], q[k]);
      const double size = trial % 5 == 0 && k == 1 ? 0.3 : 0.03;
      p_BF[k] = foot_position(leg[k], trig[k]) +
                size * Vector3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      // At times a limit stands in the way.
      if (trial % 3 == 0) leg[k].limits[k].upper = q[k][k] + 0.01;
      expected[k] = inverse_kinematics(leg[k], p_BF[k], q[k], trig[k]);
    }
    LegPair::Angles to;
    if (!LegPair(leg[0], leg[1]).go_on(lanes(p_BF[0], p_BF[1]), angles(q, trig), to)) {
      ++stayed;
      continue;
    }
    ++went;
    for (int k = 0; k < 2; ++k) {
      EXPECT_TRUE(expected[k].reachable);
      expect_same(to.q, k, expected[k].q);
      expect_same(to.c, k, expected[k].trig.c);
      expect_same(to.s, k, expected[k].trig.s);
    }
  }
  EXPECT_GT(went, 1500);
  EXPECT_GT(stayed, 500);
}

TEST(LegPair, DoesNotGoToPlacesThatAreNone) {
  RandomSequence random{.seed = 3};
  const LegModel leg[] = {random_leg(random), random_leg(random)};
  const LegJoints q[] = {random_joints(leg[0], random), random_joints(leg[1], random)};
  const LegTrig trig[] = {leg_trig(leg[0], q[0]), leg_trig(leg[1], q[1])};
  const Vector3 there = foot_position(leg[1], trig[1]), here = foot_position(leg[0], trig[0]);
  const LegPair pair(leg[0], leg[1]);
  LegPair::Angles to;
  EXPECT_TRUE(pair.go_on(lanes(here, there), angles(q, trig), to));
  for (const double bad : {std::nan(""), HUGE_VAL, 1e300}) {
    EXPECT_FALSE(pair.go_on(lanes(here, Vector3(bad, 0.0, 0.0)), angles(q, trig), to));
    EXPECT_FALSE(pair.go_on(lanes(Vector3(0.0, 0.0, bad), there), angles(q, trig), to));
  }
  EXPECT_FALSE(pair.go_on(lanes(leg[0].X_BH.p, there), angles(q, trig), to)) << "too near";
}

// Of three legs the last one is alone.
TEST(ForwardKinematics, OfAllLegsIsThatOfEachToTheLastBit) {
  RandomSequence random{.seed = 4};
  for (int trial = 0; trial < 300; ++trial) {
    const int n = 3 + trial % 4;
    RobotModel model;
    model.legs = LegArray<LegModel>(n);
    LegArray<LegJoints> q(n);
    for (LegId i = 0; i < n; ++i) {
      model.legs[i] = random_leg(random);
      q[i] = random_joints(model.legs[i], random);
    }
    LegArray<LegTrig> trig(n);
    LegArray<Vector3> p_BF(n);
    forward_kinematics(model, q, trig, p_BF);
    for (LegId i = 0; i < n; ++i) {
      const LegTrig expected = leg_trig(model.legs[i], q[i]);
      EXPECT_EQ(trig[i].c, expected.c);
      EXPECT_EQ(trig[i].s, expected.s);
      EXPECT_EQ(p_BF[i], foot_position(model.legs[i], expected));
    }
  }
}

}  // namespace
}  // namespace hexagait::leg_pair_test

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/model/kinematics.hpp>
#include <hexagait/sim/random.hpp>

namespace hexagait::yaw_pitch_test {
namespace {

// Any hip, signs and zeros; axes and points at zero as a URDF would give them.
LegModel random_leg(RandomSequence& random) {
  LegModel leg;
  leg.kind = LegKind::yaw_pitch;
  leg.X_BH = {rotation_z(random.uniform(-3.0, 3.0)),
              {random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), random.uniform(-0.1, 0.1)}};
  leg.coxa = random.uniform(0.0, 0.05);
  leg.femur = random.uniform(0.05, 0.2);
  leg.joint_names = JointArray<std::string>(2);
  leg.limits = JointArray<JointLimits>(2);
  leg.limits[0] = {-0.9, 0.9, 6.0, 1.0};
  leg.limits[1] = {-1.4, 1.4, 6.0, 1.0};
  leg.links = JointArray<LinkModel>(2);
  for (int i = 0; i < 2; ++i) leg.joint_sign[i] = random.u01() < 0.5 ? -1.0 : 1.0;
  leg.joint_offset[1] = random.uniform(-0.5, 0.5);
  const auto [s, c] = portable::sincos(leg.joint_offset[1]);
  leg.p_BJ0 = leg.axis_B0 = JointArray<Vector3>(2, Vector3::Zero());
  leg.p_BJ0[0] = leg.X_BH.p;
  leg.p_BJ0[1] = leg.X_BH * Vector3(leg.coxa, 0.0, 0.0);
  for (int i = 0; i < 2; ++i) leg.axis_B0[i] = leg.joint_sign[i] * leg.X_BH.R.col(i == 0 ? 2 : 1);
  leg.p_BF0 = leg.X_BH * Vector3(leg.coxa + leg.femur * c, 0.0, -leg.femur * s);
  return leg;
}

LegJoints random_joints(const LegModel& leg, RandomSequence& random, double pitch) {
  LegJoints q = LegJoints::Zero();
  q[0] = random.uniform(-0.9, 0.9);
  q[1] = leg.joint_sign[1] * (random.uniform(-pitch, pitch) - leg.joint_offset[1]);
  return q;
}

TEST(YawPitch, PutsTheFootWhereTheProductOfRotationsDoes) {
  RandomSequence random{.seed = 1};
  for (int trial = 0; trial < 200; ++trial) {
    LegModel leg = random_leg(random);
    leg.links[1].X_BL0.p = leg.p_BF0;
    const LegJoints q = random_joints(leg, random, 1.4);
    EXPECT_LT((foot_position(leg, q) - link_pose(leg, 1, q).p).norm(), 1e-12);
    const Matrix3 turn = tibia_rotation(leg, leg_trig(leg, q)) *
                         tibia_rotation(leg, leg_trig(leg, LegJoints::Zero())).transpose();
    EXPECT_LT((turn - link_pose(leg, 1, q).R).norm(), 1e-12);
  }
}

TEST(YawPitch, HasTheJacobianOfFiniteDifferences) {
  RandomSequence random{.seed = 2};
  constexpr double kStep = 1e-6;
  for (int trial = 0; trial < 200; ++trial) {
    const LegModel leg = random_leg(random);
    const LegJoints q = random_joints(leg, random, 1.4);
    const LegTrig trig = leg_trig(leg, q);
    const LegJacobian J = foot_jacobian(leg, trig);
    const Vector3 force(random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9));
    for (int k = 0; k < kMaxLegJoints; ++k) {
      LegJoints more = q, less = q;
      more[k] += kStep, less[k] -= kStep;
      const Vector3 slope =
          k < 2 ? Vector3((foot_position(leg, more) - foot_position(leg, less)) / (2.0 * kStep))
                : Vector3(Vector3::Zero());
      EXPECT_LT((J.col(k) - slope).norm(), 1e-9) << k;
      EXPECT_NEAR(foot_effort(leg, trig, force)[k], slope.dot(force), 1e-8);
    }
    LegJoints dq = LegJoints::Zero();
    dq[0] = 1e-4, dq[1] = -2e-4;
    const Matrix3 turned = tibia_rotation(leg, leg_trig(leg, LegJoints(q + dq))) *
                           tibia_rotation(leg, trig).transpose();
    EXPECT_LT((tibia_turn(leg, trig, dq) - rotation_vector(turned)).norm(), 1e-11);
  }
}

// (leg 6): what is asked for fore and aft, and in height; across, whatever comes of it.
TEST(YawPitch, TakesThePlaceForeAndAftAndTheHeightThatAreAskedFor) {
  RandomSequence random{.seed = 3};
  for (int trial = 0; trial < 200; ++trial) {
    const LegModel leg = random_leg(random);
    const LegJoints q = random_joints(leg, random, 0.9);
    const Vector3 p_BF = foot_position(leg, q);
    const LegSolution there = inverse_kinematics(leg, p_BF);
    ASSERT_TRUE(there.reachable);
    EXPECT_LT((there.q - q).norm(), 1e-9);
    const Vector3 beside = p_BF + random.uniform(-0.1, 0.1) * leg.X_BH.R.col(0);
    EXPECT_TRUE(inverse_kinematics(leg, beside).reachable);
    EXPECT_LT((inverse_kinematics(leg, beside).q - q).norm(), 1e-9);
    EXPECT_LT((leg_trig(leg, there.q).s - there.trig.s).norm(), 1e-12);
  }
}

TEST(YawPitch, SaysWhatIsOutOfReach) {
  RandomSequence random{.seed = 4};
  const LegModel leg = random_leg(random);
  const double r = leg.coxa + leg.femur;
  const auto asked = [&](double y, double z) {
    const LegSolution solution = inverse_kinematics(leg, leg.X_BH * Vector3(r, y, z));
    EXPECT_TRUE(within_limits(leg, solution.q));
    return solution.reachable;
  };
  EXPECT_TRUE(asked(0.5 * r, 0.0));
  EXPECT_FALSE(asked(0.8 * r, 0.0)) << "beyond 0.9 rad, whose sine is 0.78";
  EXPECT_FALSE(asked(0.0, -1.01 * leg.femur)) << "below where it hangs straight down";
  EXPECT_FALSE(asked(1e9, 1e9));
}

}  // namespace
}  // namespace hexagait::yaw_pitch_test

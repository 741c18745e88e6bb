// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The robots of robots/ whose legs are serial, and how such legs come to their stance.
#include <gtest/gtest.h>

#include <hexagait/balance/stance_pose.hpp>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/model/serial_stance.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <testing/argos.hpp>
#include <testing/random_leg.hpp>
#include <testing/source_path.hpp>

namespace hexagait {
namespace {

const RobotModel& hexapod() {
  static const RobotModel model = load_urdf(testing::source_path("robots/hexapod_4dof.urdf"));
  return model;
}
const RobotModel& quadruped() {
  static const RobotModel model = load_urdf(testing::source_path("robots/quadruped_rpp.urdf"));
  return model;
}

std::string names_of(const RobotModel& robot) {
  std::string names;
  for (const LegModel& leg : robot.legs) names += leg.name + " ";
  return names;
}

// Coxa and femur out, 0.08 + 0.28 m; (0.28 + 0.22 + 0.16) / 2.2 = 0.3 m below: as argos stands.
TEST(HexapodOfFourJoints, StandsLikeArgos) {
  EXPECT_EQ(names_of(hexapod()), "LF RF LM RM LR RR ");
  EXPECT_NEAR(hexapod().mass, 50.0, 1e-12);
  EXPECT_LT(hexapod().p_BM.head<2>().norm(), 1e-6);
  const RobotModel argos = testing::argos();
  for (LegId i = 0; i < 6; ++i) {
    const LegModel& leg = hexapod().legs[i];
    EXPECT_EQ(leg.kind, LegKind::serial);
    EXPECT_EQ(leg.num_joints(), 4);
    EXPECT_LT((leg.p_BC - argos.legs[i].p_BC).norm(), 1e-9);
    EXPECT_GT(leg.workspace_radius, 0.15);
  }
}

// Thigh and shank have 0.54 m, 0.1 m outside of the hip: √(0.54² + 0.1²) is the longest reach, 0.66
// of 96 % of it the nominal height.
TEST(RollPitchPitch, StandsBelowItsHips) {
  EXPECT_EQ(names_of(quadruped()), "LF RF LH RH ");
  EXPECT_NEAR(quadruped().mass, 26.0, 1e-12);
  const double reach = 0.96 * std::hypot(0.54, 0.1);
  EXPECT_NEAR(quadruped().legs[0].max_reach, reach, 1e-6);
  EXPECT_LT((quadruped().legs[0].p_BC - Vector3(0.32, 0.24, -0.66 * reach)).norm(), 1e-6);
  EXPECT_LT((quadruped().legs[3].p_BC - Vector3(-0.32, -0.24, -0.66 * reach)).norm(), 1e-6);
}

// Yaw, roll and pitch intersect, 4.5 cm one from the other: a coxa of 9 cm. Femur and tibia have 18
// and 24 cm.
TEST(YawRollPitch, HasTheRollJointInItsCoxa) {
  const RobotModel beetle = load_urdf(testing::source_path("robots/beetle.urdf"));
  for (const LegModel& leg : beetle.legs) {
    const SerialLengths lengths = serial_lengths(leg);
    EXPECT_NEAR(lengths.coxa, 0.09, 1e-9);
    EXPECT_NEAR(lengths.upper, 0.18, 1e-9);
    EXPECT_NEAR(lengths.rest, 0.24, 1e-9);
    const Vector3 p_HC = leg.X_BH.inverse() * leg.p_BC;
    EXPECT_NEAR(p_HC.x(), 0.09 + 0.18, 1e-9);
    EXPECT_NEAR(p_HC.z(), -(0.18 + 0.24) / 2.2, 1e-9);
  }
}

// A joint that twists the femur, between its ends: its length counts, and the femur stays the femur.
TEST(YawPitchRollPitch, HasTheTwistInItsFemur) {
  LegModel leg = load_urdf(testing::source_path("robots/beetle.urdf")).legs[0];
  const Vector3 out = leg.X_BH.R.col(0), across = leg.X_BH.R.col(1), hip = leg.X_BH.p;
  leg.axis_B0[1] = across, leg.p_BJ0[1] = hip + 0.05 * out;
  leg.axis_B0[2] = out, leg.p_BJ0[2] = hip + 0.10 * out;
  leg.axis_B0[3] = across, leg.p_BJ0[3] = hip + 0.25 * out;
  leg.p_BF0 = hip + 0.55 * out;
  const SerialLengths lengths = serial_lengths(leg);
  EXPECT_NEAR(lengths.coxa, 0.05, 1e-9);
  EXPECT_NEAR(lengths.upper, 0.20, 1e-9);
  EXPECT_NEAR(lengths.rest, 0.30, 1e-9);
}

// The knee's 2.7 rad leave 0.54 cos 1.35 between pitch axis and foot, 0.1 m outside of the hip.
TEST(SerialReach, EndsWhereTheKneeIsBentMost) {
  const Reach reach = serial_reach(quadruped().legs[1]);
  EXPECT_NEAR(reach.min, std::hypot(0.54 * std::cos(1.35), 0.1), 1e-6);
}

// No posture is beyond it. (4 % of what is possible without limits are kept free at least.)
TEST(SerialReach, BoundsTheDistancesThatAreFoundByChance) {
  RandomSequence random{.seed = 31};
  for (int k = 0; k < 20; ++k) {
    const LegModel leg = testing::random_leg(3 + k % 4, random);
    double nearest = 1e9, farthest = 0.0;
    for (int trial = 0; trial < 3000; ++trial) {
      const double d =
          (testing::foot_by_rotations(leg, testing::random_joints(leg, random)) - leg.X_BH.p)
              .norm();
      nearest = std::min(nearest, d), farthest = std::max(farthest, d);
    }
    const Reach reach = serial_reach(leg);
    EXPECT_LT(farthest, reach.max / 0.96 + 1e-6);
    EXPECT_GT(nearest, reach.min - 0.05 * reach.max);
    EXPECT_GT(reach.max, 0.9 * farthest);
  }
}

// Knees towards the middle, as all else is equal; and mirrored left and right.
TEST(SerialStance, HasItsKneesInwardsAndIsMirrored) {
  for (LegId i = 0; i < 4; ++i) {
    const LegModel& leg = quadruped().legs[i];
    const Vector3 knee = link_pose(leg, 2, leg.q_nominal).p;
    EXPECT_LT(std::abs(knee.x()), std::abs(leg.X_BH.p.x()) - 0.05);
    const LegModel& other = quadruped().legs[i ^ 1];
    EXPECT_LT((leg.q_nominal - leg_joints({-1.0, 1.0, 1.0}).cwiseProduct(other.q_nominal)).norm(),
              1e-6);
  }
  for (LegId i = 0; i < 6; i += 2) {
    const LegJoints &left = hexapod().legs[i].q_nominal, &right = hexapod().legs[i + 1].q_nominal;
    EXPECT_LT((left.segment<3>(1) - right.segment<3>(1)).norm(), 1e-6);
    EXPECT_GT(link_pose(hexapod().legs[i], 2, left).p.z(), 0.0) << "knees above hips";
  }
}

// The foot gets everywhere within the disc, from any place in it to any other, far enough from
// limits and singularities.
TEST(SerialStance, LetsTheFootMoveAllOverItsWorkspace) {
  for (const RobotModel* robot : {&hexapod(), &quadruped()}) {
    RandomSequence random{.seed = 32};
    for (const LegModel& leg : robot->legs) {
      LegJoints near = leg.q_nominal;
      for (int k = 0; k < 300; ++k) {
        const double r = 0.99 * leg.workspace_radius * std::sqrt(random.u01());
        const Vector3 p_BF =
            leg.p_BC + rotation_z(random.uniform(-3.2, 3.2)) * Vector3(r, 0.0, 0.0);
        const LegSolution solution = inverse_kinematics(leg, p_BF, near);
        ASSERT_TRUE(solution.reachable) << leg.name << ' ' << (p_BF - leg.p_BC).transpose();
        EXPECT_GT(testing::dexterity_by_differences(leg, solution.q), 0.02);
        near = solution.q;
      }
    }
  }
}

// The base over feet that stand here and there: it is stable, all legs reach, and no pose around it
// is better by more than the clearances take.
TEST(StancePose, OfSerialLegsReachesItsFeetAndIsGood) {
  for (const RobotModel* robot : {&hexapod(), &quadruped()}) {
    RandomSequence random{.seed = 33};
    const int n = robot->num_legs();
    const double height = -robot->legs[0].p_BC.z();
    for (int trial = 0; trial < 100; ++trial) {
      StanceProblem problem{LegArray<Vector3>(n), LegSet::all(n), LegSet::all(n), height, 0.02, {}};
      for (LegId i = 0; i < n; ++i)
        problem.p_OF[i] = robot->legs[i].p_BC + 0.05 * testing::random_vector(random);
      const StancePose stance = optimise_stance(*robot, problem);
      EXPECT_TRUE(stance.reachable()) << robot->name << trial;
      EXPECT_GE(stance.margin, 0.02 - 1e-6);
      EXPECT_LT(stance.X_OB.p.norm(), 0.1);
    }
    // Too high for any leg: it comes as near as the shortest way leaves.
    StanceProblem problem{LegArray<Vector3>(n), LegSet::all(n), LegSet::all(n), 2.0, 0.02, {}};
    for (LegId i = 0; i < n; ++i) problem.p_OF[i] = robot->legs[i].p_BC;
    const StancePose stance = optimise_stance(*robot, problem);
    EXPECT_TRUE(stance.reachable()) << robot->name;
    EXPECT_GT(stance.X_OB.p.z(), 0.05);
  }
}

}  // namespace
}  // namespace hexagait

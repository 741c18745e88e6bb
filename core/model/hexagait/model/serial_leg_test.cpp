// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <hexagait/model/kinematics.hpp>
#include <testing/argos.hpp>
#include <testing/counted_allocations.hpp>
#include <testing/random_leg.hpp>

namespace hexagait {
namespace {

using namespace testing;

/// Legs of any shape with 3, 4, 5 and 6 joints.
class SerialLeg : public ::testing::TestWithParam<int> {
 protected:
  LegModel any_leg() { return random_leg(GetParam(), random_); }
  RandomSequence random_{.seed = 11, .trial = static_cast<std::uint32_t>(GetParam())};
};
INSTANTIATE_TEST_SUITE_P(Joints, SerialLeg, ::testing::Range(3, 7));

TEST_P(SerialLeg, PutsItsFootWhereTheProductOfRotationsDoes) {
  for (int k = 0; k < 60; ++k) {
    const LegModel leg = any_leg();
    const LegJoints q = random_joints(leg, random_);
    const LegTrig trig = leg_trig(leg, q);
    EXPECT_LT((foot_position(leg, trig) - foot_by_rotations(leg, q)).norm(), 1e-14);
    EXPECT_LT((tibia_rotation(leg, trig) - pose_of_last_link(leg, q).R).norm(), 1e-14);
  }
}

TEST_P(SerialLeg, HasTheJacobianOfFiniteDifferencesAndNoColumnsBeyond) {
  for (int k = 0; k < 60; ++k) {
    const LegModel leg = any_leg();
    const LegJoints q = random_joints(leg, random_);
    const LegJacobian J = foot_jacobian(leg, leg_trig(leg, q));
    EXPECT_LT((J - jacobian_by_differences(leg, q)).norm(), 1e-8);
    EXPECT_TRUE(J.rightCols(kMaxLegJoints - leg.num_joints()).isZero(0.0));
  }
}

// What is left out is of third order: with |dq| up to 6 · 0.01 = 0.06, some 0.06³ = 2e-4.
TEST_P(SerialLeg, TurnsItsLastLinkAsItsJointsTurnToSecondOrder) {
  for (int k = 0; k < 60; ++k) {
    const LegModel leg = any_leg();
    const LegJoints q = random_joints(leg, random_);
    LegJoints dq = LegJoints::Zero();
    for (int i = 0; i < leg.num_joints(); ++i) dq[i] = random_.uniform(-0.01, 0.01);
    const Matrix3 R = pose_of_last_link(leg, q + dq).R * pose_of_last_link(leg, q).R.transpose();
    const double third = std::pow(dq.cwiseAbs().sum(), 3);
    EXPECT_LT((tibia_turn(leg, leg_trig(leg, q), dq) - rotation_vector(R)).norm(), third);
  }
}

// From joints up to 0.2 rad beside, at places that are neither next to a singularity nor beyond the
// reach that is allowed.
TEST_P(SerialLeg, InverseKinematicsUndoesForwardKinematics) {
  int tried = 0, found = 0;
  for (int k = 0; k < 300; ++k) {
    const LegModel leg = any_leg();
    const LegJoints q = random_joints(leg, random_);
    const Vector3 p_BF = foot_by_rotations(leg, q);
    if (!is_within_reach(leg, p_BF) || dexterity_by_differences(leg, q) < 0.05) continue;
    LegJoints near = q;
    for (int i = 0; i < leg.num_joints(); ++i) near[i] += random_.uniform(-0.2, 0.2);
    const LegSolution solution = inverse_kinematics(leg, p_BF, near);
    ++tried;
    found += solution.reachable;
    if (!solution.reachable) continue;
    EXPECT_LT((foot_by_rotations(leg, solution.q) - p_BF).norm(), 1e-9);
    EXPECT_LT((leg_trig(leg, solution.q).c - solution.trig.c).norm(), 1e-15);
    EXPECT_LT((leg_trig(leg, solution.q).s - solution.trig.s).norm(), 1e-15);
  }
  EXPECT_EQ(found, tried);
}

void expect_within_limits(const LegModel& leg, const LegJoints& q) {
  for (int i = 0; i < leg.num_joints(); ++i) {
    EXPECT_LE(leg.limits[i].lower, q[i]);
    EXPECT_LE(q[i], leg.limits[i].upper);
  }
  EXPECT_TRUE(q.tail(kMaxLegJoints - leg.num_joints()).isZero(0.0));
}

TEST_P(SerialLeg, IsFiniteWithinItsLimitsAndHonestWhateverIsAsked) {
  for (int k = 0; k < 200; ++k) {
    const LegModel leg = any_leg();
    const double size = std::pow(10.0, random_.uniform(-3.0, k % 10 == 0 ? 300.0 : 1.0));
    const Vector3 p_BF = leg.X_BH.p + size * random_vector(random_);
    const LegSolution solution = inverse_kinematics(leg, p_BF, 3.0 * random_joints(leg, random_));
    ASSERT_TRUE(solution.q.allFinite());
    expect_within_limits(leg, solution.q);
    const double missing = (foot_by_rotations(leg, solution.q) - p_BF).norm();
    EXPECT_EQ(solution.reachable, missing < 1e-9) << missing;
  }
}

// Out of reach the foot is about as near as it gets around there: of 300 postures up to 0.05 rad
// beside, none has it nearer by more than 1 % of the reach. (Where the search comes to its bound of
// iterations it is not quite at its end: in 2 of 100 legs some millimetres are left.)
TEST_P(SerialLeg, ComesAsNearAsItCanAroundThere) {
  int stopped_early = 0, unreachable = 0;
  for (int k = 0; k < 200; ++k) {
    const LegModel leg = any_leg();
    const Vector3 way = random_vector(random_).normalized();
    const Vector3 p_BF = leg.X_BH.p + random_.uniform(leg.min_reach, leg.max_reach) * way;
    const LegSolution solution = inverse_kinematics(leg, p_BF);
    if (solution.reachable) continue;
    ++unreachable;
    const double missing = (foot_by_rotations(leg, solution.q) - p_BF).norm();
    double least = missing;
    for (int trial = 0; trial < 300; ++trial) {
      LegJoints q = solution.q;
      for (int i = 0; i < leg.num_joints(); ++i)
        q[i] = std::clamp(q[i] + random_.uniform(-0.05, 0.05), leg.limits[i].lower,
                          leg.limits[i].upper);
      least = std::min(least, (foot_by_rotations(leg, q) - p_BF).norm());
    }
    stopped_early += least < missing - 0.01 * leg.max_reach;
  }
  EXPECT_GT(unreachable, 10);
  EXPECT_EQ(stopped_early, 0);
}

// A circle of 3 cm radius, in 500 steps, twice: after the second round the joints are those after
// the first. Of legs that are dexterous all along.
TEST_P(SerialLeg, ComesBackToTheSameJointsOnAClosedPath) {
  int rounds = 0;
  for (int k = 0; k < 60; ++k) {
    const LegModel leg = any_leg();
    const Vector3 centre = foot_by_rotations(leg, leg.q_nominal);
    const Matrix3 R = rotation(3.0 * random_vector(random_));
    LegJoints q = leg.q_nominal, before = q;
    bool dexterous = true;
    for (int step = 1; step <= 1000 && dexterous; ++step) {
      const Vector3 p_BF =
          centre + R * rotation_z(step * std::numbers::pi / 250) * Vector3(0.03, 0, 0);
      const LegSolution solution = inverse_kinematics(leg, p_BF, q);
      q = solution.q;
      dexterous = solution.reachable && dexterity_by_differences(leg, q) > 0.1;
      if (step == 500) before = q;
    }
    if (!dexterous) continue;
    ++rounds;
    EXPECT_LT((q - before).cwiseAbs().maxCoeff(), 1e-6) << k;
  }
  EXPECT_GT(rounds, 4);
}

// What is left to the nominal joints, r, can't be made smaller without moving the foot: its part
// that J doesn't see is 0. Of legs that are dexterous there and away from their limits. Each joint counts
// in the room that it has about its nominal value.
TEST_P(SerialLeg, IsOfAllAnswersNearbyTheNearestToTheNominalJoints) {
  int settled = 0;
  for (int k = 0; k < 100; ++k) {
    const LegModel leg = any_leg();
    const Vector3 p_BF =
        foot_by_rotations(leg, leg.q_nominal) + 0.05 * random_vector(random_).normalized();
    LegSolution solution = inverse_kinematics(leg, p_BF);
    for (int tick = 0; tick < 20; ++tick) solution = inverse_kinematics(leg, p_BF, solution.q);
    bool free = solution.reachable && dexterity_by_differences(leg, solution.q) > 0.1;
    for (int i = 0; i < leg.num_joints(); ++i)
      free = free && leg.limits[i].lower < solution.q[i] && solution.q[i] < leg.limits[i].upper;
    if (!free) continue;
    ++settled;
    const int n = leg.num_joints();
    Eigen::VectorXd room = Eigen::VectorXd::Ones(n);
    for (int i = 0; n > 3 && i < n; ++i)
      room[i] = std::clamp(
          std::min(leg.q_nominal[i] - leg.limits[i].lower, leg.limits[i].upper - leg.q_nominal[i]),
          0.25, 1.0);
    const Eigen::MatrixXd J =
        jacobian_by_differences(leg, solution.q).leftCols(n) * room.asDiagonal();
    const Eigen::VectorXd r = (leg.q_nominal - solution.q).head(n).cwiseQuotient(room);
    const Eigen::VectorXd seen = J.transpose() * (J * J.transpose()).ldlt().solve(J * r);
    EXPECT_LT((r - seen).norm(), 1e-5);
  }
  EXPECT_GT(settled, 10);
}

TEST_P(SerialLeg, DoesNotAllocate) {
  const LegModel leg = any_leg();
  const long before = allocations;
  Vector3 sum = Vector3::Zero();
  for (int k = 0; k < 100; ++k) {
    const LegSolution solution =
        inverse_kinematics(leg, leg.X_BH.p + 0.5 * random_vector(random_), leg.q_nominal);
    sum += foot_jacobian(leg, solution.trig) * solution.q +
           tibia_turn(leg, solution.trig, solution.q) + foot_position(leg, solution.trig);
  }
  EXPECT_EQ(allocations, before);
  EXPECT_TRUE(sum.allFinite());
}

/// The legs of argos, and the same legs as if they were just serial.
class SerialArgos : public ::testing::TestWithParam<int> {
 protected:
  const LegModel leg_ = testing::argos().legs[GetParam()];
  const LegModel serial_ = [this] {
    LegModel leg = leg_;
    leg.kind = LegKind::serial;
    leg.q_nominal = inverse_kinematics(leg_, leg_.p_BC).q;
    leg.min_reach = 0.05, leg.max_reach = 0.73;  // 0.08 + 0.28 + 0.38 = 0.74
    return leg;
  }();
};
INSTANTIATE_TEST_SUITE_P(Legs, SerialArgos, ::testing::Range(0, 6));

TEST_P(SerialArgos, AgreesWithTheClosedForm) {
  RandomSequence random{.seed = 12};
  LegJoints near = serial_.q_nominal;
  for (int k = 0; k < 300; ++k) {
    const double r = leg_.workspace_radius * std::sqrt(random.u01());
    const Vector3 p_BF = leg_.p_BC + rotation_z(random.uniform(-4, 4)) * Vector3(r, 0.0, 0.0) +
                         Vector3(0.0, 0.0, random.uniform(-0.05, 0.05));
    const LegSolution closed = inverse_kinematics(leg_, p_BF);
    const LegSolution found = inverse_kinematics(serial_, p_BF, near);
    if (!closed.reachable) continue;
    EXPECT_TRUE(found.reachable);
    EXPECT_LT((foot_position(leg_, found.q) - p_BF).norm(), 1e-9);
    EXPECT_LT((found.q - closed.q).norm(), 1e-8);
    EXPECT_LT((foot_jacobian(serial_, found.trig) - foot_jacobian(leg_, closed.trig)).norm(), 1e-8);
    const LegJoints dq = 1e-3 * random_joints(leg_, random);
    EXPECT_LT((tibia_turn(serial_, found.trig, dq) - tibia_turn(leg_, closed.trig, dq)).norm(),
              1e-8);
    near = found.q;
  }
}

}  // namespace
}  // namespace hexagait

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/model/kinematics.hpp>
#include <hexagait/sim/random.hpp>
#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainjnttojacsolver.hpp>

namespace hexagait::kinematics_test {
namespace {

/// A leg at the hip frame X_BH whose joints have any signs and zeros: its axes and points stand
/// where the offsets turn them when all joints are zero. Canonical limits: yaw ±1.2, hip −1.8
/// … 1.5, knee 0.1 … 2.6.
LegModel leg_of(double coxa, double femur, double tibia, const Vector3& sign, const Vector3& offset,
                const Pose& X_BH) {
  const Pose coxa0 = X_BH * Pose{rotation_z(offset[0]), Vector3::Zero()};
  const Pose femur0 = coxa0 * Pose{rotation({0.0, offset[1], 0.0}), {coxa, 0.0, 0.0}};
  const Pose tibia0 = femur0 * Pose{rotation({0.0, offset[2], 0.0}), {femur, 0.0, 0.0}};
  LegModel leg;
  leg.X_BH = X_BH;
  leg.coxa = coxa, leg.femur = femur, leg.tibia = tibia;
  leg.joint_sign = sign, leg.joint_offset = offset;
  leg.links[0].X_BL0 = coxa0, leg.links[1].X_BL0 = femur0, leg.links[2].X_BL0 = tibia0;
  leg.p_BJ0 = {coxa0.p, femur0.p, tibia0.p};
  leg.axis_B0 = {sign[0] * coxa0.R.col(2), sign[1] * femur0.R.col(1), sign[2] * tibia0.R.col(1)};
  leg.p_BF0 = tibia0 * Vector3(tibia, 0.0, 0.0);

  const double lower[] = {-1.2, -1.8, 0.1}, upper[] = {1.2, 1.5, 2.6};
  for (int i = 0; i < 3; ++i) {
    const double a = sign[i] * (lower[i] - offset[i]), b = sign[i] * (upper[i] - offset[i]);
    leg.limits[i] = {std::min(a, b), std::max(a, b), 8.0, 100.0};
  }
  leg.min_reach = std::sqrt(femur * femur + tibia * tibia + 2.0 * femur * tibia * std::cos(2.6));
  leg.max_reach = 0.96 * (femur + tibia);
  return leg;
}

/// Coxa 0.1, femur 0.3, tibia 0.4, hip frame = body frame, joints canonical.
LegModel plain_leg() { return leg_of(0.1, 0.3, 0.4, Vector3::Ones(), Vector3::Zero(), Pose{}); }

/// Femur and tibia differ by at most a quarter, so that a knee of 2.6 rad is what limits the reach.
LegModel random_leg(RandomSequence& random) {
  const double femur = random.uniform(0.1, 0.5), tibia = femur * random.uniform(0.8, 1.25);
  Vector3 sign, offset, hip;
  for (int i = 0; i < 3; ++i) {
    sign[i] = random.u01() < 0.5 ? -1.0 : 1.0;
    offset[i] = random.uniform(-3.1, 3.1);
    hip[i] = random.uniform(-0.5, 0.5);
  }
  const Matrix3 R_BH = rotation_z(random.uniform(-3.1, 3.1));
  return leg_of(random.uniform(0.0, 0.2), femur, tibia, sign, offset, {R_BH, hip});
}

LegJoints random_joints(const LegModel& leg, RandomSequence& random) {
  LegJoints q = LegJoints::Zero();
  for (int i = 0; i < 3; ++i) {
    const JointLimits& limits = leg.limits[i];
    q[i] = random.uniform(limits.lower, limits.upper);
  }
  return q;
}

double distance(const Vector3& a, const Vector3& b) { return (a - b).norm(); }

Vector3 kdl_foot(const LegModel& leg, const LegJoints& q, Matrix3* jacobian = nullptr) {
  const auto vector = [](const Vector3& v) { return KDL::Vector(v.x(), v.y(), v.z()); };
  // Frames parallel to B at joint zero, each at the next joint's point, the last one at the foot.
  const Vector3 points[] = {Vector3::Zero(), leg.p_BJ0[1], leg.p_BJ0[2], leg.p_BF0};
  KDL::Chain chain;
  for (int i = 0; i < 3; ++i) {
    const KDL::Joint joint("", vector(leg.p_BJ0[i] - points[i]), vector(leg.axis_B0[i]),
                           KDL::Joint::RotAxis);
    chain.addSegment(KDL::Segment("", joint, KDL::Frame(vector(points[i + 1] - points[i]))));
  }
  KDL::JntArray joints(3);
  joints.data = q.head<3>();
  KDL::Frame foot;
  KDL::ChainFkSolverPos_recursive(chain).JntToCart(joints, foot);
  if (jacobian != nullptr) {
    KDL::Jacobian full(3);
    KDL::ChainJntToJacSolver(chain).JntToJac(joints, full);
    *jacobian = full.data.topRows<3>();
  }
  return {foot.p.x(), foot.p.y(), foot.p.z()};
}

// Straight out: 0.1 + 0.3 + 0.4.
TEST(FootPosition, OfTheStraightLegIsItsLengthOutwards) {
  const Vector3 p = foot_position(plain_leg(), LegJoints::Zero());
  EXPECT_EQ(p, Vector3(0.1 + 0.3 + 0.4, 0.0, 0.0));
}

// Yaw 90°: outwards is y. Femur 30° up: 0.3·cos 30° out, 0.15 up. Knee 120°: the tibia hangs down.
TEST(FootPosition, FollowsYawRaisedFemurAndHangingTibia) {
  const Vector3 p =
      foot_position(plain_leg(), leg_joints({std::numbers::pi / 2, -std::numbers::pi / 6,
                                             std::numbers::pi / 6 + std::numbers::pi / 2}));
  EXPECT_LT(distance(p, {0.0, 0.1 + 0.15 * std::sqrt(3.0), 0.15 - 0.4}), 1e-15);
}

// q = sign · (k − offset): with sign −1 and offset 0.5, k = 0 is q = 0.5 and k = 1 is q = −0.5.
TEST(FootPosition, HeedsSignsAndZerosOfTheJoints) {
  LegModel leg = plain_leg();
  leg.joint_sign = -Vector3::Ones();
  leg.joint_offset = Vector3::Constant(0.5);
  EXPECT_LT(distance(foot_position(leg, leg_joints({-0.5, 0.5, -0.5})),
                     foot_position(plain_leg(), leg_joints({1.0, 0.0, 1.0}))),
            1e-15);
}

// Two oracles that know axes and points only: products of rotations, and KDL.
// Lengths are below 2 m and angles below 10 rad, hence a dozen roundings of 2e-15 at most.
TEST(FootPosition, IsThatOfTheProductOfRotationsAndOfKdl) {
  RandomSequence random{.seed = 11};
  for (int k = 0; k < 500; ++k) {
    const LegModel leg = random_leg(random);
    const LegJoints q = random_joints(leg, random);
    const Vector3 p_BF = foot_position(leg, q);
    EXPECT_LT(distance(p_BF, link_pose(leg, 2, q) * Vector3(leg.tibia, 0.0, 0.0)), 2e-14);
    EXPECT_LT(distance(p_BF, kdl_foot(leg, q)), 2e-14);
  }
}

TEST(LinkPose, PutsEachLinkOriginAtTheEndOfTheOneBefore) {
  RandomSequence random{.seed = 12};
  for (int k = 0; k < 100; ++k) {
    const LegModel leg = random_leg(random);
    const LegJoints q = random_joints(leg, random);
    EXPECT_LT(distance(link_pose(leg, 0, q).p, leg.X_BH.p), 1e-14);
    EXPECT_LT(distance(link_pose(leg, 0, q) * Vector3(leg.coxa, 0, 0), link_pose(leg, 1, q).p),
              1e-14);
    EXPECT_LT(distance(link_pose(leg, 1, q) * Vector3(leg.femur, 0, 0), link_pose(leg, 2, q).p),
              1e-14);
  }
}

// The tibia frame is that of the third link, whose x is along the tibia in these models.
TEST(TibiaRotation, IsThatOfTheThirdLink) {
  RandomSequence random{.seed = 13};
  for (int k = 0; k < 100; ++k) {
    const LegModel leg = random_leg(random);
    const LegJoints q = random_joints(leg, random);
    EXPECT_LT((tibia_rotation(leg, leg_trig(leg, q)) - link_pose(leg, 2, q).R).norm(), 2e-14);
  }
}

// Straight out along x: yaw moves the foot along y by its 0.8 m; a pitch moves it down by what is
// beyond its axis, 0.7 and 0.4 m.
TEST(FootJacobian, OfTheStraightLegHoldsTheLeverArms) {
  const LegModel leg = plain_leg();
  Matrix3 expected;
  expected << 0.0, 0.0, 0.0, 0.8, 0.0, 0.0, 0.0, -0.7, -0.4;
  EXPECT_LT((foot_jacobian(leg, leg_trig(leg, LegJoints::Zero())).leftCols<3>() - expected).norm(),
            1e-15);
}

// Central differences with step h err by h²/6 · |p'''| < 1e-11 and by rounding 2e-15/h ~ 5e-10.
TEST(FootJacobian, IsTheDerivativeOfTheFootAndThatOfKdl) {
  constexpr double h = 4e-6;
  RandomSequence random{.seed = 14};
  for (int k = 0; k < 300; ++k) {
    const LegModel leg = random_leg(random);
    const LegJoints q = random_joints(leg, random);
    const Matrix3 J = foot_jacobian(leg, leg_trig(leg, q)).leftCols<3>();
    for (int i = 0; i < 3; ++i) {
      const LegJoints step = h * LegJoints::Unit(i);
      const Vector3 slope =
          (foot_position(leg, LegJoints(q + step)) - foot_position(leg, LegJoints(q - step))) /
          (2.0 * h);
      EXPECT_LT(distance(J.col(i), slope), 2e-9);
    }
    Matrix3 J_kdl;
    kdl_foot(leg, q, &J_kdl);
    EXPECT_LT((J - J_kdl).norm(), 2e-14);
  }
}

TEST(FootEffort, IsTheForceThroughTheJacobian) {
  RandomSequence random{.seed = 22};
  for (int k = 0; k < 1000; ++k) {
    LegModel leg = random_leg(random);
    if (k % 2 == 1) leg.kind = LegKind::serial;
    const LegTrig trig = leg_trig(leg, random_joints(leg, random));
    const Vector3 force(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    const LegJoints expected = foot_jacobian(leg, trig).transpose() * force;
    ASSERT_LT((foot_effort(leg, trig, force) - expected).norm(), 1e-15) << k;
  }
}

// 3-4-5: the foot straight below the hip-pitch axis, 0.5 m. The knee is square, and the femur is
// turned down by the angle between hypotenuse and 0.3 less than 90°: atan(3/4).
TEST(InverseKinematics, SolvesTheThreeFourFiveTriangle) {
  const LegSolution solution = inverse_kinematics(plain_leg(), {0.1, 0.0, -0.5});
  EXPECT_TRUE(solution.reachable);
  EXPECT_LT(distance(solution.q.head<3>(), {0.0, std::atan2(0.3, 0.4), std::numbers::pi / 2}),
            1e-15);
}

// Within reach, with the knee bent upwards, there is one answer. Yaw is as good as its lever |r| is
// long; hip and knee lose digits where the leg is nearly straight or folded, tenfold within limits.
TEST(InverseKinematics, UndoesForwardKinematics) {
  RandomSequence random{.seed = 15};
  int solved = 0;
  for (int k = 0; k < 3000; ++k) {
    const LegModel leg = random_leg(random);
    const LegJoints q = random_joints(leg, random);
    const LegTrig trig = leg_trig(leg, q);
    const double a = leg.femur * trig.c[1] + leg.tibia * trig.c[2];
    const double b = leg.femur * trig.s[1] + leg.tibia * trig.s[2];
    const double lever = std::abs(leg.coxa + a);
    if (std::hypot(a, b) > leg.max_reach || lever < 1e-3) continue;

    const LegSolution solution = inverse_kinematics(leg, foot_position(leg, trig));
    EXPECT_TRUE(solution.reachable);
    EXPECT_LT(distance(solution.q.head<3>(), q.head<3>()), 2e-14 + 2e-15 / lever);
    ++solved;
  }
  EXPECT_GT(solved, 1500);
}

// A foot that moves little or much: from any other solution, the joints are those found without one.
TEST(InverseKinematics, FromTheLastSolutionIsTheSame) {
  RandomSequence random{.seed = 21};
  int reached = 0;
  for (int k = 0; k < 3000; ++k) {
    const LegModel leg = random_leg(random);
    const LegJoints near = random_joints(leg, random);
    const double most = std::pow(10.0, random.uniform(-6.0, 0.5));
    LegJoints q = near;
    for (int i = 0; i < 3; ++i) q[i] += random.uniform(-most, most);
    const Vector3 p_BF = foot_position(leg, q);
    const LegSolution expected = inverse_kinematics(leg, p_BF);
    const LegSolution found = inverse_kinematics(leg, p_BF, near, leg_trig(leg, near));
    ASSERT_EQ(found.reachable, expected.reachable) << k;
    ASSERT_LT((found.q - expected.q).norm(), 1e-12) << k;
    ASSERT_LT((found.trig.c - expected.trig.c).norm(), 1e-13) << k;
    ASSERT_LT((found.trig.s - expected.trig.s).norm(), 1e-13) << k;
    reached += expected.reachable;
  }
  EXPECT_GT(reached, 1500);
}

// Once round an ellipse, 20 000 times: each solution starts from the one before. Rounding errors of
// some 1e-15 rad a tick add up as those of a random walk do, to 1e-15 · √2e6 = 1.4e-12; here is three
// times that.
TEST(InverseKinematics, GoesOnFromTheLastSolutionForManyTicks) {
  const LegModel leg = plain_leg();
  LegSolution last = inverse_kinematics(leg, {0.45, 0.0, -0.25});
  for (int k = 0; k < 2'000'000; ++k) {
    const double x = 0.02 * std::numbers::pi * k;
    const Vector3 p_BF(0.45 + 0.05 * std::cos(x), 0.08 * std::sin(x), -0.25 + 0.05 * std::sin(x));
    last = inverse_kinematics(leg, p_BF, last.q, last.trig);
    if (k % 1000 != 0) continue;
    const LegSolution expected = inverse_kinematics(leg, p_BF);
    ASSERT_TRUE(last.reachable);
    ASSERT_LT((last.q - expected.q).norm(), 4.2e-12) << k;
  }
}

// Any point in a ball larger than the leg: "reachable" and "the foot is there" are the same, the
// joints are within limits, and the trig is that of the joints.
TEST(InverseKinematics, SaysReachableExactlyWhereTheFootGets) {
  RandomSequence random{.seed = 16};
  int reached = 0, missed = 0;
  for (int k = 0; k < 3000; ++k) {
    const LegModel leg = random_leg(random);
    const double size = 1.2 * (leg.coxa + leg.femur + leg.tibia);
    const Vector3 p_BF = leg.X_BH.p + size * Vector3(random.uniform(-1, 1), random.uniform(-1, 1),
                                                     random.uniform(-1, 1));
    const LegSolution solution = inverse_kinematics(leg, p_BF);
    const double error = distance(foot_position(leg, solution.trig), p_BF);
    EXPECT_EQ(solution.reachable, error < 1e-8) << error;
    EXPECT_TRUE(within_limits(leg, solution.q));
    EXPECT_LT(distance(foot_position(leg, solution.trig), foot_position(leg, solution.q)), 1e-14);
    (solution.reachable ? reached : missed) += 1;
  }
  EXPECT_GT(reached, 200);
  EXPECT_GT(missed, 200);
}

TEST(InverseKinematics, IsFiniteAndWithinLimitsWhereDirectionsAreLost) {
  const LegModel leg = plain_leg();
  const Vector3 points[] = {{0.0, 0.0, 0.0},    {0.1, 0.0, 0.0},        {0.0, 0.0, -0.4},
                            {0.0, 0.0, 0.4},    {1e-300, 0.0, -0.4},    {0.1, 1e-200, 1e-200},
                            {1e300, 0.0, 0.0},  {-1e300, 1e308, 1e308}, {0.0, 0.0, -1e300},
                            {-0.0, -0.0, -0.4}, {-0.3, 0.0, 0.0},       {0.8, 0.0, 0.0}};
  for (const Vector3& p : points) {
    const LegSolution solution = inverse_kinematics(leg, p);
    EXPECT_TRUE(solution.q.allFinite()) << p.transpose();
    EXPECT_TRUE(within_limits(leg, solution.q)) << p.transpose();
    EXPECT_LT(distance(foot_position(leg, solution.trig), foot_position(leg, solution.q)), 1e-14);
    EXPECT_EQ(solution.reachable, distance(foot_position(leg, solution.q), p) < 1e-8);
  }
}

// Within 1e-12 m of the yaw axis the direction is noise.
TEST(InverseKinematics, TakesYawZeroOnTheYawAxis) {
  const LegSolution solution = inverse_kinematics(plain_leg(), {-1e-13, 1e-14, -0.4});
  EXPECT_TRUE(solution.reachable);
  EXPECT_EQ(solution.q[0], 0.0);
  EXPECT_EQ(solution.trig.c[0], 1.0);
}

// On the line from the hip-pitch axis (0.1, 0, 0) to the target, at 0.96 · 0.7 m.
TEST(InverseKinematics, PointsTheStretchedLegAtWhatIsTooFar) {
  const LegSolution solution = inverse_kinematics(plain_leg(), {0.1 + 3.0, 0.0, -4.0});
  EXPECT_FALSE(solution.reachable);
  const Vector3 expected(0.1 + 0.6 * 0.672, 0.0, -0.8 * 0.672);
  EXPECT_LT(distance(foot_position(plain_leg(), solution.q), expected), 1e-14);
}

// Yaw stops at 1.2 rad; a target 0.3 rad further is seen 0.4·cos 0.3 out in that plane.
TEST(InverseKinematics, ReachesForTheProjectionOfWhatIsBeyondTheYawLimit) {
  const double out = 0.4, r = out * std::cos(0.3);
  const LegSolution solution =
      inverse_kinematics(plain_leg(), {out * std::cos(1.5), out * std::sin(1.5), -0.4});
  EXPECT_FALSE(solution.reachable);
  EXPECT_EQ(solution.q[0], 1.2);
  const Vector3 expected(r * std::cos(1.2), r * std::sin(1.2), -0.4);
  EXPECT_LT(distance(foot_position(plain_leg(), solution.q), expected), 1e-14);
}

// 0.05 m behind the yaw axis: yaw π is beyond the limits, but the leg can be turned in by the hip.
TEST(InverseKinematics, ReachesBackThroughTheYawAxis) {
  const LegSolution solution = inverse_kinematics(plain_leg(), {-0.05, 0.0, -0.5});
  EXPECT_TRUE(solution.reachable);
  EXPECT_EQ(solution.q[0], 0.0);
  EXPECT_LT(distance(foot_position(plain_leg(), solution.q), {-0.05, 0.0, -0.5}), 1e-15);
}

// The same knee, one turn on, for a robot that counts its knee so.
TEST(InverseKinematics, FindsTheTurnThatTheLimitsMean) {
  LegModel leg = plain_leg();
  leg.limits[2].lower += 2.0 * std::numbers::pi;
  leg.limits[2].upper += 2.0 * std::numbers::pi;
  const LegSolution solution = inverse_kinematics(leg, {0.1, 0.0, -0.5});
  EXPECT_TRUE(solution.reachable);
  EXPECT_NEAR(solution.q[2], 2.5 * std::numbers::pi, 2e-15);
}

// The knee is above the line from hip to foot: cross product of foot and knee, seen from the hip.
TEST(InverseKinematics, KeepsTheKneeUp) {
  RandomSequence random{.seed = 17};
  const LegModel leg = plain_leg();
  for (int k = 0; k < 500; ++k) {
    const Vector3 p(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    const LegSolution s = inverse_kinematics(leg, p);
    const Vector2 knee(leg.femur * s.trig.c[1], -leg.femur * s.trig.s[1]);
    const Vector2 foot = knee + Vector2(leg.tibia * s.trig.c[2], -leg.tibia * s.trig.s[2]);
    EXPECT_GT(cross(foot, knee), 0.0);
  }
}

// Mirrored in the plane y = 0, a leg and its target have the opposite yaw and the same pitches, to
// the bit.
TEST(InverseKinematics, OfTheMirroredLegMirrorsYaw) {
  RandomSequence random{.seed = 18};
  const Pose hip{rotation_z(1.1), {0.3, 0.2, 0.0}},
      mirrored_hip{rotation_z(-1.1), {0.3, -0.2, 0.0}};
  const LegModel left = leg_of(0.1, 0.3, 0.4, {1, 1, 1}, {0, 0, 0}, hip);
  const LegModel right = leg_of(0.1, 0.3, 0.4, {1, 1, 1}, {0, 0, 0}, mirrored_hip);
  for (int k = 0; k < 500; ++k) {
    const Vector3 p(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    const LegSolution l = inverse_kinematics(left, p);
    const LegSolution r = inverse_kinematics(right, {p.x(), -p.y(), p.z()});
    EXPECT_EQ(l.reachable, r.reachable);
    EXPECT_EQ(leg_joints({-l.q[0], l.q[1], l.q[2]}), r.q);
  }
}

TEST(WithinLimits, AllowsRoundingOnly) {
  const LegModel leg = plain_leg();
  EXPECT_TRUE(within_limits(leg, leg_joints({1.2 + 0.9e-9, -1.8 - 0.9e-9, 2.6})));
  EXPECT_FALSE(within_limits(leg, leg_joints({1.2 + 1.1e-9, 0.0, 1.0})));
  EXPECT_FALSE(within_limits(leg, leg_joints({0.0, -1.8 - 1.1e-9, 1.0})));
  EXPECT_FALSE(within_limits(leg, leg_joints({0.0, 0.0, 0.09})));
}

}  // namespace
}  // namespace hexagait::kinematics_test

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/model/kinematics.hpp>
#include <hexagait/model/workspace.hpp>

namespace hexagait {
namespace {

/// Coxa 0.1, femur 0.3, tibia 0.4, hip frame = body frame, joints canonical.
LegModel leg_with_limits(double yaw, double knee_lower, double knee_upper) {
  LegModel leg;
  leg.coxa = 0.1, leg.femur = 0.3, leg.tibia = 0.4;
  leg.limits = {{-yaw, yaw}, {-2.0, 2.0}, {knee_lower, knee_upper}};
  leg.min_reach = leg_reach(leg).min, leg.max_reach = leg_reach(leg).max;
  leg.p_BC = nominal_foot(leg);
  return leg;
}

// 3-4-5: a square knee gives 0.5 m; 4 % of 0.7 m are kept from 0.7 and from 0.4 − 0.3.
TEST(LegReach, GoesFromTheMostBentKneeToNearlyStraight) {
  const Reach square = leg_reach(leg_with_limits(1.0, 0.0, std::numbers::pi / 2));
  EXPECT_NEAR(square.min, 0.5, 1e-15);
  EXPECT_NEAR(square.max, 0.7 - 0.028, 1e-15);
  const Reach folded = leg_reach(leg_with_limits(1.0, std::numbers::pi / 2, std::numbers::pi));
  EXPECT_NEAR(folded.min, 0.1 + 0.028, 1e-15);
  EXPECT_NEAR(folded.max, 0.5, 1e-15);
}

TEST(LegReach, KeepsFromFoldedAlsoIfTheFemurIsTheLongerOne) {
  LegModel leg = leg_with_limits(1.0, 0.0, std::numbers::pi);
  std::swap(leg.femur, leg.tibia);
  EXPECT_NEAR(leg_reach(leg).min, 0.1 + 0.028, 1e-15);
}

// A knee that counts the other way, from a zero at the square knee: the limits −1 … 0 then are
// canonical π/2 … π/2 + 1, also a whole turn on.
TEST(LegReach, HeedsSignZeroAndTurnsOfTheKnee) {
  LegModel leg = leg_with_limits(1.0, -1.0, 0.0);
  leg.joint_sign[2] = -1.0;
  leg.joint_offset[2] = std::numbers::pi / 2;
  EXPECT_NEAR(leg_reach(leg).max, 0.5, 1e-15);
  EXPECT_NEAR(leg_reach(leg).min, std::sqrt(0.25 + 0.24 * std::cos(std::numbers::pi / 2 + 1.0)),
              1e-15);
  leg.joint_offset[2] -= 2.0 * std::numbers::pi;
  EXPECT_NEAR(leg_reach(leg).max, 0.5, 1e-15);
}

// The knee is straight, then folded, inside of these limits: cosines beyond do not count.
TEST(LegReach, EndsAtTheStraightAndAtTheFoldedLeg) {
  EXPECT_NEAR(leg_reach(leg_with_limits(1.0, -1.0, 2.0)).max, 0.7 - 0.028, 1e-15);
  EXPECT_NEAR(leg_reach(leg_with_limits(1.0, 1.0, 4.0)).min, 0.1 + 0.028, 1e-15);
}

TEST(LegReach, IsEmptyIfTheKneeBendsDownwardsOnly) {
  const Reach reach = leg_reach(leg_with_limits(1.0, -2.0, -0.5));
  EXPECT_GT(reach.min, reach.max);
}

// Turned by 90° and shifted: 0.1 + 0.3 out, 0.7/2.2 down.
TEST(NominalFoot, IsACoxaAndAFemurOut) {
  LegModel leg = leg_with_limits(1.0, 0.0, 2.6);
  leg.X_BH = {rotation_z(std::numbers::pi / 2), {1.0, 2.0, 3.0}};
  EXPECT_LT((nominal_foot(leg) - Vector3(1.0, 2.4, 3.0 - 0.7 / 2.2)).norm(), 1e-15);
}

// The disc touches the vertical planes at the yaw limits: radius 0.4 · sin 0.3. Of 120 directions
// one is at most 1.5° off the touching point, where the planes are 1/cos 1.5° = 1.00035 times as
// far.
TEST(ReachableRadius, IsLimitedByYaw) {
  const double touching = 0.4 * std::sin(0.3);
  const double radius = reachable_radius(leg_with_limits(0.3, 0.0, 2.6));
  EXPECT_GE(radius, touching * (1.0 - 1e-9));
  EXPECT_LE(radius, touching * 1.00035);
}

// Outwards, direction 0 of the 120, the foot may be 0.5 m from the hip-pitch axis (square knee) at
// the height 0.7/2.2, so √(0.25 − 0.7²/2.2²) out of it, 0.3 of which is the nominal stance. The
// reach has 1e-9 m of slack, which are 1e-9 · 0.5/0.386 along the horizontal.
TEST(ReachableRadius, IsLimitedByReach) {
  LegModel leg = leg_with_limits(1.0, std::numbers::pi / 2, 2.6);
  leg.X_BH = {rotation_z(0.026), {1.0, 2.0, 3.0}};
  leg.p_BC = nominal_foot(leg);
  const double height = 0.7 / 2.2;
  EXPECT_NEAR(reachable_radius(leg), std::sqrt(0.25 - height * height) - 0.3, 1.4e-9);
}

TEST(ReachableRadius, IsAtMostAThirdOfTheLeg) {
  EXPECT_EQ(reachable_radius(leg_with_limits(1.4, 0.0, 2.6)), (0.3 + 0.4) / 3.0);
}

}  // namespace
}  // namespace hexagait

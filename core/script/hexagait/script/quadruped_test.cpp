// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/model/kinematics.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <testing/source_path.hpp>

namespace hexagait {
namespace {

const std::string kQuadrupedPath = testing::source_path("robots/quadruped.urdf");

// 18 + 4 · (0.6 + 0.8 + 0.6); hips 0.24 m · (cos 45°, sin 45°) inwards of the feet, (0.2 + 0.36) /
// 2.2 above them, 0.16 m below the origin.
TEST(Quadruped, StandsOnFourFeetUnderItsCentreOfMass) {
  const RobotModel robot = load_urdf(kQuadrupedPath);
  std::string names;
  for (const LegModel& leg : robot.legs) names += leg.name + " ";
  EXPECT_EQ(names, "LF RF LH RH ");
  EXPECT_NEAR(robot.mass, 26.0, 1e-12);
  EXPECT_LT(robot.p_BM.head<2>().norm(), 1e-12);
  EXPECT_LT((robot.legs[0].p_BC - Vector3(0.32, 0.24, -0.16 - 0.56 / 2.2)).norm(), 2e-6);
  EXPECT_LT((robot.legs[3].p_BC - Vector3(-0.32, -0.24, -0.16 - 0.56 / 2.2)).norm(), 2e-6);
}

void expect_reached(const LegModel& leg, const Vector3& p_BF) {
  const LegSolution solution = inverse_kinematics(leg, p_BF);
  EXPECT_TRUE(solution.reachable) << leg.name << ' ' << p_BF.transpose();
  EXPECT_LT((foot_position(leg, solution.q) - p_BF).norm(), 1e-9);
  for (int i = 0; i < 3; ++i) {
    const JointLimits& limits = leg.limits[i];
    EXPECT_GT(std::min(solution.q[i] - limits.lower, limits.upper - solution.q[i]), 0.05)
        << leg.name << " joint " << i << ' ' << p_BF.transpose();
  }
}

// [FG16] IV-A: the right fore foot at (0.39, -0.24, 0.20) in the footprint, the base 0.38 and 0.45
// m above the feet and moved by up to 0.08 m each way towards the three feet that stand, with more
// than 0.05 rad left at every joint.
TEST(Quadruped, CanDoThePushUpOnThreeLegs) {
  const RobotModel robot = load_urdf(kQuadrupedPath);
  for (const double height : {0.38, 0.415, 0.45})
    for (const double back : {0.0, 0.04, 0.08})
      for (const double left : {0.0, 0.04, 0.08}) {
        const Vector3 base(-back, left, height);
        expect_reached(robot.legs[0], Vector3(0.32, 0.24, 0.0) - base);
        expect_reached(robot.legs[1], Vector3(0.39, -0.24, 0.20) - base);
        expect_reached(robot.legs[1], Vector3(0.32, -0.24, 0.0) - base);
        expect_reached(robot.legs[2], Vector3(-0.32, 0.24, 0.0) - base);
        expect_reached(robot.legs[3], Vector3(-0.32, -0.24, 0.0) - base);
      }
}

}  // namespace
}  // namespace hexagait

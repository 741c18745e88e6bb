// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/footstep_gen/generator.hpp>
#include <hexagait/model/kinematics.hpp>
#include <testing/kinematic_plant.hpp>

namespace hexagait::footstep_gen {
namespace {

using heading_control::Heading;
using heading_control::Turn;

/// A robot that stands in its nominal stance, with yaw joints of so much to both sides.
struct Standing {
  RobotModel robot = testing::robot_of(6);
  RobotState state;

  explicit Standing(double yaw) {
    state.print_O = LegArray<Vector3>(6);
    for (LegId i = 0; i < 6; ++i) {
      robot.legs[i].limits[0].lower = -yaw;
      robot.legs[i].limits[0].upper = yaw;
      state.print_O[i] = robot.legs[i].p_BC;
    }
  }
  // Turning in place, half a step of 0.1 m and so much to come; the body is at odom's origin.
  [[nodiscard]] Vector3 foothold(LegId leg, double to_come) const {
    const heading_control::PathArc arc = path_arc(Heading::spin(Turn::ccw), nominal_stance(robot));
    return footstep(robot, nominal_stance(robot), arc, state, leg, 0.1, to_come, {}).p_OT;
  }
};

// Without limits in the way, the foothold is the AEP and what is to come.
TEST(FootstepWithinReach, ChangesNothingThatIsWithinReach) {
  const Standing wide(1.5), wider(3.0);
  for (LegId i = 0; i < 6; ++i)
    EXPECT_EQ(wide.foothold(i, 0.05), wider.foothold(i, 0.05)) << static_cast<int>(i);
}

// Half a radian at the yaw axis is less than what is asked for: the foot goes as far as it can, to a
// sixty-fourth of the way. A foot that waited there for the body, which waits for it, would never
// land.
TEST(FootstepWithinReach, EndsWhereTheLegEnds) {
  const Standing narrow(0.25), wide(1.5);
  for (LegId i = 0; i < 6; ++i) {
    const LegModel& leg = narrow.robot.legs[i];
    Vector3 asked = wide.foothold(i, 0.1), got = narrow.foothold(i, 0.1);
    asked.z() = got.z() = leg.p_BC.z();
    ASSERT_FALSE(inverse_kinematics(leg, asked).reachable);
    EXPECT_TRUE(inverse_kinematics(leg, got).reachable);
    EXPECT_FALSE(inverse_kinematics(leg, got + (asked - leg.p_BC) / 64.0).reachable);
    EXPECT_NEAR((got - leg.p_BC).normalized().dot((asked - leg.p_BC).normalized()), 1.0, 1e-9);
  }
}

}  // namespace
}  // namespace hexagait::footstep_gen

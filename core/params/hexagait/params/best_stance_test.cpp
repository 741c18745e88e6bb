// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <hexagait/model/kinematics.hpp>
#include <hexagait/params/best_stance.hpp>
#include <testing/argos.hpp>

namespace hexagait {
namespace {

using testing::argos;

RobotModel with_effort(double effort) {
  RobotModel robot = argos();
  for (LegModel& leg : robot.legs)
    for (JointLimits& limits : leg.limits) limits.effort = effort;
  return robot;
}

// Half of 50 kg on a lever of a femur, less what the leg's own links weigh.
TEST(StandingEffort, IsThatOfTheMiddleLegOfATripod) {
  const StandingEffort effort = standing_effort(argos());
  EXPECT_EQ(argos().legs[effort.leg].joint_names[effort.joint].substr(3), "hip");
  EXPECT_NEAR(effort.effort, 0.5 * 50.0 * 9.81 * 0.28, 7.0);
  EXPECT_NEAR(effort.share, effort.effort / 200.0, 1e-12);
}

TEST(BestStance, LeavesARobotThatHasRoomAndStrengthAsItIs) {
  const RobotModel before = argos(), after = in_best_stance(before);
  for (LegId i = 0; i < before.num_legs(); ++i) EXPECT_EQ(after.legs[i].p_BC, before.legs[i].p_BC);
  EXPECT_EQ(why_it_cannot_walk(before), "");
}

// Weak joints: the feet come closer, until 0.8 of the effort is enough.
TEST(BestStance, SparesWeakJoints) {
  const RobotModel weak = with_effort(70.0), after = in_best_stance(weak);
  EXPECT_GT(standing_effort(weak).share, 0.8);
  EXPECT_LE(standing_effort(after).share, 0.8);
  EXPECT_LT(after.legs[2].p_BC.y(), weak.legs[2].p_BC.y());
  for (const LegModel& leg : after.legs) {
    EXPECT_TRUE(inverse_kinematics(leg, leg.p_BC).reachable);
    EXPECT_GT(leg.workspace_radius, 0.0);
  }
}

TEST(BestStance, RefusesWithNumbersWhatNoStanceHelps) {
  const std::string why = why_it_cannot_walk(in_best_stance(with_effort(10.0)));
  EXPECT_THAT(why, ::testing::HasSubstr("_hip needs "));
  EXPECT_THAT(why, ::testing::HasSubstr("has 10 N m"));
}

// A tibia twice the femur folds inside its least reach when it lifts straight up.
TEST(BestStance, FindsRoomForTheSwing) {
  RobotModel robot = argos();
  for (LegModel& leg : robot.legs) leg.limits[2].upper = 2.0;  // the knee
  const RobotModel after = in_best_stance(robot);
  EXPECT_GE(scale_of(after).reach / scale_of(after).time,
            scale_of(robot).reach / scale_of(robot).time);
  EXPECT_GT(scale_of(after).sideways, 0.0);
}

}  // namespace
}  // namespace hexagait

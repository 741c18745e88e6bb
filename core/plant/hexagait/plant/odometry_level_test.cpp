// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/plant/odometry.hpp>
#include <testing/control_period.hpp>
#include <testing/round_params.hpp>

namespace hexagait {
namespace {

using testing::kDt;

const double kTau = testing::round_params().tolerance.level_time;

// Six point feet that stand on a ground that slopes, which odometry takes for level; the body is turned
// by `yaw` in odom.
struct OnASlope {
  RobotModel model;
  RobotState state;
  Odometry odometry{model, testing::round_params().tolerance};
  LegArray<double> footing{6, 1.0};

  explicit OnASlope(double yaw = 0.0) {
    model.legs = LegArray<LegModel>(6);
    state.q = LegArray<LegJoints>(6, LegJoints::Zero());
    state.trig = LegArray<LegTrig>(6);
    state.p_BF = LegArray<Vector3>(6);
    for (LegId i = 0; i < 6; ++i) state.p_BF[i] = {0.5 - 0.2 * i, i % 2 == 0 ? 0.4 : -0.4, -0.3};
    odometry.reset(state);
    const int ticks = 500;
    for (int k = 0; k < ticks; ++k) {
      for (Vector3& p_BF : state.p_BF) p_BF = rotation_z(-yaw / ticks) * p_BF;
      odometry.update(state, footing, kDt);
    }
  }
  void stand(double seconds) {
    for (double t = 0.0; t < seconds - 0.5 * kDt; t += kDt) odometry.update(state, footing, kDt);
  }
  [[nodiscard]] Vector3 rpy() const { return roll_pitch_yaw(state.X_OB.R); }
};

TEST(OdometryLevel, StaysAsItIsWithoutAnInclinometer) {
  OnASlope robot(0.7);
  const Pose before = robot.state.X_OB;
  robot.stand(2.0 * kTau);
  EXPECT_LT((robot.state.X_OB.R - before.R).norm(), 1e-8);
}

// φ = φ_measured (1 − e^(−t/τ)), whatever the heading; what is not measured stays.
TEST(OdometryLevel, TakesOverWhatIsMeasuredInTheTimeConstant) {
  for (const double yaw : {0.0, 0.7, -2.5}) {
    OnASlope robot(yaw);
    robot.state.inclination.pitch = 0.1;
    robot.stand(kTau);
    EXPECT_NEAR(robot.rpy().y(), 0.1 * (1.0 - std::exp(-1.0)), 1e-4);
    EXPECT_NEAR(robot.rpy().x(), 0.0, 1e-4) << "the roll is not measured";
    EXPECT_NEAR(robot.rpy().z(), yaw, 1e-3);

    robot.state.inclination.roll = -0.05;
    robot.stand(12.0 * kTau);
    EXPECT_NEAR(robot.rpy().y(), 0.1, 1e-4);
    EXPECT_NEAR(robot.rpy().x(), -0.05, 1e-4);
  }
}

// The ground under the robot turns along: in the body nothing moves, and the base stays where it is.
TEST(OdometryLevel, TurnsFootholdsAndPrintsAlong) {
  OnASlope robot(0.3);
  const Vector3 p_OB = robot.state.X_OB.p;
  robot.state.inclination = {.roll = 0.05, .pitch = -0.1};
  robot.stand(3.0 * kTau);
  EXPECT_LT((robot.state.X_OB.p - p_OB).norm(), 1e-9);
  for (LegId i = 0; i < 6; ++i) {
    EXPECT_LT((robot.state.p_OF[i] - robot.state.X_OB * robot.state.p_BF[i]).norm(), 1e-9);
    EXPECT_LT((robot.state.print_O[i] - robot.state.p_OF[i]).norm(), 1e-6);
    EXPECT_LT(robot.state.slide_O[i].norm(), 1e-6) << "no foot slides for it";
  }
}

}  // namespace
}  // namespace hexagait

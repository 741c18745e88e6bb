// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <hexagait/executor/gravity_sense.hpp>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/model/leg_weight.hpp>
#include <hexagait/params/params_for.hpp>
#include <hexagait/script/preview.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <numbers>
#include <string>
#include <testing/source_path.hpp>

namespace hexagait {
namespace {

constexpr double kTrusted = 0.04;       // what is left to odometry [rad]
constexpr double kTrustedLost = 0.015;  // the same with a leg lost

// A robot that stands still in its nominal stance, and whose odometry may be wrong about what is up. What carries it is computed forwards: forces of the feet and weight of the links → efforts → what the servos give way by.
struct Standing {
  explicit Standing(const std::string& robot)
      : model(load_urdf(testing::source_path("robots/" + robot + ".urdf"))),
        tolerance(params_for(model).tolerance),
        n(model.num_legs()) {
    state.q = nominal_joints(model);
    state.trig = LegArray<LegTrig>(n);
    for (LegId i = 0; i < n; ++i) state.trig[i] = leg_trig(model.legs[i], state.q[i]);
    targets = {state.q, LegArray<LegJoints>(n, LegJoints::Zero()),
               LegArray<LegJoints>(n, LegJoints::Zero())};
  }

  [[nodiscard]] Vector3 up_estimated() const { return state.X_OB.R.row(2); }

  void tilt(const Vector3& turn) { state.X_OB.R = rotation(turn) * state.X_OB.R; }

  // Servos of the stiffness K/(m g), with fed-forward loads along the estimated up, or without.
  void stand(const Vector3& up_B, double stiffness, double fed_forward = 1.0) {
    const Vector3 more = up_B - fed_forward * up_estimated();
    for (LegId i = 0; i < n; ++i) {
      // Feet push against each other, by as much as half of the weight: in all by nothing.
      const double side = i % 2 == 0 ? 0.5 : -0.5;
      const Vector3 force = more / n + side * Vector3(0.3, -1.0, 0.2);
      const LegJoints own = leg_weight(model.legs[i], state.q[i], up_B).effort / model.mass;
      targets.q[i] =
          state.q[i] - (foot_effort(model.legs[i], state.trig[i], force) - own) / stiffness;
    }
  }

  // One tick in which odometry takes the correction over.
  Vector3 tick(double dt, int feet = 6) {
    const Vector3 change = sense.update(model, state, targets, lost, feet, dt, tolerance);
    const Vector3 from = up_estimated(), to = (from + change).normalized();
    state.X_OB.R = state.X_OB.R * rotation(to.cross(from));
    return change;
  }

  RobotModel model;
  ToleranceParams tolerance;
  int n;
  RobotState state;
  JointTargets targets;
  LegSet lost;
  GravitySense sense;
};

class GravitySenseOf : public ::testing::TestWithParam<const char*> {};

TEST_P(GravitySenseOf, FindsUpFromHowTheServosGiveWay) {
  for (const double dt : {0.001, 0.002, 0.02}) {
    Standing robot(GetParam());
    const Vector3 up_B = Vector3(0.1, -0.15, 1.0).normalized();
    const double tau = robot.tolerance.gravity_time;
    const double off = (up_B - robot.up_estimated()).norm();
    for (double t = 0.0; t < 8.0 * tau; t += dt) {
      robot.stand(up_B, robot.tolerance.servo_stiffness);
      robot.tick(dt);
      if (std::abs(t - tau) < 0.5 * dt) {
        EXPECT_GT((up_B - robot.up_estimated()).norm(), 0.3 * off) << "slowly, dt " << dt;
      }
    }
    EXPECT_LT((up_B - robot.up_estimated()).norm(), kTrusted) << dt;
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, GravitySenseOf,
                         ::testing::Values("argos", "hexapod_4dof", "spider"));

// The servos of legs that are not there are far off their targets and carry nothing.
TEST(GravitySense, FindsUpWithoutLegsThatAreLost) {
  Standing robot("argos");
  const LegSet gone(0b1100U);  // what they push against each other is gone with both
  const Vector3 up_B = Vector3(0.2, -0.3, 1.0).normalized();
  const auto walk_on = [&] {
    for (double t = 0.0; t < 16.0 * robot.tolerance.gravity_time; t += 0.002) {
      robot.stand(up_B, robot.tolerance.servo_stiffness * (robot.n - gone.size()) / robot.n);
      for (LegId i = 0; i < robot.n; ++i)
        if (gone.contains(i)) robot.targets.q[i] = robot.state.q[i] + LegJoints::Constant(0.5);
      robot.tick(0.002, robot.n - gone.size());
    }
    return (up_B - robot.up_estimated()).norm();
  };
  EXPECT_GT(walk_on(), 0.3) << "as long as they count as legs that stand";
  robot.lost = gone;
  EXPECT_LT(walk_on(), 1.5 * kTrustedLost);
}

// Legs are a third of argos. The left ones stand farther out here, and hold more of themselves.
TEST(GravitySense, KnowsWhatTheLegsWeighThemselves) {
  Standing robot("argos");
  for (const LegId i : {0, 2, 4}) robot.state.q[i].head<3>() += Vector3(0.0, -0.3, 0.6);
  for (LegId i = 0; i < robot.n; ++i)
    robot.state.trig[i] = leg_trig(robot.model.legs[i], robot.state.q[i]);
  for (const double side : {-1.0, 1.0}) {
    robot.state.X_OB.R.setIdentity();
    const Vector3 up_B = Vector3(0.0, 0.15 * side, 1.0).normalized();
    for (double t = 0.0; t < 16.0 * robot.tolerance.gravity_time; t += 0.002) {
      robot.stand(up_B, robot.tolerance.servo_stiffness);
      robot.tick(0.002);
    }
    // Weights are those along what is taken for up, which is off by kTrusted: 0.16 of that.
    EXPECT_NEAR((up_B - robot.up_estimated()).norm(), kTrusted, 0.0065) << side;
  }
}

TEST(GravitySense, NeedsNotKnowTheStiffnessOfTheServosWell) {
  for (const double factor : {0.5, 2.0}) {
    Standing robot("argos");
    const Vector3 up_B = Vector3(-0.2, 0.0, 1.0).normalized();
    for (double t = 0.0; t < 16.0 * robot.tolerance.gravity_time; t += 0.002) {
      robot.stand(up_B, factor * robot.tolerance.servo_stiffness);
      robot.tick(0.002);
    }
    // The legs' own weight is then as uncertain.
    EXPECT_LT((up_B - robot.up_estimated()).norm(), factor * kTrusted + 0.02) << factor;
  }
}

// 6 ms at the joint speeds of a walk would read as a tilt of 0.2 rad and more.
TEST(GravitySense, IsNotMisledByServosThatAreLate) {
  constexpr double kLag = 0.006, kDt = 0.002;
  Standing robot("argos");
  const Vector3 up_B = robot.up_estimated();
  double most = 0.0;
  for (int k = 0; k < 10000; ++k) {
    robot.stand(up_B, robot.tolerance.servo_stiffness);
    const double phase = 2.0 * std::numbers::pi * k * kDt / 0.8;
    for (LegId i = 0; i < 6; ++i) {
      const Vector3 back(0.15 + 0.2 * std::sin(phase), 0.05 * std::cos(phase), 0.0);
      const LegJacobian J = foot_jacobian(robot.model.legs[i], robot.state.trig[i]);
      const Matrix3 inverse = Matrix3(J.leftCols<3>()).inverse();
      robot.targets.qd[i].head<3>() = inverse * back;
      robot.targets.q[i] += kLag * robot.targets.qd[i];
    }
    robot.tick(kDt);
    most = std::max(most, (up_B - robot.up_estimated()).norm());
  }
  EXPECT_NEAR(robot.sense.lag(), kLag, 1e-4);
  EXPECT_LT(most, 0.005);
}

TEST(GravitySense, SaysNothingWhileTheRobotTipsOverTwoFeet) {
  Standing robot("argos");
  robot.stand(Vector3(0.3, 0.0, 1.0).normalized(), robot.tolerance.servo_stiffness);
  for (int k = 0; k < 1000; ++k) EXPECT_TRUE(robot.tick(0.002, 2).isZero());
  for (int k = 0; k < 1000; ++k) robot.tick(0.002, 3);
  EXPECT_FALSE(robot.tick(0.002, 3).isZero());
}

// Odometry is better than the joints as long as no foot slides and the robot does not tip.
TEST(GravitySense, LeavesSmallErrorsToOdometry) {
  Standing robot("argos");
  robot.stand(Vector3(0.9 * kTrusted, 0.0, 1.0).normalized(), robot.tolerance.servo_stiffness);
  for (int k = 0; k < 5000; ++k) EXPECT_TRUE(robot.tick(0.002).isZero());
}

// Odometry is off by 63°, and stays so for long: what the joints say is no less certain.
TEST(GravitySense, FindsUpFromFarOff) {
  Standing robot("argos");
  const Vector3 up_B(std::sin(1.1), 0.0, std::cos(1.1));
  const double tau = robot.tolerance.gravity_time;
  for (double t = 0.0; t < 30.0 * tau; t += 0.002) {
    robot.stand(up_B, robot.tolerance.servo_stiffness);
    robot.sense.update(robot.model, robot.state, robot.targets, {}, 6, 0.002, robot.tolerance);
  }
  for (double t = 0.0; t < 30.0 * tau; t += 0.002) {
    robot.stand(up_B, robot.tolerance.servo_stiffness);
    robot.tick(0.002);
  }
  EXPECT_LT((up_B - robot.up_estimated()).norm(), 1.5 * kTrusted);
}

// Then the servos give way by the whole weight, and by that of the legs as well.
TEST(GravitySense, LeavesServosAloneThatTakeNoEffort) {
  Standing robot("argos");
  const Vector3 up_B = robot.up_estimated();
  robot.tilt({0.1, 0.0, 0.0});
  const double off = (up_B - robot.up_estimated()).norm();
  const double tau = robot.tolerance.gravity_time;
  for (double t = 0.0; t < 100.0 * tau; t += 0.002) {
    robot.stand(Vector3(0.4, 0.0, 1.0).normalized(), robot.tolerance.servo_stiffness, 0.0);
    robot.tick(0.002);
  }
  EXPECT_NEAR((up_B - robot.up_estimated()).norm(), off, 0.5 * off);
}

TEST(GravitySense, CanBeTurnedOffAndStandsAStretchedLeg) {
  Standing robot("argos");
  robot.stand(Vector3(0.3, 0.0, 1.0).normalized(), robot.tolerance.servo_stiffness);
  robot.tolerance.servo_stiffness = 0.0;
  EXPECT_TRUE(robot.tick(0.002).isZero());
  robot.tolerance.servo_stiffness = 8.0;
  robot.state.trig[2] = leg_trig(robot.model.legs[2], LegJoints::Zero());  // knee straight
  EXPECT_TRUE(robot.tick(0.002).allFinite());
}

}  // namespace
}  // namespace hexagait

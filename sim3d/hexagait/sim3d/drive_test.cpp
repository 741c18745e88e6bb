// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <hexagait/sim3d/world.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <testing/argos.hpp>
#include <testing/round_params.hpp>

// Argos on a test stand, its legs straight out: what is not ideal about its drives and links.
namespace hexagait::sim3d {
namespace {

constexpr int kYaw = 0, kHip = 1;
const LegArray<LegJoints> kZero(6, LegJoints::Zero());

class Drive : public ::testing::Test {
 protected:
  Drive() {
    params_.base_on_stand = true;
    params_.start_clearance = 1.0;
  }

  // Joint positions of the first leg after every write of so many.
  std::vector<LegJoints> run(const std::function<JointTargets(double)>& targets_at, int writes,
                             LegId leg = 0) const {
    World world(robot_, {}, params_, kZero);
    std::vector<LegJoints> path;
    Measurement measurement;
    for (int k = 0; k < writes; ++k) {
      world.write(targets_at(k * params_.control_dt));
      world.read(measurement);
      path.push_back(measurement.q[leg]);
    }
    return path;
  }

  // Targets with one value of one joint of all legs.
  static LegArray<LegJoints> all(int joint, double value) {
    LegArray<LegJoints> values = kZero;
    for (LegJoints& leg : values) leg[joint] = value;
    return values;
  }

  [[nodiscard]] double fastest(const std::vector<LegJoints>& path, int joint) const {
    double most = 0.0;
    for (std::size_t k = 1; k < path.size(); ++k)
      most = std::max(most, std::abs(path[k][joint] - path[k - 1][joint]) / params_.physics_dt);
    return most;
  }

  RobotModel robot_ = testing::argos();
  WorldParams params_ = hexagait::testing::round_world<WorldParams>();
};

// 0.9 rad at 4000 N m/rad is far more than the drive has, 120 N m: it accelerates all it can, and
// would pass 8 rad/s in 3 % of the way.
TEST_F(Drive, KeepsToTheVelocityLimitOfTheModel) {
  const auto step = [](double) { return JointTargets{all(kYaw, 0.9), kZero, kZero}; };
  const double limit = robot_.legs[0].limits[kYaw].velocity;
  EXPECT_NEAR(fastest(run(step, 100), kYaw), limit, 0.02 * limit);
  params_.velocity_limits = false;
  EXPECT_GT(fastest(run(step, 100), kYaw), 1.5 * limit);
}

// In velocity and effort mode too: asked for twice its limit, and driven by 30 N m without end.
TEST_F(Drive, KeepsToTheVelocityLimitInEveryMode) {
  const double limit = robot_.legs[0].limits[kYaw].velocity;
  for (const ControlMode mode : {ControlMode::velocity, ControlMode::effort}) {
    const auto drive = [&](double) {
      return JointTargets{kZero, all(kYaw, 2.0 * limit), all(kYaw, 30.0),
                          LegArray<ControlMode>(6, mode)};
    };
    EXPECT_NEAR(fastest(run(drive, 60), kYaw), limit, 0.02 * limit);
  }
}

// A limit of the speed is none of the torque at rest: with the same stiffness it sags the same,
// however slow it is.
TEST_F(Drive, AVelocityLimitLeavesTheTorqueAtRest) {
  const auto hold = [](double) { return JointTargets{kZero, kZero, kZero}; };
  const double sag = run(hold, 1000).back()[kHip];
  EXPECT_GT(sag, 1e-3);
  for (LegModel& leg : robot_.legs)
    for (JointLimits& limits : leg.limits) limits.velocity = 0.01;
  EXPECT_NEAR(run(hold, 1000).back()[kHip], sag, 1e-9);
}

// The yaw axis is vertical: no weight turns it. 1 mrad at 4000 N m/rad does not overcome 5 N m; 3
// mrad do, until 5 N m are left.
TEST_F(Drive, DryFrictionHoldsUntilItIsOvercome) {
  params_.drive_friction = 5.0;
  const auto to = [](double q) {
    return [q](double) { return JointTargets{all(kYaw, q), kZero, kZero}; };
  };
  EXPECT_NEAR(run(to(0.001), 500).back()[kYaw], 0.0, 1e-6);
  const double left = 0.003 - run(to(0.003), 1000).back()[kYaw];
  EXPECT_GT(left, 1e-5);
  EXPECT_LE(left, 5.0 / params_.servo_kp + 1e-5);
  params_.drive_friction = 0.0;
  EXPECT_NEAR(run(to(0.001), 500).back()[kYaw], 0.001, 1e-5);
}

// The weight of a leg takes a hip to the end of the play, half of it beyond where it would sag to. A
// yaw axis, which no weight turns, stays where it is until its target is farther than that.
TEST_F(Drive, PlayInTheGearLetsTheJointGoHalfOfIt) {
  const auto to = [](double q) {
    return [q](double) { return JointTargets{all(kYaw, q), kZero, kZero}; };
  };
  const double sag = run(to(0.0), 1000).back()[kHip];
  params_.backlash = 0.02;
  EXPECT_NEAR(std::abs(run(to(0.0), 1000).back()[kHip]), std::abs(sag) + 0.01, 1e-4);
  EXPECT_NEAR(run(to(0.009), 1000).back()[kYaw], 0.0, 1e-6);
  EXPECT_NEAR(run(to(0.030), 1000).back()[kYaw], 0.02, 1e-3);
}

// n steps of a constant torque from rest go q = τ h² n (n + 1)/2 / J; so does J + I.
TEST_F(Drive, ARotorAddsItsInertia) {
  params_.servo_friction = 0.05;
  constexpr int kSteps = 20;
  constexpr double kTorque = 20.0, kArmature = 0.2;
  const auto drive = [](double) {
    return JointTargets{kZero, kZero, all(kYaw, kTorque),
                        LegArray<ControlMode>(6, ControlMode::effort)};
  };
  const auto inertia = [&] {
    const double h = params_.physics_dt;
    return kTorque * h * h * kSteps * (kSteps + 1) / 2.0 / run(drive, kSteps).back()[kYaw];
  };
  const double link = inertia();
  params_.armature = kArmature;
  EXPECT_NEAR(inertia() - link, kArmature, 0.02 * kArmature);
}

// Behind a ramp of speed v it stays by v T; without lag by nothing.
TEST_F(Drive, ALaggingServoStaysBehindByItsTimeConstant) {
  constexpr double kSpeed = 0.5;
  constexpr double kPeriod = 0.002;
  const auto ramp = [](double t) {  // the target of the end of the period
    return JointTargets{all(kYaw, kSpeed * (t + kPeriod)), all(kYaw, kSpeed), kZero};
  };
  const auto behind = [&] { return kSpeed * 400 * kPeriod - run(ramp, 400).back()[kYaw]; };
  EXPECT_NEAR(behind(), 0.0, 5e-4);
  params_.servo_lag = 0.04;
  EXPECT_NEAR(behind(), 0.04 * kSpeed, 5e-4);
}

// The sag of a leg (servo_test.cpp) is that of femur and tibia, each 10 % up or down.
TEST_F(Drive, MassErrorsMakeEachLinkHeavierOrLighter) {
  const auto hold = [](double) { return JointTargets{kZero, kZero, kZero}; };
  const double nominal = run(hold, 1000).back()[kHip];
  params_.mass_error = 0.1;
  const double femur = 1.2 * 0.14, tibia = 0.8 * 0.47475;
  int ups = 0;
  for (LegId leg = 0; leg < 6; ++leg) {
    const double ratio = run(hold, 1000, leg).back()[kHip] / nominal;
    double nearest = 1.0;
    for (const double a : {0.9, 1.1})
      for (const double b : {0.9, 1.1})
        nearest = std::min(nearest, std::abs(ratio - (a * femur + b * tibia) / (femur + tibia)));
    EXPECT_LT(nearest, 2e-3) << leg;
    ups += ratio > 1.0 ? 1 : 0;
  }
  EXPECT_GT(ups, 0);
  EXPECT_LT(ups, 6);
  const double one = run(hold, 200).back()[kHip];
  EXPECT_EQ(run(hold, 200).back()[kHip], one);
}

TEST_F(Drive, ImperfectionsOutOfRangeAreRefusedAtOnceWithUnitAndRange) {
  for (const Imperfection<WorldParams>& one : imperfections())
    params_.*one.value = one.greatest + 1.0;
  params_.servo_lag = -0.01;
  try {
    World world(robot_, {}, params_, kZero);
    FAIL() << "accepted";
  } catch (const InvalidInput& refusal) {
    for (const char* part :
         {"friction [1]: 11 must be finite and in [0, 10]", "drive_friction [N m]",
          "servo_lag [s]: -0.01 must be finite and in [0, 1]", "armature [kg m²]",
          "mass_error [1]: 1.9", "contact_threshold [N]"})
      EXPECT_THAT(refusal.what(), ::testing::HasSubstr(part));
  }
}

}  // namespace
}  // namespace hexagait::sim3d

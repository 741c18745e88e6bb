// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <hexagait/sim3d/world.hpp>
#include <hexagait/walk/faults/faults.hpp>
#include <hexagait/walk/trial.hpp>
#include <testing/argos.hpp>
#include <testing/control_period.hpp>

// The inertial measurement unit: what the simulated one feels, how it errs, and what a walk gains by it.
namespace hexagait::walk {
namespace {

using heading_control::Heading;

const double kGravity = sim3d::WorldParams{}.gravity;

using testing::argos;
using testing::kDt;

sim3d::World world(bool imu, const sim3d::TerrainSpec& terrain = {}) {
  sim3d::WorldParams params;
  params.imu = imu;
  params.seed = 1;
  return {argos(), terrain, params, nominal_posture(argos())};
}

JointTargets standing() {
  return {nominal_posture(argos()),
          LegArray<LegJoints>(6, LegJoints::Zero()),
          LegArray<LegJoints>(6, LegJoints::Zero()),
          {}};
}

TEST(Imu, FeelsGravityAtRestAndTheMotionOfTheBody) {
  sim3d::World robot = world(true);
  Measurement measurement;
  Vector3 velocity_W = Vector3::Zero();  // the integral of what it feels, less gravity
  robot.push({150.0, -80.0, 0.0}, 0.1);
  for (int k = 0; k < 500; ++k) {
    robot.write(standing());
    robot.read(measurement);
    ASSERT_TRUE(measurement.imu.has_value());
    const Pose& X_WB = robot.truth().X_WB;
    velocity_W += kDt * (X_WB.R * measurement.imu->acceleration - Vector3(0.0, 0.0, kGravity));
    EXPECT_LT((velocity_W - X_WB.R * robot.truth().V_WB.v).norm(), 1e-6);
    EXPECT_EQ(measurement.imu->rate, robot.truth().V_WB.w);
  }
  EXPECT_NEAR(measurement.imu->acceleration.norm(), kGravity, 0.05) << "it has come to rest";
}

TEST(Imu, IsOnlyThereIfTheRobotHasOne) {
  sim3d::World robot = world(false);
  Measurement measurement;
  robot.read(measurement);
  EXPECT_FALSE(measurement.imu.has_value());
}

// A plant at rest that has an inertial measurement unit.
class RestingPlant final : public Plant {
 public:
  PlantStatus read(Measurement& measurement) override {
    measurement = {time,
                   LegArray<LegJoints>(6, LegJoints::Zero()),
                   LegArray<bool>(6, true),
                   {},
                   InertialMeasurement{{0.0, 0.0, 9.81}, {0.0, 0.0, time}}};
    time += kDt;
    return PlantStatus::fresh;
  }
  void write(const JointTargets& /*targets*/) override {}
  double time = 0.0;
};

TEST(Imu, HasNoiseAndBiasAndIsDelayedAsTheJointsAre) {
  RestingPlant inner;
  PlantFaults faults;
  faults.acceleration_noise = 0.2;
  faults.acceleration_bias = 0.3;
  faults.rate_noise = 0.02;
  faults.rate_bias = 0.05;
  faults.sensing_delay = 5 * kDt;
  FaultyPlant plant(inner, argos(), faults, kDt, 1);
  constexpr int kTicks = 5000;
  Vector3 mean = Vector3::Zero(), rate_mean = Vector3::Zero();
  double square = 0.0;
  Measurement sensed;
  for (int k = 0; k < kTicks; ++k) {
    ASSERT_EQ(plant.read(sensed), PlantStatus::fresh);
    if (k < 5) continue;
    const Vector3 error = sensed.imu->acceleration - Vector3(0.0, 0.0, 9.81);
    mean += error / kTicks;
    rate_mean += (sensed.imu->rate - Vector3(0.0, 0.0, sensed.time)) / kTicks;
    square += (error.cwiseAbs().array() - 0.3).square().mean() / kTicks;
  }
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(std::abs(mean[k]), 0.3, 0.02);
  for (int k = 0; k < 2; ++k) EXPECT_NEAR(std::abs(rate_mean[k]), 0.05, 0.002);
  EXPECT_NEAR(rate_mean.z() + faults.sensing_delay, std::copysign(0.05, rate_mean.z()), 0.003);
  EXPECT_NEAR(std::sqrt(square), 0.2, 0.03);
}

// Over boxes of 20 cm: now and then the body tips about two feet, which odometry can't see.
TEST(Imu, KeepsTheTiltOfOdometryRight) {
  const auto tilt = [&](bool imu) {
    sim3d::World robot = world(imu, sim3d::parse_terrain("boxes:0.2"));
    footstep_gen::Walker walker(argos());
    TrialOptions options;
    options.schedule = {{0.0, Heading::straight(0.0)}};
    options.seconds = 15.0;
    return run_trial(walker, robot, robot.truth(), options).odometry_tilt;
  };
  const double with = tilt(true);
  EXPECT_LT(with, 0.02);
  EXPECT_GT(tilt(false), 3.0 * with) << "the ground is harmless: nothing is shown";
}

}  // namespace
}  // namespace hexagait::walk

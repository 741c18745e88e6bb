// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Short walks of the whole controller in physics. The long ones are `hexagait experiment walks`.
#include <gtest/gtest.h>

#include <cmath>
#include <hexagait/sim3d/world.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <hexagait/walk/trial.hpp>
#include <limits>

namespace hexagait::walk {
namespace {

using footstep_gen::Fault;
using footstep_gen::Walker;
using footstep_gen::WalkerParams;
using heading_control::Heading;
using heading_control::Turn;

const RobotModel& argos() {
  static const RobotModel robot = load_urdf(HEXAGAIT_SOURCE_DIR "/robots/argos.urdf");
  return robot;
}

Summary walk_for(double seconds, const Heading& heading, const char* terrain = "flat",
                 const WalkerParams& params = {}) {
  sim3d::World world(argos(), sim3d::parse_terrain(terrain), {}, nominal_posture(argos()));
  Walker walker(argos(), params);
  TrialOptions options;
  options.schedule = {{0.0, heading}};
  options.seconds = seconds;
  return run_trial(walker, world, world.truth(), options);
}

// The bounds of the 40 s walks; a gait cycle takes 1.7 s.
TEST(Physics, WalksEveryHeadingOnFlatGroundWithoutSlippingOrStraying) {
  const Heading headings[] = {Heading::straight(0.0), Heading::arc(0.3, 0.0),
                              Heading::spin(Turn::cw), Heading::straight(0.25 * std::numbers::pi),
                              Heading::straight(std::numbers::pi)};
  for (const Heading& heading : headings) {
    const Summary s = walk_for(4.0, heading);
    EXPECT_TRUE(s.ok());
    EXPECT_LT(s.lateral_mean, 0.005);
    EXPECT_LT(s.slip_p95, 0.0003);
    EXPECT_EQ(s.contact_losses, 0);
    EXPECT_EQ(s.rule1_violations, 0);
    EXPECT_EQ(s.neighbour_flight, 0.0);
    EXPECT_TRUE(s.tripod_after_steps.has_value());
  }
}

TEST(Physics, WalksOnFlatGroundWithoutContactSensorsOrWithoutJointFeedback) {
  for (const SensorMask mask : {SensorMask{.joint_feedback = true, .foot_contacts = false},
                                SensorMask{.joint_feedback = false, .foot_contacts = true}}) {
    WalkerParams params;
    params.sensors = mask;
    const Summary s = walk_for(6.0, Heading::straight(0.0), "flat", params);
    EXPECT_TRUE(s.ok());
    EXPECT_GT(s.distance, 6.0 * 0.15);
    EXPECT_LT(s.lateral_mean, 0.005);
    EXPECT_EQ(s.rule1_violations, 0);
  }
}

TEST(Physics, NeverLiftsANeighbourOfALegInTheAirOnRoughGround) {
  const Summary s = walk_for(8.0, Heading::straight(0.0), "boxes:0.10");
  EXPECT_TRUE(s.ok());
  EXPECT_GT(s.steps, 12);
  EXPECT_EQ(s.rule1_violations, 0);
}

// (gait 5) in physics: period 4 T = 3.5 s, so that six legs lift 6/3.5 times a second; a foot
// sweeps 0.20 m while its leg stands, 3 T = 2.6 s: 0.077 m/s.
TEST(Physics, WalksAWaveGaitWithThreeQuartersOfTheLegsOnTheGround) {
  WalkerParams params;
  params.stepper = {.stepping = gait_state::Stepping::wave, .duty_factor = 0.75};
  const Summary s = walk_for(14.0, Heading::straight(0.0), "flat", params);
  EXPECT_TRUE(s.ok());
  EXPECT_NEAR(s.steps, 14.0 * 6.0 / 3.5, 4.0);
  EXPECT_NEAR(s.speed, 0.077, 0.015);
  EXPECT_LT(s.lateral_mean, 0.005);
  EXPECT_LT(s.slip_p95, 0.0003);
  EXPECT_EQ(s.contact_losses, 0);
  EXPECT_EQ(s.rule1_violations, 0);
  EXPECT_EQ(s.neighbour_flight, 0.0);
}

TEST(Physics, WalksTheWaitingTripodOverBoxes) {
  WalkerParams params;
  params.stepper.stepping = gait_state::Stepping::tripod;
  const Summary s = walk_for(8.0, Heading::straight(0.0), "boxes:0.10", params);
  EXPECT_TRUE(s.ok());
  EXPECT_GT(s.distance, 8.0 * 0.12);
  EXPECT_EQ(s.rule1_violations, 0);
  EXPECT_EQ(s.steps % 3, 0);
}

// The same bits, from a start that the adjustment would have mended.
TEST(Physics, ThePapersWordsTakenLiterallyWalkAsWithoutAdjustment) {
  const auto hash = [](gait_state::Adjustment adjustment) {
    WalkerParams params;
    params.gait.adjustment = adjustment;
    sim3d::World world(argos(), {}, {}, random_posture(argos(), 0.15, 1));
    Walker walker(argos(), params);
    TrialOptions options;
    options.schedule = {{0.0, Heading::straight(0.0)}};
    options.seconds = 6.0;
    return run_trial(walker, world, world.truth(), options).state_hash;
  };
  EXPECT_EQ(hash(gait_state::Adjustment::literal), hash(gait_state::Adjustment::none));
  EXPECT_NE(hash(gait_state::Adjustment::latched), hash(gait_state::Adjustment::none));
}

// A plant that loses a joint's reading after a second.
class NumbPlant : public Plant {
 public:
  explicit NumbPlant(sim3d::World& world) : world_(&world) {}
  PlantStatus read(Measurement& measurement) override {
    const PlantStatus status = world_->read(measurement);
    if (measurement.time > 1.0) measurement.q[3].y() = std::numeric_limits<double>::quiet_NaN();
    return status;
  }
  void write(const JointTargets& targets) override { world_->write(targets); }

 private:
  sim3d::World* world_;
};

TEST(Physics, StopsSafelyWhenAReadingIsNotANumberAndSaysSo) {
  sim3d::World world(argos(), {}, {}, nominal_posture(argos()));
  NumbPlant plant(world);
  Walker walker(argos());
  TrialOptions options;
  options.schedule = {{0.0, Heading::straight(0.0)}};
  options.seconds = 3.0;
  const Summary s = run_trial(walker, plant, world.truth(), options);
  EXPECT_EQ(s.fault, Fault::bad_measurement);
  EXPECT_FALSE(s.ok());

  // What it commands from then on keeps the robot on its feet.
  for (int k = 0; k < 1000; ++k) world.write(walker.record().targets);
  EXPECT_TRUE(world.truth().finite);
  EXPECT_FALSE(world.truth().base_touches_ground);
}

// As far as argos gets in this time, on legs of four joints.
TEST(Physics, WalksOnLegsOfFourJoints) {
  const RobotModel robot = load_urdf(HEXAGAIT_SOURCE_DIR "/robots/hexapod_4dof.urdf");
  sim3d::World world(robot, sim3d::parse_terrain("flat"), {}, nominal_posture(robot));
  Walker walker(robot, {});
  TrialOptions options;
  options.schedule = {{0.0, Heading::straight(0.0)}};
  options.seconds = 10.0;
  const Summary s = run_trial(walker, world, world.truth(), options);
  EXPECT_TRUE(s.ok());
  EXPECT_GT(s.distance, 10.0 * 0.2);
  EXPECT_LT(s.lateral_mean, 0.005);
  EXPECT_LT(s.slip_p95, 0.0003);
}

}  // namespace
}  // namespace hexagait::walk

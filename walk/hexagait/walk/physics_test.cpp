// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Short walks of the whole controller in physics. The long ones are `hexagait experiment walks`.
#include <gtest/gtest.h>

#include <cmath>
#include <hexagait/params/params_for.hpp>
#include <hexagait/sim/random.hpp>
#include <hexagait/sim3d/world.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <hexagait/walk/trial.hpp>
#include <limits>
#include <testing/argos.hpp>
#include <testing/source_path.hpp>

namespace hexagait::walk {
namespace {

using footstep_gen::Fault;
using footstep_gen::Walker;
using footstep_gen::WalkerParams;
using heading_control::Heading;
using heading_control::Turn;

using testing::argos;

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
  const RobotModel robot = load_urdf(testing::source_path("robots/hexapod_4dof.urdf"));
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

/// What robots do to a controller. Late ticks: nothing arrives, the targets are lost, the drives go
/// on.
struct Rough {
  double lag = 0.0;  ///< of all drives [s]
  double late = 0.0, false_contacts = 0.0;
  double noise = 0.0;  ///< standard deviation of joint readings [rad]
  bool positions_only = false;
};

class RoughPlant final : public Plant {
 public:
  RoughPlant(sim3d::World& world, const Rough& rough, double dt, std::uint64_t seed)
      : world_(&world), rough_(rough), dt_(dt), random_{.seed = 30 + seed} {}

  PlantStatus read(Measurement& measurement) override {
    Measurement now;
    const PlantStatus status = world_->read(now);
    late_ = sent_.q.size() > 0 && random_.u01() < rough_.late;
    if (late_ || status != PlantStatus::fresh) return late_ ? PlantStatus::late : status;
    measurement = now;
    for (LegId i = 0; i < now.q.size(); ++i) {
      for (int k = 0; k < 3; ++k) measurement.q[i][k] += rough_.noise * normal();
      if (random_.u01() < rough_.false_contacts) measurement.contact[i] = true;
    }
    return status;
  }

  void write(const JointTargets& targets) override {
    if (sent_.q.size() == 0) lagging_ = targets;
    if (late_)
      for (LegId i = 0; i < sent_.q.size(); ++i) sent_.q[i] += dt_ * sent_.qd[i];
    else
      sent_ = targets;
    lagging_.mode = sent_.mode;
    for (LegId i = 0; i < sent_.q.size(); ++i) {
      const LegJoints before = lagging_.q[i];
      const double share = dt_ / (rough_.lag + dt_);
      lagging_.q[i] += share * (sent_.q[i] - before);
      lagging_.qd[i] = rough_.lag > 0.0 ? LegJoints((lagging_.q[i] - before) / dt_) : sent_.qd[i];
      lagging_.effort[i] += share * (sent_.effort[i] - lagging_.effort[i]);
      if (rough_.positions_only) lagging_.qd[i] = lagging_.effort[i] = LegJoints::Zero();
    }
    world_->write(lagging_);
  }

 private:
  double normal() {
    double sum = -6.0;
    for (int k = 0; k < 12; ++k) sum += random_.u01();
    return sum;
  }

  sim3d::World* world_;
  Rough rough_;
  double dt_;
  RandomSequence random_;
  bool late_ = false;
  JointTargets sent_, lagging_;
};

Summary rough_walk(const Rough& rough, const char* terrain, double dt, double seconds,
                   std::uint64_t seed = 1, double haste = kDerived) {
  sim3d::WorldParams world_params;
  world_params.control_dt = dt;
  world_params.seed = seed;
  sim3d::World world(argos(), sim3d::parse_terrain(terrain), world_params,
                     nominal_posture(argos()));
  RoughPlant plant(world, rough, dt, seed);
  WalkerParams params;
  params.control_dt = dt;
  params.step.haste = haste;
  Walker walker(argos(), params);
  TrialOptions options;
  options.schedule = {{0.0, Heading::straight(0.0)}};
  options.seconds = seconds;
  return run_trial(walker, plant, world.truth(), options);
}

// Any control period: both tripods' contacts are seen half a period late on average in each cycle, and the
// neighbours hear of them one later. Slow drives: 80 % of the speed of the ideal ones at 2 ms; with a lag of
// 40 ms, of steps without haste.
TEST(RoughPhysics, WalksWithSlowDrivesAtAnyControlPeriod) {
  constexpr double kSeconds = 20.0;
  const Summary best = rough_walk({}, "flat", 0.002, kSeconds);
  const double cycle = kSeconds / (best.steps / 6.0);
  const double unhurried = rough_walk({}, "flat", 0.002, kSeconds, 1, 1.0).speed;
  for (const double dt : {0.002, 0.01, 0.02}) {
    const Summary plain = rough_walk({}, "flat", dt, kSeconds);
    EXPECT_TRUE(plain.ok());
    EXPECT_GT(plain.speed, (1.0 - 2.0 * 1.5 * dt / cycle) * best.speed) << dt;
    EXPECT_LT(plain.lateral_mean, 0.005);
    for (const Rough& rough :
         {Rough{.lag = 0.02}, Rough{.lag = 0.04}, Rough{.positions_only = true}}) {
      const Summary s = rough_walk(rough, "flat", dt, 8.0);
      EXPECT_TRUE(s.ok());
      EXPECT_GT(s.speed, 0.8 * (rough.lag > 0.03 ? unhurried : best.speed))
          << dt << " s, lag " << rough.lag;
    }
  }
}

// Two ditches of 15 cm, and no map: feet that find no ground try beyond it, and the others know. A foot may
// still come down on an edge and roll off it.
TEST(RoughPhysics, StepsOverMostDitches) {
  int over = 0;
  for (const double dt : {0.002, 0.004, 0.005, 0.008, 0.01, 0.012, 0.016, 0.02}) {
    const Summary s = rough_walk({}, "ditches:0.15", dt, 30.0);
    over += s.ok() && s.distance > 3.0 ? 1 : 0;
  }
  EXPECT_GE(over, 6) << "of 8";
}

TEST(RoughPhysics, IsNotStoppedByFalseContacts) {
  const double ideal = rough_walk({}, "flat", 0.002, 12.0).speed;
  const Summary s = rough_walk({.false_contacts = 0.001}, "flat", 0.002, 12.0);
  EXPECT_TRUE(s.ok());
  EXPECT_GT(s.speed, 0.95 * ideal);
}

TEST(RoughPhysics, DoesNotStrayWithNoisyJoints) {
  constexpr int kWalks = 24;  // the mean of 8 scatters by 0.45 cm
  double strays = 0.0;        // on average; one of 24 walks by 5 cm
  for (std::uint64_t seed = 1; seed <= kWalks; ++seed) {
    const Summary flat = rough_walk({.noise = 0.002}, "flat", 0.002, 20.0, seed);
    EXPECT_TRUE(flat.ok()) << seed;
    strays += std::abs(flat.lateral_end) / kWalks;
  }
  EXPECT_LT(strays, 0.025);
  const Summary boxes = rough_walk({.noise = 0.002}, "boxes:0.10", 0.002, 20.0);
  EXPECT_TRUE(boxes.ok());
  EXPECT_LT(boxes.lateral_mean, 0.04);
}

TEST(RoughPhysics, CoastsOverLateTicks) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const Summary s = rough_walk({.late = 0.05}, "boxes:0.10", 0.002, 12.0, seed);
    EXPECT_TRUE(s.ok());
    EXPECT_GT(s.distance, 1.2);
  }
}

}  // namespace
}  // namespace hexagait::walk

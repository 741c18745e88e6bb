// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <hexagait/recording/plant_setup.hpp>
#include <hexagait/recording/simulation.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <numbers>
#include <testing/source_path.hpp>

namespace hexagait::recording {
namespace {

using ::testing::HasSubstr;

TEST(PlantSetup, ReadsPresetsAndWhatDiffersFromThem) {
  EXPECT_EQ(parse_plant("ideal").world.friction, sim3d::WorldParams{}.friction);
  EXPECT_EQ(parse_plant("ideal").faults, walk::PlantFaults{});
  const char* text = "real+friction:0.4+servo:position_only+velocity_limits:off+late_ticks:5%";
  const PlantSetup setup = parse_plant(text);
  EXPECT_EQ(setup.name, text);
  EXPECT_EQ(setup.world.friction, 0.4);
  EXPECT_EQ(setup.world.mass_error, 0.1);
  EXPECT_EQ(setup.faults.joint_noise, 5e-4);
  EXPECT_DOUBLE_EQ(setup.faults.late_ticks, 0.05);
  EXPECT_TRUE(setup.faults.positions_only);
  EXPECT_FALSE(setup.world.velocity_limits);
  EXPECT_TRUE(parse_plant("real+velocity-limits:on").world.velocity_limits);
  EXPECT_FALSE(parse_plant("real+servo:ideal").faults.positions_only);
  EXPECT_EQ(setup.faults.sensing_delay + setup.faults.command_delay, 0.006);
}

TEST(PlantSetup, IsIdealIfNothingDiffers) {
  for (const char* text : {"ideal", "ideal+friction:0.9+velocity_limits:on", "joint_noise:0"})
    EXPECT_TRUE(parse_plant(text).is_ideal()) << text;
  for (const char* text :
       {"real", "friction:0.8", "joint_noise:1mrad", "servo:position_only", "velocity_limits:off"})
    EXPECT_FALSE(parse_plant(text).is_ideal()) << text;
}

TEST(PlantSetup, ReadsUnits) {
  const auto faults = [](const char* text) { return parse_plant(text).faults; };
  EXPECT_DOUBLE_EQ(faults("joint_noise:0.5mrad").joint_noise, 5e-4);
  EXPECT_DOUBLE_EQ(faults("joint-noise:0.1deg").joint_noise, 0.1 * std::numbers::pi / 180.0);
  EXPECT_DOUBLE_EQ(faults("joint_quantisation:12bit").joint_quantisation,
                   2.0 * std::numbers::pi / 4096.0);
  EXPECT_DOUBLE_EQ(faults("contact_bounce:4ms").contact_bounce, 0.004);
  const auto world = [](const char* text) { return parse_plant(text).world; };
  EXPECT_EQ(world("contact_threshold:20N").contact_threshold, 20.0);
  EXPECT_EQ(world("drive_friction:2Nm").drive_friction, 2.0);
  EXPECT_EQ(world("armature:0.1kgm2").armature, 0.1);
  EXPECT_EQ(world("mass_error:20%").mass_error, 0.2);
  EXPECT_DOUBLE_EQ(world("servo_lag:40ms").servo_lag, 0.04);
}

TEST(PlantSetup, RefusesEverythingThatIsWrongAtOnce) {
  try {
    (void)parse_plant(
        "rael+joint_noise:-1mrad+sensing_delay:2s+frction:1+servo:hobby+velocity_limits:no+"
        "false_contacts:120%+joint_quantisation:40bit+mass_error:nan+late_ticks:5ms");
    FAIL() << "accepted";
  } catch (const InvalidInput& refusal) {
    for (const char* part :
         {"'rael' is no plant; did you mean 'real'?",
          "joint_noise is '-1mrad'; it must be an angle from 0 to 0.2 rad",
          "sensing_delay is '2s'; it must be a time from 0 to 1 s", "did you mean 'friction'?",
          "servo is 'hobby'; it must be ideal or position_only",
          "velocity_limits is 'no'; it must be off or on", "false_contacts is '120%'",
          "a share from 0 to 1", "joint_quantisation is '40bit'", "12bit", "mass_error is 'nan'",
          "late_ticks is '5ms'"})
      EXPECT_THAT(refusal.what(), HasSubstr(part));
  }
  for (const char* text : {"", "real+", "+real", "real+real", "friction", "friction:", ":1"})
    EXPECT_THROW((void)parse_plant(text), InvalidInput) << text;
}

// Each text that a message offers is right.
TEST(PlantSetup, EveryNumberIsWithinItsRangeByDefaultAndAtItsEnds) {
  for (const PlantNumber& number : plant_numbers()) {
    PlantSetup setup;
    EXPECT_LE(number.least, number.of(setup)) << number.name;
    EXPECT_GE(number.greatest, number.of(setup)) << number.name;
    for (const double value : {number.least, number.greatest}) {
      EXPECT_EQ(set(setup, number.name, std::to_string(value), number.name), "");
      EXPECT_EQ(number.of(setup), value) << number.name;
    }
  }
}

// World and faults both reach the walk, and both are drawn by its seed.
TEST(PlantSetup, IsThatOfTheWalk) {
  const RobotModel argos = load_urdf(testing::source_path("robots/argos.urdf"));
  const RobotParams params = params_for(argos);
  const auto hash_of = [&params](const RobotModel& robot, const char* plant,
                                 std::uint64_t seed = 1) {
    Simulation simulation;
    simulation.plant = parse_plant(plant);
    simulation.seed = seed;
    simulation.trial.schedule = {{0.0, heading_control::Heading::straight(0.0)}};
    simulation.trial.seconds = 1.0;
    simulation.params = params;  // whatever the joints can do
    return simulate(robot, simulation).state_hash;
  };
  const auto hash = [&](const char* plant, std::uint64_t seed = 1) {
    return hash_of(argos, plant, seed);
  };
  const std::uint64_t ideal = hash("ideal"), with_imu = hash("imu:on");
  EXPECT_NE(with_imu, ideal);
  EXPECT_EQ(ideal, hash("ideal", 2));
  for (const PlantNumber& number : plant_numbers()) {
    if (number.name == std::string("false_contacts")) continue;  // too rare in a second
    const double value = number.of(PlantSetup{}) + 0.01 * (number.greatest - number.least);
    const std::string name = number.name;
    const bool of_imu = name.starts_with("acceleration_") || name.starts_with("rate_");
    const std::string text = (of_imu ? "imu:on+" : "") + name + ":" + std::to_string(value);
    EXPECT_NE(hash(text.c_str()), of_imu ? with_imu : ideal) << text;
    EXPECT_EQ(hash(text.c_str()), hash(text.c_str())) << text;
  }
  EXPECT_NE(hash("servo:position_only"), ideal);
  RobotModel slow = argos;  // argos itself never comes to its limits
  for (LegModel& leg : slow.legs)
    for (JointLimits& limits : leg.limits) limits.velocity = 1.0;
  EXPECT_NE(hash_of(slow, "velocity_limits:off"), hash_of(slow, "ideal"));
  EXPECT_NE(hash("mass_error:10%"), hash("mass_error:10%", 2));
  EXPECT_NE(hash("joint_noise:1mrad"), hash("joint_noise:1mrad", 2));
}

}  // namespace
}  // namespace hexagait::recording

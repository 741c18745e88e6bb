// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdint>
#include <hexagait/sim3d/world.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <hexagait/walk/faults/faults.hpp>
#include <hexagait/walk/schedule.hpp>
#include <hexagait/walk/trial.hpp>
#include <numbers>
#include <testing/source_path.hpp>

/// Every robot that comes with hexagait walks, from 0.2 to 100 kg, by what params_for() makes of its
/// model: nothing is set.
namespace hexagait::walk {
namespace {

using heading_control::Heading;
using heading_control::Turn;

class Robots : public ::testing::TestWithParam<const char*> {
 protected:
  [[nodiscard]] Summary walked(const TrialOptions& options) const {
    sim3d::World world(robot_, {}, {}, nominal_posture(robot_));
    footstep_gen::Walker walker(robot_);
    return run_trial(walker, world, world.truth(), options);
  }
  [[nodiscard]] Summary walked(const Heading& heading, double seconds, double distance) const {
    TrialOptions options;
    options.schedule = {{0.0, heading, {}}};
    options.seconds = seconds;
    options.distance = distance;
    return walked(options);
  }
  /// Legs that the controller takes for lost while the heading changes every two seconds.
  [[nodiscard]] LegSet lost_as_headings_change(std::uint64_t seed, double seconds) const {
    TrialOptions options;
    options.schedule = random_schedule(seed, 2.0, seconds, tightest_radius(robot_));
    options.seconds = seconds;
    return walked(options).lost;
  }

  const RobotModel robot_ =
      load_urdf(testing::source_path("robots/" + std::string(GetParam()) + ".urdf"));
  const RobotScale scale_ = scale_of(robot_);
  const double length_ = scale_.size;
  /// A fifth of the speed at which robots walk straight on: 0.3 ℓ/T.
  const double seconds_ = 5.0 * length_ / (0.06 * scale_.reach / scale_.time);
};

TEST_P(Robots, WalkFiveLengthsStraightOn) {
  const Summary s = walked(Heading::straight(0.0), seconds_, 5.0 * length_);
  EXPECT_TRUE(s.ok() && s.arrived) << in_words(s.hindrance, robot_);
  EXPECT_LT(s.lateral_max, 0.02 * length_);
  EXPECT_LT(s.heading_max, 0.05);
  EXPECT_LT(s.real_contact_losses, 0.1 * s.steps);
}

TEST_P(Robots, WalkAnArc) {
  const Summary s = walked(Heading::arc(2.0 * length_, 0.0), seconds_, 2.5 * length_);
  EXPECT_TRUE(s.ok() && s.arrived) << in_words(s.hindrance, robot_);
  EXPECT_LT(s.lateral_max, 0.02 * length_);
}

TEST_P(Robots, TurnInPlace) {
  const Summary s = walked(Heading::spin(Turn::cw), 30.0 * scale_.time, 1e9);
  EXPECT_TRUE(s.ok()) << in_words(s.hindrance, robot_);
  EXPECT_LT(s.turned, -1.5);
  EXPECT_LT(s.lateral_max, 0.02 * length_);
}

/// Straight on at full speed, then in place, wherever the legs are.
TEST_P(Robots, TurnSharplyWithoutLeavingTheirPath) {
  for (const double share : {15.0, 15.7, 16.4}) {
    TrialOptions options;
    options.schedule = {{0.0, Heading::straight(0.0), {}},
                        {share * scale_.time, Heading::spin(Turn::ccw), {}}};
    options.seconds = (share + 6.0) * scale_.time;
    const Summary s = walked(options);
    EXPECT_TRUE(s.ok()) << in_words(s.hindrance, robot_);
    EXPECT_LT(s.lateral_max, 0.05 * length_) << share;
  }
}

TEST_P(Robots, LoseNoLegAsTheirHeadingChanges) {
  EXPECT_TRUE(lost_as_headings_change(1, 20.0).empty());
}

/// The discrete posture control of [PC04] 5.2, at 20 Hz.
TEST(DiscretePosture, WalksAnArcWithFeetThatHardlySlip) {
  const RobotModel robot = load_urdf(testing::source_path("robots/lauron.urdf"));
  sim3d::World world(robot, {}, {}, nominal_posture(robot));
  footstep_gen::WalkerParams params;
  params.executor.base.displacement_period = 0.05;
  footstep_gen::Walker walker(robot, params);
  TrialOptions options;
  options.schedule = {{0.0, Heading::arc(1.0, 0.0), {}}};
  options.seconds = 10.0;
  const Summary s = run_trial(walker, world, world.truth(), options);
  EXPECT_TRUE(s.ok()) << in_words(s.hindrance, robot);
  EXPECT_GT(s.speed, 0.08);
  EXPECT_LT(s.slip_p95, 0.001);
  EXPECT_LT(s.lateral_max, 0.002);
}

INSTANTIATE_TEST_SUITE_P(All, Robots,
                         ::testing::Values("argos", "spider", "desktop", "mite", "octopod",
                                           "hexapod_mammal", "titan", "beetle", "lauron"),
                         [](const auto& of) { return std::string(of.param); });

/// Legs of two joints: reduced control, by strokes of the sides. Their feet slide, so how well they keep to
/// a path is another matter; [PC04] 5 has 5 cm/s and 8 °/s of Genghis.
using TwoJointLegs = Robots;

TEST_P(TwoJointLegs, WalkStraightOnAsFastAsThePapers) {
  const Summary s = walked(Heading::straight(0.0), 30.0, 1e9);
  EXPECT_TRUE(s.ok()) << in_words(s.hindrance, robot_);
  EXPECT_GT(s.speed, 0.05);
  EXPECT_LT(s.lateral_max, 0.1 * length_);
  EXPECT_LT(s.heading_max, 0.05);
}

TEST_P(TwoJointLegs, TurnInPlaceAsFastAsThePapers) {
  for (const Turn turn : {Turn::cw, Turn::ccw}) {
    const Summary s = walked(Heading::spin(turn), 20.0, 1e9);
    EXPECT_TRUE(s.ok()) << in_words(s.hindrance, robot_);
    EXPECT_GT((turn == Turn::ccw ? 1.0 : -1.0) * s.turned / s.seconds,
              8.0 * std::numbers::pi / 180.0);
    EXPECT_LT(s.lateral_max, 0.2 * length_);
  }
}

TEST_P(TwoJointLegs, WalkAnArcAndBackwards) {
  for (const Heading& heading :
       {Heading::arc(3.0 * length_, 0.0), Heading::straight(std::numbers::pi)}) {
    const Summary s = walked(heading, 30.0, 1e9);
    EXPECT_TRUE(s.ok()) << in_words(s.hindrance, robot_);
    EXPECT_GT(s.distance, 3.0 * length_);
    EXPECT_LT(s.lateral_max, 0.3 * length_);
  }
}

// A foot that sticks holds its joints, and its contact flickers: that leg is there, (watch 3).
TEST_P(TwoJointLegs, LoseNoneAsTheirHeadingChanges) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U, 6U})
    EXPECT_TRUE(lost_as_headings_change(seed, 60.0).empty()) << seed;
}

// Their feet slide and catch: with the low steps of other robots on level ground, (step 2), they fell over boxes.
TEST_P(TwoJointLegs, StepAsHighOnLevelGroundAsOverRough) {
  sim3d::World world(robot_, {}, {}, nominal_posture(robot_));
  footstep_gen::Walker walker(robot_);
  TrialOptions options;
  options.schedule = {{0.0, Heading::straight(0.0), {}}};
  options.seconds = 8.0;
  int steps = 0;
  const Observer observer = [&](const footstep_gen::TickRecord& record, const auto&, const auto&) {
    for (LegId i = 0; i < robot_.num_legs(); ++i) {
      if (!record.lifts.contains(i)) continue;
      EXPECT_GE(record.footsteps[i].profile_height, walker.params().step.height);
      ++steps;
    }
  };
  (void)run_trial(walker, world, world.truth(), options, observer);
  EXPECT_GT(steps, 30);
}

// What it can't do: it goes ahead instead, and the referee says how far off that is.
TEST_P(TwoJointLegs, GoAheadOrBackWhereTheyAreToldToCrab) {
  for (const double crab : {0.25 * std::numbers::pi, -0.75 * std::numbers::pi}) {
    const Summary s = walked(Heading::straight(crab), 10.0, 1e9);
    EXPECT_TRUE(s.ok()) << in_words(s.hindrance, robot_);
    EXPECT_NEAR(s.distance / s.seconds, 0.068 * std::sqrt(0.5), 0.006);
    EXPECT_NEAR(s.lateral_end, s.distance, 0.05 * s.distance);
    EXPECT_EQ(s.rule1_violations, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(All, TwoJointLegs, ::testing::Values("genghis"),
                         [](const auto& of) { return std::string(of.param); });

// Hobby servos: a bus at 50 Hz that takes positions only, and half a degree of play in each gear, which
// odometry does not see. How far it strays is a matter of the start: feet a millimetre elsewhere, and it is another walk.
TEST(Desktop, WalksWithHobbyServos) {
  const RobotModel robot = load_urdf(testing::source_path("robots/desktop.urdf"));
  sim3d::WorldParams params;
  params.control_dt = 0.02;
  params.backlash = 0.5 * std::numbers::pi / 180.0;
  footstep_gen::WalkerParams slow;
  slow.control_dt = params.control_dt;
  TrialOptions options;
  options.schedule = {{0.0, Heading::straight(0.0), {}}};
  options.seconds = 20.0;
  constexpr int kWalks = 4;
  double strays = 0.0;
  for (std::uint64_t seed = 1; seed <= kWalks; ++seed) {
    sim3d::World world(robot, {}, params, random_posture(robot, 0.001, seed));
    FaultyPlant plant(world, robot, {.positions_only = true}, params.control_dt, seed);
    footstep_gen::Walker walker(robot, slow);
    const Summary s = run_trial(walker, plant, world.truth(), options);
    EXPECT_TRUE(s.ok()) << in_words(s.hindrance, robot);
    EXPECT_GE(s.speed, 0.08) << seed;
    strays += s.lateral_max / kWalks;
  }
  EXPECT_LT(strays, 0.05 * scale_of(robot).size);
}

/// One leg at a time, the centre of mass inside the other three feet. The body sways across its path,
/// so how far it is off says nothing; its feet are not.
using Quadrupeds = Robots;

TEST_P(Quadrupeds, Crawl) {
  const Summary s = walked(Heading::straight(0.0), 60.0, 1e9);
  EXPECT_TRUE(s.ok()) << in_words(s.hindrance, robot_);
  EXPECT_GT(s.speed, 0.03);
  EXPECT_GT(s.margin_min, 0.0);
  EXPECT_LT(s.heading_max, 0.01);
  EXPECT_LT(s.slip_p95, 0.002);
  EXPECT_EQ(s.neighbour_flight, 0.0);
}

TEST_P(Quadrupeds, CrawlAlongAnArcAndBackwardsAndTurn) {
  for (const Heading& heading :
       {Heading::arc(2.0 * length_, 0.0), Heading::straight(0.5 * std::numbers::pi),
        Heading::straight(std::numbers::pi)}) {
    const Summary s = walked(heading, 20.0, 1e9);
    EXPECT_TRUE(s.ok()) << in_words(s.hindrance, robot_);
    EXPECT_GT(s.distance, 0.4);
    EXPECT_LT(s.lateral_max, 0.2 * length_);
  }
  const Summary s = walked(Heading::spin(Turn::ccw), 20.0, 1e9);
  EXPECT_TRUE(s.ok()) << in_words(s.hindrance, robot_);
  EXPECT_GT(s.turned, 1.5);
}

// Their sway puts more weight on some feet than on others, (watch 2).
TEST_P(Quadrupeds, LoseNoLegAsTheirHeadingChanges) {
  EXPECT_TRUE(lost_as_headings_change(1, 60.0).empty());
}

INSTANTIATE_TEST_SUITE_P(All, Quadrupeds, ::testing::Values("quadruped", "quadruped_rpp"),
                         [](const auto& of) { return std::string(of.param); });

}  // namespace
}  // namespace hexagait::walk

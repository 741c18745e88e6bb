// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <hexagait/sim3d/world.hpp>
#include <hexagait/walk/faults/part_faults.hpp>
#include <hexagait/walk/trial.hpp>
#include <testing/argos.hpp>
#include <testing/control_period.hpp>

// Walks in which a leg is cut off, on flat ground.
namespace hexagait::walk::lost_leg_test {
namespace {

using footstep_gen::Walker;
using testing::argos;
using testing::kDt;

Summary walk_with(const std::vector<PartFault>& faults, double seconds = 15.0,
                  const sim3d::TerrainSpec& terrain = {}, const sim3d::WorldParams& params = {}) {
  TrialOptions options;
  options.schedule = {{0.0, heading_control::Heading::straight(0.0)}};
  options.seconds = seconds;
  sim3d::World world(argos(), terrain, params, nominal_posture(argos()));
  PartFaultPlant plant(world, faults, {[&](LegId leg) { world.cut(leg); }, {}, {}}, kDt, 0.0, 1);
  Walker walker(argos());
  return run_trial(walker, plant, world.truth(), options);
}

std::vector<PartFault> fault(LegId leg, const char* since, const char* how) {
  const std::string text = fmt::format("{}:{}@{}", how, argos().legs[leg].name, since);
  return resolved({parse_part_fault(text)}, argos());
}

Summary walk_without(LegId leg, const char* since, const char* how = "cut") {
  return walk_with(fault(leg, since, how));
}

constexpr std::array kInstants{"2.5s", "2.7s", "2.9s"};

// (watch 3). Found after a second, a leg that is gone has made five legs walk at 43 to 65 % of the speed of six, by the instant.
TEST(LostLeg, FiveLegsWalkAtMoreThanHalfTheSpeedOfSix) {
  const Summary six = walk_with({});
  for (LegId leg = 0; leg < 6; ++leg)
    for (const char* since : kInstants) {
      const Summary five = walk_without(leg, since);
      EXPECT_FALSE(five.fell) << leg << " " << since;
      EXPECT_GT(five.distance, 0.5 * six.distance) << leg << " " << since;
    }
}

// Its tripod has just begun to carry the robot: three legs rise, and two stand.
TEST(LostLeg, ALegThatGoesWhileItsTripodCarriesIsCaught) {
  for (LegId leg = 0; leg < 6; ++leg) EXPECT_FALSE(walk_without(leg, "2.75s").fell) << leg;
}

// Two feet stand, and the body falls over the line between them, ahead: where the feet that swing ahead go on it is caught, where
// they are put down at once 6 of 20 fall.
TEST(LostLeg, FeetThatSwingToWhereTheBodyFallsGoOn) {
  const std::vector<PartFault> cut = fault(0, "2.7s", "cut");
  const sim3d::TerrainSpec boxes = sim3d::parse_terrain("boxes:10cm");
  int falls = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    sim3d::WorldParams params;
    params.seed = seed;
    falls += walk_with(cut, 5.0, boxes, params).fell ? 1 : 0;
  }
  EXPECT_LE(falls, 1);
}

// (watch 2). Its contact tells nothing: it drags, and is put down like others. Without (watch 2) every third robot falls.
TEST(LostLeg, ADeadLegIsFoundAsItsTripodBeginsToCarry) {
  int falls = 0;
  double way = 0.0;
  for (LegId leg = 0; leg < 6; ++leg)
    for (const char* since : kInstants) {
      const Summary five = walk_without(leg, since, "dead");
      falls += five.fell ? 1 : 0;
      way += five.distance / (6 * kInstants.size());
    }
  EXPECT_LE(falls, 1);
  EXPECT_GT(way, 0.45 * walk_with({}).distance);
}

}  // namespace
}  // namespace hexagait::walk::lost_leg_test

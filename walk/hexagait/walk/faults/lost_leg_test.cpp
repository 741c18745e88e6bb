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

constexpr double kSeconds = 15.0;

Summary walk_with(const std::vector<PartFault>& faults) {
  TrialOptions options;
  options.schedule = {{0.0, heading_control::Heading::straight(0.0)}};
  options.seconds = kSeconds;
  sim3d::World world(argos(), {}, {}, nominal_posture(argos()));
  PartFaultPlant plant(world, faults, {[&](LegId leg) { world.cut(leg); }, {}, {}}, kDt, 0.0, 1);
  Walker walker(argos());
  return run_trial(walker, plant, world.truth(), options);
}

Summary walk_without(LegId leg, const char* since, const char* how = "cut") {
  const std::string fault = fmt::format("{}:{}@{}", how, argos().legs[leg].name, since);
  return walk_with(resolved({parse_part_fault(fault)}, argos()));
}

// Instants all through a step: when a leg goes decides by how much the robot tips, and so how far it gets.
constexpr std::array kInstants{"2.5s", "2.7s", "2.9s"};

// Of the leg that is gone nothing must stay in what the robot takes for up: on a slope that is none five legs walked at 29
// to 59 % of the speed of six.
TEST(LostLeg, FiveLegsWalkAtMoreThanHalfTheSpeedOfSix) {
  const Summary six = walk_with({});
  for (LegId leg = 0; leg < 6; ++leg) {
    double way = 0.0;
    for (const char* since : kInstants) {
      const Summary five = walk_without(leg, since);
      EXPECT_FALSE(five.fell) << leg << " " << since;
      EXPECT_GT(five.distance, 0.4 * six.distance) << leg << " " << since;
      way += five.distance / kInstants.size();
    }
    EXPECT_GT(way, 0.5 * six.distance) << leg;
  }
}

// Its tripod has just begun to carry the robot: three legs rise, and two stand.
TEST(LostLeg, ALegThatGoesWhileItsTripodCarriesIsCaught) {
  for (LegId leg = 0; leg < 6; ++leg) EXPECT_FALSE(walk_without(leg, "2.75s").fell) << leg;
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

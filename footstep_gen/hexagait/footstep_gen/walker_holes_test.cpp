// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <hexagait/footstep_gen/walker.hpp>
#include <testing/argos.hpp>
#include <testing/kinematic_plant.hpp>

namespace hexagait::footstep_gen::walker_holes_test {
namespace {

constexpr double kDt = 0.005;
constexpr double kBegins = 0.8, kWidth = 0.3;  // of the ditch [m]

double ditch(const Vector2& p_O) {
  return p_O.x() > kBegins && p_O.x() < kBegins + kWidth ? -1.0 : 0.0;
}

struct Crossing {
  double distance = 0.0;  ///< after 40 s [m]
  int searches = 0;       ///< feet that found no ground
};

// Stones of 25 cm with gaps of 15 cm, with a pad in the middle. The right feet walk along a gap.
double stones(const Vector2& p_O) {
  const auto on_stone = [](double x) { return x - 0.4 * std::floor(x / 0.4) < 0.25; };
  const bool pad = std::abs(p_O.x()) < 0.8 && std::abs(p_O.y()) < 0.8;
  return pad || (on_stone(p_O.x()) && on_stone(p_O.y())) ? 0.0 : -1.0;
}

Crossing cross(std::uint64_t seed, double (*ground)(const Vector2&) = ditch) {
  const RobotModel argos = hexagait::testing::argos();
  WalkerParams params;
  params.control_dt = kDt;
  Walker walker(argos, params);
  testing::KinematicPlant plant(argos, 0.5, {.seed = seed});
  plant.ground = ground;
  walker.start(plant.measurement);
  Crossing crossing;
  for (int k = 0; k < 8000; ++k) {
    const TickRecord& record =
        walker.tick(PlantStatus::fresh, plant.measurement, heading_control::Heading::straight(0.0));
    plant.follow(record, kDt);
    for (const LegLane& lane : record.legs) crossing.searches += lane.found_no_ground ? 1 : 0;
  }
  crossing.distance = plant.X_OB.p.x();
  return crossing;
}

// (step 11) The first steps are as high as over rough ground, but edges are felt from the first one on, unless the feet
// stand on uneven ground already.
TEST(WalkerOverHoles, FeelsEdgesFromTheFirstStepOn) {
  const RobotModel argos = hexagait::testing::argos();
  for (const double raised : {0.0, 1.5 * argos.foot_radius}) {  // leg LF [m]
    Walker walker(argos);
    testing::KinematicPlant plant(argos, 0.0, {.seed = 1});
    plant.measurement.q[0] =
        inverse_kinematics(argos.legs[0], argos.legs[0].p_BC + Vector3(0.0, 0.0, raised)).q;
    walker.start(plant.measurement);
    const TickRecord* record = &walker.record();
    for (int k = 0; k < 200 && record->lifts.empty(); ++k)
      record = &walker.tick(PlantStatus::fresh, plant.measurement,
                            heading_control::Heading::straight(0.0));
    ASSERT_FALSE(record->lifts.empty());
    for (LegId i = 0; i < argos.num_legs(); ++i) {
      if (!record->lifts.contains(i)) continue;
      EXPECT_GE(record->footsteps[i].profile_height, walker.params().step.height);
      EXPECT_EQ(record->footsteps[i].depth.edge,
                raised > 0.0 ? SearchDepth::kNever : edge_depth(0.0, argos.foot_radius));
    }
  }
}

// The body comes along while a foot is in the air: it may step farther than its workspace reaches at the lift.
TEST(WalkerOverHoles, StepsAsFarAsTheWorkspaceWillBeWhenTheFootLands) {
  int over = 0;
  for (std::uint64_t seed = 1; seed <= 48; ++seed) {
    const Crossing crossing = cross(seed);
    over += crossing.distance > 6.0 ? 1 : 0;
    EXPECT_GT(crossing.searches, 0) << seed;
  }
  EXPECT_GT(over, 31) << "of 48";
}

// (step 13)
TEST(WalkerOverHoles, StepsBesideItsPathOnSteppingStones) {
  int over = 0;
  for (std::uint64_t seed = 1; seed <= 16; ++seed)
    over += cross(seed, stones).distance > 3.0 ? 1 : 0;
  EXPECT_GT(over, 11) << "of 16";
}

}  // namespace
}  // namespace hexagait::footstep_gen::walker_holes_test

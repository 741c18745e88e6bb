// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <hexagait/fg16/foot_tracks.hpp>
#include <hexagait/fg16/foothold_route.hpp>
#include <hexagait/fg16/localisation.hpp>
#include <hexagait/sim3d/world.hpp>
#include <hexagait/walk/actions/action_trial.hpp>
#include <hexagait/walk/trial.hpp>
#include <testing/argos.hpp>

namespace hexagait::experiments {
namespace {

using testing::argos;

const Route kRoute = {.start = -1.0, .end = 0.0};  // odom is not the map

// A short walk on the level by two pairs of footholds.
FootTracks walked(double yaw_error, const walk::Localisation& localisation = {}) {
  sim3d::WorldParams params;
  params.start.shift = {kRoute.start, 0.0};
  sim3d::World world(argos(), {}, params, walk::nominal_posture(argos()));
  MiscalibratedPlant plant(world, argos(), yaw_error);
  auto footholds = footholds_along(kRoute, argos(), world.terrain());
  footholds.resize(2);
  ActionRunner runner(argos());
  FootTracks tracks;
  walk::ActionTrialOptions options;
  options.localisation = localisation;
  const auto summary = walk::run_action(runner, plant, world.truth(), walk_on(footholds, "walk"),
                                        options, [&](const auto&, const GroundTruth& truth) {
                                          tracks.observe(runner, runner.frames().X_OM, truth);
                                          return true;
                                        });
  EXPECT_TRUE(summary.ok());
  return tracks;
}

const FootTracks& walked_well() {
  static const FootTracks tracks = walked(0.0);
  return tracks;
}

TEST(FootTracks, FindEachTouchdownAtItsFoothold) {
  const FootTracks& tracks = walked_well();
  const auto footholds = footholds_along(kRoute, argos(), sim3d::Terrain({}, 1));
  ASSERT_EQ(tracks.touchdowns().size(), 4U);
  for (const FootTracks::Touchdown& t : tracks.touchdowns()) {
    EXPECT_LT(t.error(), 0.003);
    EXPECT_TRUE(std::any_of(footholds.begin(), footholds.begin() + 2, [&](const auto& pair) {
      return std::ranges::any_of(
          pair, [&](const Foothold& f) { return f.leg == t.leg && f.p_MF == t.foothold; });
    }));
  }
}

// In a swing of 8 cm upwards the command is followed within millimetres; that is not so if the
// command were taken from another foot or frame.
TEST(FootTracks, CompareEachSwingingFootWithItsOwnCommand) {
  const FootTracks& tracks = walked_well();
  EXPECT_GT(tracks.swing_errors().size(), 150U);
  EXPECT_LT(walk::percentile(tracks.swing_errors(), 1.0), 0.01);
  EXPECT_GT(walk::percentile(tracks.swing_errors(), 0.5), 1e-5);
}

// The foot's centre turns about its hip by the error, at a distance of its horizontal reach; by
// odometry, all seems well.
TEST(FootTracks, ShowWhatAMiscalibratedRobotDoesNotKnow) {
  const FootTracks tracks = walked(0.02);
  const LegModel& leg = argos().legs[2];
  const double reach = (leg.p_BC - leg.p_BJ0[0]).head<2>().norm();
  const FootTracks::Sample& first = tracks.samples().front();
  EXPECT_NEAR((first.by_odometry[2] - first.reached[2]).head<2>().norm(), 0.02 * reach, 0.002);
}

// A map that jumps by 5 cm moves the foot by 5 cm, where localisation has it, and no command.
TEST(FootTracks, TellJumpsOfLocalisationFromThoseOfCommands) {
  int tick = 0;
  const auto jumping = [&tick](const ActionRecord& record, const GroundTruth& truth) {
    Pose X_MB = truth.X_WB;
    if (++tick > 300) X_MB.p.y() += 0.05;
    return record.state.X_OB * X_MB.inverse();
  };
  const FootTracks tracks = walked(0.0, jumping);
  EXPECT_NEAR(tracks.localised_jump(), 0.05, 0.002);
  EXPECT_LT(tracks.commanded_jump(), 0.001);
}

}  // namespace
}  // namespace hexagait::experiments

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// [FG16] Fig. 7: footholds in the map, a localisation that jumps, and odometry that drifts. Free
// Gait takes each motion from the map to odom when it starts: smooth and accurate.
#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>
#include <hexagait/experiments/experiment.hpp>
#include <hexagait/experiments/foot_tracks.hpp>
#include <hexagait/experiments/foothold_route.hpp>
#include <hexagait/experiments/gnuplot.hpp>
#include <hexagait/experiments/localisation.hpp>
#include <hexagait/walk/action_trial.hpp>

namespace hexagait::experiments {
namespace {

constexpr const char* kTerrain = "step:0.12";
const Route kRoute = {.start = -1.8};  // 2.4 m on the level, then up the step
constexpr double kYawError = 0.0175;   // of the joints' zeros, 1°: drifts by 5 cm over 3 m [rad]
constexpr std::uint64_t kSeed = 1;
constexpr LegId kShown = 0;  // LF

struct Walk {
  walk::ActionSummary summary;
  FootTracks tracks;
};

enum class Map { combined, odometry_only };

// Odometry only: the localisation says where the robot starts, and then nothing more.
Walk walk(Map map, const ExperimentContext& context) {
  const RobotModel& robot = *context.robot;
  const sim3d::TerrainSpec terrain = sim3d::parse_terrain(kTerrain);
  sim3d::WorldParams params;
  params.start.shift = {kRoute.start, 0.0};
  sim3d::World world(robot, terrain, params, walk::nominal_posture(robot));
  MiscalibratedPlant plant(world, kYawError);

  Walk walk;
  ActionRunner runner(robot);
  JumpingLocalisation localisation({.seed = kSeed});
  std::optional<Pose> X_OM_start;
  walk::ActionTrialOptions options;
  options.localisation = [&](const ActionRecord& record, const GroundTruth& truth) {
    if (!X_OM_start) X_OM_start = record.state.X_OB * truth.X_WB.inverse();
    return map == Map::combined ? localisation.X_OM(record, truth) : *X_OM_start;
  };
  const auto observe = [&](const ActionRecord&, const GroundTruth& truth) {
    walk.tracks.observe(runner, runner.frames().X_OM, truth);
    return context.stop == nullptr || !context.stop->load();
  };
  const auto footholds = footholds_along(kRoute, robot, world.terrain());
  const action::Action action = walk_on(footholds, "walk in the map");
  walk.summary = walk::run_action(runner, plant, world.truth(), action, options, observe);
  return walk;
}

}  // namespace
}  // namespace hexagait::experiments

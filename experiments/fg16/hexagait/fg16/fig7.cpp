// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// [FG16] Fig. 7: footholds in the map, a localisation that jumps, and odometry that drifts. Free
// Gait takes each motion from the map to odom when it starts: smooth and accurate.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <hexagait/fg16/fg16.hpp>
#include <hexagait/fg16/fig7.gp.hpp>
#include <hexagait/fg16/foot_tracks.hpp>
#include <hexagait/fg16/foothold_route.hpp>
#include <hexagait/fg16/judges.hpp>
#include <hexagait/fg16/localisation.hpp>
#include <hexagait/figures/csv.hpp>
#include <hexagait/walk/actions/action_trial.hpp>

namespace hexagait::experiments {
namespace {

const Route kLevelThenUp = {.start = -1.8};  // 2.4 m on the level, then up the step
constexpr double kYawError = 0.0175;  // of the joints' zeros, 1°: drifts by 5 cm over 3 m [rad]
constexpr std::uint64_t kSeed = 1;
constexpr LegId kShownLeg = 0;  // LF
constexpr double kZoom = 20.0;  // of its track, from here on [s]

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
  params.start.shift = {kLevelThenUp.start, 0.0};
  sim3d::World world(robot, terrain, params, walk::nominal_posture(robot));
  MiscalibratedPlant plant(world, robot, kYawError);

  Walk walk;
  ActionRunner runner(robot);
  Spectator* const spectator = map == Map::combined ? context.spectator : nullptr;
  if (spectator != nullptr) spectator->begin_action(robot, params);
  JumpingLocalisation localisation({.seed = kSeed});
  std::optional<Pose> X_OM_start;
  walk::ActionTrialOptions options;
  options.localisation = [&](const ActionRecord& record, const GroundTruth& truth) {
    if (!X_OM_start) X_OM_start = record.state.X_OB * truth.X_WB.inverse();
    return map == Map::combined ? localisation.X_OM(record, truth) : *X_OM_start;
  };
  const auto observe = [&](const ActionRecord& record, const GroundTruth& truth) {
    if (spectator != nullptr) spectator->observe(record, truth, world);
    walk.tracks.observe(runner, runner.frames().X_OM, truth);
    return !context.stopped();
  };
  const auto footholds = footholds_along(kLevelThenUp, robot, world.terrain());
  const action::Action action = walk_on(footholds, "walk in the map");
  walk.summary = walk::run_action(runner, plant, world.truth(), action, options, observe);
  return walk;
}

// How far the base is when this foothold is the foot's place under it [m].
double way(const FootTracks::Touchdown& t, const RobotModel& robot) {
  return t.foothold.x() - robot.legs[t.leg].p_BC.x() - kLevelThenUp.start;
}

// The foot that is shown, in three frames; and all touchdowns of both walks.
void write_tracks(figures::StagedFiles& files, const Walk& combined, const Walk& odometry,
                  const RobotModel& robot) {
  figures::Csv foot(
      "time_s,localised_x_m,localised_y_m,localised_z_m,odometry_x_m,odometry_y_m,odometry_z_m,"
      "x_m,y_m,z_m");
  for (const FootTracks::Sample& s : combined.tracks.samples())
    foot.row(s.time, s.by_localisation[kShownLeg], s.by_odometry[kShownLeg], s.reached[kShownLeg]);
  figures::Csv touchdowns(
      "odometry_only,leg,way_m,foothold_x_m,foothold_y_m,foothold_z_m,x_m,y_m,z_m,error_m");
  for (const Walk* walk : {&combined, &odometry})
    for (const FootTracks::Touchdown& t : walk->tracks.touchdowns())
      touchdowns.row(walk == &odometry, t.leg, way(t, robot), t.foothold, t.reached, t.error());
  figures::write_tables(files, "fg16_fig7", {{"foot", foot}, {"touchdowns", touchdowns}});
}

void draw(figures::StagedFiles& files, const ExperimentContext& context, const Walk& combined,
          const Walk& odometry) {
  const RobotModel& robot = *context.robot;
  write_tracks(files, combined, odometry, robot);
  figures::draw_figure(
      files,
      context.figure(
          "fg16_fig7", 1500, 1000,
          "Localisation that jumps, odometry that drifts, and the two combined",
          fmt::format("{} · {:.1f} m by footholds in the map · odometry is off by {:.1f} cm in the "
                      "end, for yaw joints that are off by {:.1f}° · a fix every {} s · after "
                      "[FG16] Fig. 7",
                      robot.name, kLevelThenUp.end - kLevelThenUp.start,
                      100.0 * combined.summary.odometry_position,
                      kYawError * 180.0 / std::numbers::pi, JumpingLocalisation::Params{}.period)),
      {{"y_min", robot.legs[kShownLeg].p_BC.y() - 0.045}, {"zoom", kZoom}, {"step_x", kStepBegins}},
      scripts::fg16::fig7);
}

// Distances from the footholds of all touchdowns after this way [m].
std::vector<double> errors_from(const Walk& walk, double from, const RobotModel& robot) {
  std::vector<double> errors;
  for (const FootTracks::Touchdown& t : walk.tracks.touchdowns())
    if (way(t, robot) > from) errors.push_back(t.error());
  return errors;
}

LocalisedWalk judged(const Walk& walk, const RobotModel& robot) {
  const double last_metre = kLevelThenUp.end - kLevelThenUp.start - 1.0;
  return {walk.summary, walk.tracks.commanded_jump(), walk.tracks.localised_jump(),
          errors_from(walk, last_metre, robot), errors_from(walk, -1.0, robot)};
}

}  // namespace

Outcome fg16_fig7(const ExperimentContext& context, figures::StagedFiles& files) {
  const Walk combined = walk(Map::combined, context);
  context.tell(1, 2);
  const Walk odometry = walk(Map::odometry_only, context);
  if (context.stopped()) return {};
  draw(files, context, combined, odometry);
  return {.verdicts = judge_localised(
              judged(combined, *context.robot), judged(odometry, *context.robot),
              kLevelThenUp.end - kLevelThenUp.start, JumpingLocalisation::Params{}.shift),
          .settings = {{"robot", context.robot->name},
                       {"terrain", kTerrain},
                       {"seed", std::to_string(kSeed)},
                       {"yaw_error_rad", fmt::format("{}", kYawError)}},
          .provenance =
              recording::provenance(context.robot->name, *context.robot, recording::Simulation{})};
}

}  // namespace hexagait::experiments

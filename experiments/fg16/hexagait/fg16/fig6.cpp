// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// [FG16] Fig. 6: a list of footholds in the map takes the robot up a step of 12 cm, from four
// starting positions. Somebody pushes the base meanwhile, and one foothold is blocked.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <hexagait/fg16/fg16.hpp>
#include <hexagait/fg16/fig6.gp.hpp>
#include <hexagait/fg16/foot_tracks.hpp>
#include <hexagait/fg16/foothold_route.hpp>
#include <hexagait/fg16/judges.hpp>
#include <hexagait/figures/csv.hpp>
#include <hexagait/walk/actions/action_trial.hpp>

namespace hexagait::experiments {
namespace {

const Route kUpTheStep = {};
const std::array<PlanarPose, 4> kStarts = {
    {{0.0, {0.0, 0.0}}, {0.07, {-0.08, 0.05}}, {-0.10, {0.06, -0.06}}, {0.10, {-0.05, -0.08}}}};
constexpr std::size_t kBlocked = 3;     // the trial with a blocked foothold
constexpr std::size_t kShownTrial = 0;  // the trial that the experiment shows

// A push every 2.5 s, of half the robot's weight: left, right, back, left.
const std::array<Vector3, 4> kPushes = {
    {{0.0, 250.0, 0.0}, {0.0, -250.0, 0.0}, {-250.0, 0.0, 0.0}, {0.0, 250.0, 0.0}}};
constexpr double kPushSeconds = 0.3, kPushPeriod = 2.5;

// The second foothold of LM: a block of 6 cm stands on it and begins 1 cm before it.
constexpr std::size_t kBlockedPair = 4, kBlockedFoot = 0;
const Vector3 kBlockSize(0.10, 0.16, 0.06);
constexpr double kBlockBegins = -0.01;

struct Climb {
  walk::ActionSummary summary;
  FootTracks tracks;
  std::vector<Vector3> pushed_at;  ///< where the base was [m]
};

sim3d::Block block_on(const Foothold& foothold, double foot_radius) {
  const Vector3 shift(kBlockBegins + 0.5 * kBlockSize.x(), 0.0, 0.5 * kBlockSize.z() - foot_radius);
  return {foothold.p_MF + shift, kBlockSize};
}

Climb climb(std::size_t trial, const ExperimentContext& context,
            std::vector<sim3d::Block>& blocks) {
  const RobotModel& robot = *context.robot;
  const sim3d::TerrainSpec terrain = sim3d::parse_terrain(kTerrain);
  const auto footholds = footholds_along(kUpTheStep, robot, sim3d::Terrain(terrain, 1));
  sim3d::WorldParams params;
  params.start = kStarts[trial];
  if (trial == kBlocked)
    params.blocks = {block_on(footholds[kBlockedPair][kBlockedFoot], robot.foot_radius)};
  blocks = params.blocks;
  sim3d::World world(robot, terrain, params, walk::nominal_posture(robot));

  Climb climb;
  ActionRunner runner(robot);
  Spectator* const spectator = trial == kShownTrial ? context.spectator : nullptr;
  if (spectator != nullptr) spectator->begin_action(robot, params);
  double next_push = kPushPeriod + 0.3 * static_cast<double>(trial);
  const auto observe = [&](const ActionRecord& record, const GroundTruth& truth) {
    if (spectator != nullptr) spectator->observe(record, truth, world);
    climb.tracks.observe(runner, runner.frames().X_OM, truth);
    if (truth.time >= next_push && climb.pushed_at.size() < kPushes.size()) {
      world.push(kPushes[climb.pushed_at.size()], kPushSeconds);
      climb.pushed_at.push_back(truth.X_WB.p);
      next_push += kPushPeriod;
    }
    return !context.stopped();
  };
  const action::Action action = walk_on(footholds, "climb");
  climb.summary = walk::run_action(runner, world, world.truth(), action, {}, observe);
  return climb;
}

using Climbs = std::array<Climb, kStarts.size()>;

// Feet leg by leg of each trial, a blank line after each swing; touchdowns; the base and its pushes;
// the share of the swing samples whose error is less, and in words what the legend says of it.
std::vector<std::string> write_tracks(figures::StagedFiles& files, const Climbs& climbs) {
  figures::Csv feet(
      "time_s,trial,leg,commanded_x_m,commanded_y_m,commanded_z_m,x_m,y_m,z_m,error_m");
  figures::Csv touchdowns(
      "time_s,trial,leg,foothold_x_m,foothold_y_m,foothold_z_m,x_m,y_m,z_m,error_m");
  figures::Csv base("time_s,trial,x_m,y_m,z_m"), pushes("trial,x_m,y_m,force_x_n,force_y_n");
  figures::Csv shares("trial,error_m,share");
  std::vector<std::string> legends;
  for (std::size_t trial = 0; trial < climbs.size(); ++trial) {
    const auto& [summary, tracks, pushed_at] = climbs[trial];
    for (LegId i = 0; i < 6; ++i)
      for (const FootTracks::Sample& s : tracks.samples())
        if (s.swinging.contains(i))
          feet.row(s.time, trial, i, s.commanded[i], s.reached[i],
                   (s.commanded[i] - s.reached[i]).norm());
        else
          feet.gap();
    for (const FootTracks::Touchdown& t : tracks.touchdowns())
      touchdowns.row(t.time, trial, t.leg, t.foothold, t.reached, t.error());
    for (const FootTracks::Sample& s : tracks.samples()) base.row(s.time, trial, s.X_MB.p);
    for (std::size_t k = 0; k < pushed_at.size(); ++k)
      pushes.row(trial, pushed_at[k].x(), pushed_at[k].y(), kPushes[k].x(), kPushes[k].y());
    const std::vector<double> errors = tracks.swing_errors();
    const auto error_of = [&](double share) { return walk::percentile(errors, share); };
    for (int k = 0; k <= 200; ++k) shares.row(trial, error_of(k / 200.0), k / 200.0);
    for (figures::Csv* csv : {&feet, &base, &shares}) csv->gap();
    legends.push_back(fmt::format("{}: median {:.1f} mm, 95 % {:.1f} mm{}", "ABCD"[trial],
                                  1e3 * error_of(0.5), 1e3 * error_of(0.95),
                                  trial == kBlocked ? ", blocked" : ""));
  }
  figures::write_tables(files, "fg16_fig6",
                        {{"feet", feet},
                         {"touchdowns", touchdowns},
                         {"base", base},
                         {"pushes", pushes},
                         {"shares", shares}});
  return legends;
}

void draw(figures::StagedFiles& files, const ExperimentContext& context, const Climbs& climbs,
          const sim3d::Block& block) {
  const double step_height = sim3d::parse_terrain(kTerrain).roughness();
  figures::draw_figure(
      files,
      context.figure(
          "fg16_fig6", 1500, 1100,
          fmt::format("A list of footholds over a step of {:.0f} cm, from four starting positions",
                      100.0 * step_height),
          fmt::format("{} · Footstep and BaseAuto · in each trial four pushes of {:.0f} N for {} s "
                      "· a foothold blocked in D · after [FG16] Fig. 6",
                      context.robot->name, kPushes.front().norm(), kPushSeconds)),
      {{"foot_radius", context.robot->foot_radius},
       {"step_x", kStepBegins},
       {"step_height", step_height},
       {"block_x", block.centre.x() - 0.5 * block.size.x()},
       {"block_y", block.centre.y()},
       {"block_length", block.size.x()},
       {"block_width", block.size.y()},
       {"block_height", block.size.z()},
       {"legends", write_tracks(files, climbs)}},
      scripts::fg16::fig6);
}

std::vector<Verdict> judge(const Climbs& climbs, const RobotModel& robot) {
  std::vector<Climbed> judged;
  for (const Climb& c : climbs)
    judged.push_back({c.summary, c.tracks.swing_errors(), c.tracks.touchdowns()});
  const auto footholds =
      footholds_along(kUpTheStep, robot, sim3d::Terrain(sim3d::parse_terrain(kTerrain), 1));
  const Foothold& blocked = footholds[kBlockedPair][kBlockedFoot];
  return judge_climbs(judged, judged[kBlocked], blocked.leg, blocked.p_MF);
}

}  // namespace

Outcome fg16_fig6(const ExperimentContext& context, figures::StagedFiles& files) {
  Climbs climbs;
  std::vector<sim3d::Block> blocks;
  for (std::size_t k = 0; k < climbs.size(); ++k) {
    climbs[k] = climb(k, context, blocks);
    if (context.stopped()) return {};
    context.tell(k + 1, climbs.size());
  }
  draw(files, context, climbs, blocks.front());
  return {.verdicts = judge(climbs, *context.robot),
          .settings = {{"robot", context.robot->name},
                       {"terrain", kTerrain},
                       {"trials", std::to_string(climbs.size())},
                       {"push",
                        fmt::format("{:.0f} N for {} s", kPushes.front().norm(), kPushSeconds)}},
          .provenance =
              recording::provenance(context.robot->name, *context.robot, recording::Simulation{})};
}

}  // namespace hexagait::experiments

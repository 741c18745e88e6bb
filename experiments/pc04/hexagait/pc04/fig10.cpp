// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// [PC04] Fig. 10: a turn to the left on abrupt terrain, of which the controller knows nothing but
// what its feet touch.
#include <fmt/format.h>

#include <cmath>
#include <hexagait/pc04/judges.hpp>
#include <hexagait/pc04/pc04.hpp>
#include <hexagait/pc04/snapshots.hpp>

namespace hexagait::experiments {
namespace {

using heading_control::Heading;

constexpr double kRadius = 2.0;       // [m]
constexpr double kHighestBox = 0.15;  // half of the body's height [m]
constexpr int kOthers = 7;            // walks on other terrains

}  // namespace

Outcome fig10(const ExperimentContext& context, figures::StagedFiles& files) {
  recording::Simulation simulation;
  simulation.plant = context.plant;
  simulation.terrain = {sim3d::TerrainKind::boxes, kHighestBox};
  simulation.trial.schedule = {{0.0, Heading::arc(kRadius, 0.0)}};
  simulation.trial.seconds = context.short_form ? 10.0 : 50.0;

  const auto [recording, summary] = record(context, simulation);
  std::vector<walk::Summary> others;
  recording::Simulation other = simulation;
  // In the figure the first terrain, whatever becomes of the robot there.
  for (int k = 0; k < (context.short_form ? 2 : kOthers); ++k) {
    ++other.seed;
    others.push_back(recording::simulate(*context.robot, other, {}, context.stop));
  }
  const double end = recording.samples().back().time;
  draw_snapshots(
      files,
      context.figure(
          "fig10", 0, 0,
          fmt::format("A turn to the left over boxes of up to {:.0f} cm", 100.0 * kHighestBox),
          fmt::format("{} · r = {:.1f} m · {:.1f} m in {:.0f} s · at most {:.1f} cm off "
                      "the commanded curve · after [PC04] Fig. 10",
                      context.robot->name, kRadius, summary.distance, summary.seconds,
                      100.0 * summary.lateral_max)),
      {0.0, 0.25 * end, 0.5 * end, 0.75 * end, end}, {simulation.terrain, simulation.seed},
      recording, *context.robot);
  return {.walk = recording::WalkReport{context.robot->name, simulation, summary},
          .verdicts = judged_in_full_only(judge_fig10(summary, others), context.short_form)};
}

}  // namespace hexagait::experiments

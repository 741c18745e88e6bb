// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// [PC04] Fig. 9: a straight line, a turn in place, a straight line, a curve and a straight line,
// walked in one go on flat ground, with the robot drawn at the instants A to H.
#include <fmt/format.h>

#include <algorithm>
#include <hexagait/pc04/judges.hpp>
#include <hexagait/pc04/pc04.hpp>
#include <hexagait/pc04/snapshots.hpp>

namespace hexagait::experiments {
namespace {

using heading_control::Heading;
using heading_control::Turn;

constexpr double kShort = 0.2;  // of all times, in the short form

// @param share  of the times
walk::Schedule trajectory(double share) {
  return {{0.0, Heading::straight(0.0)},
          {share * 11.0, Heading::spin(Turn::ccw)},
          {share * 17.0, Heading::straight(0.0)},
          {share * 28.0, Heading::arc(-1.2, 0.0)},
          {share * 45.0, Heading::straight(0.0)}};
}

}  // namespace

Outcome fig9(const ExperimentContext& context, figures::StagedFiles& files) {
  const double share = context.short_form ? kShort : 1.0;
  recording::Simulation simulation;
  simulation.plant = context.plant;
  simulation.trial.schedule = trajectory(share);
  simulation.trial.seconds = share * 56.0;
  std::vector<double> instants = {0.0, 6.0, 15.5, 21.5, 27.0, 34.0, 42.0, 55.0};
  for (double& time : instants) time *= share;

  const auto [recording, summary] = record(context, simulation);
  draw_snapshots(
      files,
      context.figure("fig9", 0, 0, "Straight, turn in place, straight, curve, straight",
                     fmt::format("{} · {:.1f} m in {:.0f} s · {:.1f} mm off the commanded curve on "
                                 "average · after [PC04] Fig. 9",
                                 context.robot->name, summary.distance, summary.seconds,
                                 1e3 * summary.lateral_mean)),
      instants, {simulation.terrain, simulation.seed}, recording, *context.robot);
  return {.walk = recording::WalkReport{context.robot->name, simulation, summary},
          .verdicts = judged_in_full_only(judge_fig9(summary, longest_pause(recording)),
                                          context.short_form)};
}

}  // namespace hexagait::experiments

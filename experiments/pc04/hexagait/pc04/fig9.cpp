// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// [PC04] Fig. 9: a straight line, a turn in place, a straight line, a curve and a straight line,
// walked in one go on flat ground, with the robot drawn at the instants A to H.
#include <fmt/format.h>

#include <algorithm>
#include <hexagait/pc04/pc04.hpp>
#include <hexagait/pc04/snapshots.hpp>

namespace hexagait::experiments {
namespace {

using heading_control::Heading;
using heading_control::Turn;

constexpr double kSeconds = 56.0;
constexpr double kLateralMean = 0.01;  // off the curve on average [m]

// Off the curve at most: a turn in place commanded at full speed. The base brakes from 0.3 m/s
// while it starts to turn at 0.8 rad/s; at 0.8 m from it, 1.2 m/s² allow both within 0.8 s, in
// which the speed left over makes 0.3 · 0.8/2 m.
constexpr double kLateralMax = 0.12;
constexpr double kLongestPause = 1.5;  // between two lifts, of which one step takes 0.85 [s]

walk::Schedule trajectory() {
  return {{0.0, Heading::straight(0.0)},
          {11.0, Heading::spin(Turn::ccw)},
          {17.0, Heading::straight(0.0)},
          {28.0, Heading::arc(-1.2, 0.0)},
          {45.0, Heading::straight(0.0)}};
}

double longest_pause(const recording::Recording& recording) {
  double pause = 0.0;
  const auto& steps = recording.steps();
  for (std::size_t k = 1; k < steps.size(); ++k)
    pause = std::max(pause, steps[k].lift - steps[k - 1].lift);
  return pause;
}

std::vector<Verdict> judge(const walk::Summary& s, double pause) {
  return {
      {"One controller follows straight lines, turns in place and curves, one after the other",
       s.ok() && s.lateral_mean < kLateralMean && s.lateral_max < kLateralMax,
       fmt::format(
           "{:.1f} m, off the commanded curve by {:.1f} mm on average and {:.1f} mm at most, where "
           "a turn in place begins at full speed",
           s.distance, 1e3 * s.lateral_mean, 1e3 * s.lateral_max)},
      {"It goes from one to the next without a pause to rearrange its legs", pause < kLongestPause,
       fmt::format("{} steps, at most {:.2f} s between two lifts", s.steps, pause)},
      {"No two neighbouring legs are ever off the ground together",
       s.rule1_violations == 0 && s.neighbour_flight == 0.0,
       fmt::format("{} violations, {:.3f} s", s.rule1_violations, s.neighbour_flight)}};
}

}  // namespace

Outcome fig9(const ExperimentContext& context, figures::StagedFiles& files) {
  recording::Simulation simulation;
  simulation.trial.schedule = trajectory();
  simulation.trial.seconds = kSeconds;

  const auto [recording, summary] = record(context, simulation);
  draw_snapshots(
      files,
      context.figure("fig9", 0, 0, "Straight, turn in place, straight, curve, straight",
                     fmt::format("{} · {:.1f} m in {:.0f} s · {:.1f} mm off the commanded curve on "
                                 "average · after [PC04] Fig. 9",
                                 context.robot->name, summary.distance, summary.seconds,
                                 1e3 * summary.lateral_mean)),
      {0.0, 6.0, 15.5, 21.5, 27.0, 34.0, 42.0, 55.0}, {simulation.terrain, simulation.seed},
      recording, *context.robot);
  return {.walk = recording::WalkReport{context.robot->name, simulation, summary},
          .verdicts = judge(summary, longest_pause(recording))};
}

}  // namespace hexagait::experiments

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// [PC04] Fig. 10: a turn to the left on abrupt terrain, of which the controller knows nothing but
// what its feet touch.
#include <fmt/format.h>

#include <cmath>
#include <hexagait/pc04/pc04.hpp>
#include <hexagait/pc04/snapshots.hpp>

namespace hexagait::experiments {
namespace {

using heading_control::Heading;

constexpr double kSeconds = 50.0;
constexpr double kRadius = 2.0;      // [m]
constexpr double kRoughness = 0.15;  // half of the body's height [m]
constexpr double kDrift = 0.05;      // off the curve at most, as a share of the distance

std::vector<Verdict> judge(const walk::Summary& s) {
  return {
      {"The robot gets over abrupt terrain without a map of it", s.ok(),
       fmt::format("{:.1f} m over boxes of up to {:.0f} cm in {:.0f} s", s.distance,
                   100.0 * kRoughness, s.seconds)},
      {"It stays on the commanded curve, by dead reckoning alone",
       s.lateral_max < kDrift * s.distance,
       fmt::format("{:.1f} cm off at most, {:.1f} % of the distance; heading {:.1f}° off",
                   100.0 * s.lateral_max, 100.0 * s.lateral_max / s.distance,
                   s.heading_max * 180.0 / std::numbers::pi)},
      {"No leg is lifted while a neighbour is known to be off the ground", s.rule1_violations == 0,
       fmt::format("{} violations in {} steps; in fact {:.2f} s with two neighbours off the "
                   "ground",
                   s.rule1_violations, s.steps, s.neighbour_flight)}};
}

}  // namespace

Outcome fig10(const ExperimentContext& context, figures::StagedFiles& files) {
  recording::Simulation simulation;
  simulation.terrain = {sim3d::TerrainSpec::Kind::boxes, kRoughness};
  simulation.trial.schedule = {{0.0, Heading::arc(kRadius, 0.0)}};
  simulation.trial.seconds = kSeconds;

  const auto [recording, summary] = record(context, simulation);
  const double end = recording.samples().back().time;
  draw_snapshots(
      files,
      context.figure(
          "fig10", 0, 0,
          fmt::format("A turn to the left over boxes of up to {:.0f} cm", 100.0 * kRoughness),
          fmt::format("{} · r = {:.1f} m · {:.1f} m in {:.0f} s · at most {:.1f} cm off "
                      "the commanded curve · after [PC04] Fig. 10",
                      context.robot->name, kRadius, summary.distance, summary.seconds,
                      100.0 * summary.lateral_max)),
      {0.0, 0.25 * end, 0.5 * end, 0.75 * end, end}, {simulation.terrain, simulation.seed},
      recording, *context.robot);
  return {.walk = recording::WalkReport{context.robot->name, simulation, summary},
          .verdicts = judge(summary)};
}

}  // namespace hexagait::experiments

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <hexagait/experiments/walk_checks.hpp>
#include <hexagait/fg16/judges.hpp>
#include <hexagait/walk/referee/referee.hpp>
#include <numbers>

namespace hexagait::experiments {
namespace {

using walk::percentile;
using Touchdown = FootTracks::Touchdown;

double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

std::vector<SafetyCheck> no_fall_in(std::span<const Climbed> climbs) {
  std::vector<walk::ActionSummary> summaries;
  for (const Climbed& climb : climbs) summaries.push_back(climb.summary);
  return no_fall(summaries, "trials");
}

Verdict judge_arrival(std::span<const Climbed> climbs) {
  const double margin =
      statistics::least(each(climbs, [](const Climbed& c) { return c.summary.margin_min; }));
  return {.claim =
              "From four starting positions the robot climbs a step of 12 cm by footholds in "
              "the map, pushed on its base on the way",
          .safety = no_fall_in(climbs),
          .checks = {{{"trials whose action succeeds",
                       share_of(climbs, [](const Climbed& c) { return c.summary.ok(); })},
                      exactly(100.0)},
                     {{"tilt, most", "°",
                       degrees(worst(climbs, [](const Climbed& c) { return c.summary.tilt_max; }))},
                      at_most(30.0)}},
          .remark = fmt::format(
              "within {:.1f} s; the centre of mass at worst {:.1f} cm {} the feet that touch",
              worst(climbs, [](const Climbed& c) { return c.summary.seconds; }),
              100.0 * std::abs(margin), margin < 0.0 ? "outside" : "inside")};
}

Verdict judge_precision(std::span<const Climbed> climbs) {
  std::vector<double> errors, touchdowns;
  for (const Climbed& c : climbs) {
    errors.insert(errors.end(), c.swing_errors.begin(), c.swing_errors.end());
    for (const Touchdown& t : c.touchdowns) touchdowns.push_back(t.error());
  }
  const auto of = [](const char* name, const std::vector<double>& values, double share) {
    return Measured(name, "mm", 1e3 * percentile(values, share),
                    fmt::format("of {}", values.size()));
  };
  return {.claim =
              "The feet follow their commands with precision, and come to stand on their "
              "footholds",
          .checks = {{of("off the command in the air, median", errors, 0.5), below(5.0)},
                     {of("95th percentile", errors, 0.95), below(10.0)},
                     {of("off the foothold at touchdown, median", touchdowns, 0.5), below(5.0)},
                     {of("95th percentile", touchdowns, 0.95), below(10.0)}},
          .remark = fmt::format("in the air at most {:.1f} mm", 1e3 * percentile(errors, 1.0))};
}

// The foot that is blocked, and what it does next.
Verdict judge_block(const Climbed& climb, LegId leg, const Vector3& p_MF) {
  const auto is_there = [&](const Touchdown& t) { return (t.foothold - p_MF).norm() < 1e-6; };
  const auto end = climb.touchdowns.end();
  const auto blocked = std::find_if(climb.touchdowns.begin(), end, [&](const Touchdown& t) {
    return t.leg == leg && is_there(t);
  });
  const auto next = blocked == end ? end : std::find_if(blocked + 1, end, [&](const Touchdown& t) {
    return t.leg == leg && !is_there(t);
  });
  const double nan = std::nan("");
  return {.claim =
              "A foot whose foothold is blocked stands where it comes to, and the rest goes "
              "on as if nothing had been",
          .safety = no_fall_in({&climb, 1}),
          .checks = {{{"actions that succeed", "", climb.summary.ok()}, exactly(1.0)},
                     {{"beside its foothold", "cm", blocked == end ? nan : 1e2 * blocked->error()},
                      at_least(1.0)},
                     {{"above its foothold", "cm",
                       blocked == end ? nan : 1e2 * (blocked->reached - blocked->foothold).z()},
                      at_least(0.0)},
                     {{"its next one is off its foothold by", "mm",
                       next == end ? nan : 1e3 * next->error()},
                      below(10.0)}}};
}

}  // namespace

std::vector<Verdict> judge_climbs(std::span<const Climbed> climbs, const Climbed& blocked,
                                  LegId blocked_leg, const Vector3& blocked_p_MF) {
  return {judge_arrival(climbs), judge_precision(climbs),
          judge_block(blocked, blocked_leg, blocked_p_MF)};
}

std::vector<Verdict> judge_localised(const LocalisedWalk& combined,
                                     const LocalisedWalk& odometry_only, double way,
                                     double localisation_error) {
  // What may be left of a foot's way in a tick once its velocity is taken off: the ground that
  // stops it, and what that does to odometry.
  constexpr double kSmooth = 1.0;  // [mm]
  const auto walked = [](const char* name, const walk::ActionSummary& s) {
    return Check({name, "", s.ok()}, exactly(1.0));
  };
  const std::vector<SafetyCheck> no_fall = {
      {{"falls", "", combined.summary.fell + odometry_only.summary.fell}, exactly(0.0)}};
  const double c = percentile(combined.last_metre, 0.5),
               o = percentile(odometry_only.last_metre, 0.5);
  return {
      {.claim = "Odometry is smooth and is off by some 5 cm in the end; localisation jumps by "
                "centimetres",
       .safety = no_fall,
       .checks = {walked("walks that succeed", combined.summary),
                  {{"odometry's error at the end", "cm", 1e2 * combined.summary.odometry_position,
                    fmt::format("after {:.1f} m", way)},
                   between(3.0, 7.0)},
                  {{"a foot's jump from one tick to the next, by localisation", "cm",
                    1e2 * combined.localised_jump},
                   above(2.0)}}},
      {.claim = "The combined approach is smooth: no tick moves a commanded foot by more than its "
                "velocity times the period, but for 1 mm where a foot meets the ground",
       .checks = {{{"but for", "mm", 1e3 * combined.commanded_jump}, below(kSmooth)}}},
      {.claim = "And accurate: in the last metre feet stand nearer to their footholds than by "
                "odometry alone, by more than half",
       .checks = {walked("walks by odometry alone that succeed", odometry_only.summary),
                  {{"distance from the foothold in the last metre, median, over odometry's", "",
                    c / o, fmt::format("{:.1f} cm against {:.1f} cm", 1e2 * c, 1e2 * o)},
                   below(0.5)}},
       .remark =
           fmt::format("on the whole walk median {:.1f} cm, p95 {:.1f} cm, where localisation "
                       "itself is off by up to {:.1f} cm",
                       1e2 * percentile(combined.all, 0.5), 1e2 * percentile(combined.all, 0.95),
                       1e2 * localisation_error)}};
}

}  // namespace hexagait::experiments

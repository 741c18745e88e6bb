// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <hexagait/experiments/walk_checks.hpp>
#include <hexagait/pc04/robot_judges.hpp>
#include <hexagait/walk/referee/referee.hpp>
#include <numbers>

namespace hexagait::experiments {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

double p95(const DisplacementWalk& walk) { return 1e3 * walk::percentile(walk.slips, 0.95); }

// The smooth walk of the same heading.
const DisplacementWalk& smooth(const std::vector<DisplacementWalk>& walks,
                               const DisplacementWalk& of) {
  return *std::ranges::find_if(walks, [&](const DisplacementWalk& walk) {
    return walk.heading == of.heading && walk.period == 0.0;
  });
}

// How far it gets: along its path and by turning.
double way(const walk::Summary& s) { return s.distance > 0.1 ? s.distance : std::abs(s.turned); }

double percent_off(const DisplacementWalk& walk, const DisplacementWalk& other) {
  return 100.0 * std::abs(way(walk.summary) / way(other.summary) - 1.0);
}

}  // namespace

std::vector<Verdict> judge_fig11(const RandomHeadings& walk) {
  const walk::Summary& s = walk.summary;
  // A base that is to go back at once the way it came makes v²/(2a) before it rests; the same again
  // if it only then hears of the next command.
  const double most = 1e3 * walk.speed * walk.speed / walk.acceleration;
  return {
      {.claim = "The same controller makes the spider-like robot follow headings at random",
       .safety = no_fall(std::span(&s, 1)),
       .checks = {{{"stuck", "", s.stuck}, exactly(0.0)},
                  {{"distance walked", "lengths of the robot", s.distance / walk.size},
                   at_least(5.0)},
                  {{"off the commanded path, mean", "% of its length",
                    100.0 * s.lateral_mean / walk.size},
                   below(2.0)}}},
      {.claim =
           "It performs very sharp direction changes, as well as smooth ones, without problems",
       .checks = {{{"sharpest change of direction", "°", walk.sharpest * kDegrees}, at_least(90.0)},
                  {{"off the commanded path, most", "mm", 1e3 * s.lateral_max}, below(most)},
                  {{"longest time between two lifts", "steps", walk.longest_pause / walk.step_time},
                   below(3.0)}},
       .remark =
           fmt::format("a base of {:.2f} m/s that may brake by {:.2f} m/s² takes {:.0f} mm to "
                       "rest, and as far again back to its path",
                       walk.speed, walk.acceleration, 0.5 * most)},
      {.claim = "Hardly ever are two neighbouring legs off the ground together",
       .safety = no_fall_and_rule_1({&s, 1}, 1.0, 3.0)}};
}

std::vector<Verdict> judge_fig12(const std::vector<DisplacementWalk>& walks, double period) {
  std::vector<DisplacementWalk> discrete;
  std::ranges::copy_if(walks, std::back_inserter(discrete),
                       [&](const DisplacementWalk& walk) { return walk.period == period; });
  const auto slipped = std::ranges::max_element(discrete, {}, p95);
  const std::string where = slipped == discrete.end() ? "" : slipped->heading;
  const double most = worst(discrete, [](const DisplacementWalk& walk) {
    return 1e3 * walk::percentile(walk.slips, 1.0);
  });
  const auto differ = [&](auto number) {
    return worst(discrete,
                 [&](const DisplacementWalk& walk) { return number(walk, smooth(walks, walk)); });
  };
  return {{.claim = "With discrete displacements at 20 Hz the leg slip is less than 1 cm",
           .safety = no_fall(summaries(walks)),
           .checks = {{{"farthest in a stance, 95 % of the stances, worst heading", "mm",
                        worst(discrete, p95), where},
                       below(10.0)},
                      {{"the same, all stances", "mm", most}, below(10.0)}}},
          {.claim = "The results do not significantly differ from those without",
           .checks = {
               {{"way made, against smooth displacements, worst heading", "%", differ(percent_off)},
                at_most(5.0)},
               {{"off the path, farther than with smooth ones, worst heading", "mm",
                 differ([](const DisplacementWalk& a, const DisplacementWalk& b) {
                   return 1e3 * (a.summary.lateral_max - b.summary.lateral_max);
                 })},
                below(5.0)}}}};
}

}  // namespace hexagait::experiments

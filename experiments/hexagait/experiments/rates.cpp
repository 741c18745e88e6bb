// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// The controller at 1000 to 50 Hz: ten headings on flat ground at each control period, and boxes at
// some. The physics step is at most 2 ms.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <hexagait/experiments/rates.hpp>
#include <hexagait/experiments/walk_checks.hpp>

namespace hexagait::experiments {
namespace {

constexpr double kReferencePeriod = 0.002;  // [s]

std::string in_ms(double period) { return fmt::format("{:g} ms", 1e3 * period); }

void set_period(std::vector<JudgedWalk>& walks, double control_dt) {
  for (JudgedWalk& walk : walks) {
    walk.simulation.control_dt = control_dt;
  }
}

}  // namespace

Verdict judge_rate(std::span<const JudgedWalk> headings, std::span<const JudgedWalk> reference,
                   double reach) {
  const double control_dt = headings.front().simulation.control_dt;
  // Above 10 ms a foot has gone on for up to a centimetre when its contact is noticed.
  const double allowance = control_dt > 0.010 ? 0.010 : 0.0;
  const double share = worst(headings, [&](const JudgedWalk& w) {
    return w.summary.lateral_mean / std::max(w.max_lateral, allowance);
  });
  const double lateral =
      worst(headings, [](const JudgedWalk& w) { return w.summary.lateral_mean; });
  std::vector<double> speeds;  // as shares of the reference's
  for (std::size_t k = 0; k < headings.size() && k < reference.size(); ++k)
    speeds.push_back(outermost_speed(headings[k], reach) / outermost_speed(reference[k], reach));
  Check speed{{fmt::format("share of the speed at {}, slowest heading", in_ms(kReferencePeriod)),
               "%", 100.0 * statistics::least(speeds)},
              at_least(97.0)};
  if (control_dt >= 0.010)
    speed = std::move(speed).expected_to_fail(
        between(93.0, 97.0),
        "contact is known half a period late, and a foot that bounces is sure of it one or two "
        "periods later");
  return {.claim = fmt::format("{} headings on flat ground at a control period of {}",
                               headings.size(), in_ms(control_dt)),
          .safety = no_fall(summaries(headings)),
          .checks = {none_stuck(headings),
                     {{fmt::format("mean distance from the path, share of {} mm (crab 45°: 15 mm)",
                                   allowance > 0.0 ? 10 : 5),
                       "%", 100.0 * share, fmt::format("at worst {:.2f} mm", 1e3 * lateral)},
                      at_most(100.0)},
                     std::move(speed)}};
}

Verdict judge_rate_on_terrain(std::span<const JudgedWalk> walks, int least_arrived) {
  const recording::Simulation& first = walks.front().simulation;
  const auto arrived = share_of(walks, [](const JudgedWalk& w) { return w.summary.arrived; });
  const auto speed = each(walks, [](const JudgedWalk& w) { return w.summary.speed; });
  const auto off = each(walks, [](const JudgedWalk& w) { return w.summary.lateral_mean; });
  const double share = 100.0 * least_arrived / static_cast<double>(walks.size());
  return {
      .claim = fmt::format("{} m of {} at a control period of {}, {} seeds", first.trial.distance,
                           walks.front().group, in_ms(first.control_dt), walks.size()),
      .checks = {{{"walks that arrive", arrived}, at_least(share)}},
      .remark =
          fmt::format("{:.3f} m/s, {:.2f} cm from the path on average",
                      statistics::estimate(speed).mean, 1e2 * statistics::estimate(off).mean)};
}

Outcome rates(const ExperimentContext& context, figures::StagedFiles& files) {
  const bool brief = context.short_form;
  const std::vector<double> periods =
      brief ? std::vector{0.002, 0.020} : std::vector{0.001, 0.002, 0.005, 0.010, 0.020};
  const std::uint64_t seeds = brief ? 1 : 20;
  std::vector<std::vector<JudgedWalk>> groups;  // headings and terrain of each period in turn
  for (const double period : periods) {
    const bool on_terrain = period == kReferencePeriod || period >= 0.010;
    groups.push_back(ten_headings(brief ? 4.0 : 40.0));
    groups.push_back(over_terrain("boxes:0.10", on_terrain ? seeds : 0, brief ? 1.0 : 5.0));
    for (std::size_t k = groups.size() - 2; k < groups.size(); ++k) set_period(groups[k], period);
  }
  if (!walk_all(context, groups)) return {};
  show(*context.robot, groups.back().front().simulation, context);
  files.write("rates.csv", table(groups).text());

  const auto at = std::ranges::find(periods, kReferencePeriod) - periods.begin();
  const std::vector<JudgedWalk>& reference = groups[2 * static_cast<std::size_t>(at)];
  const double reach = farthest_workspace(*context.robot);
  Outcome outcome{.settings = {{"robot", context.robot->name}}};
  for (std::size_t k = 0; k < periods.size(); ++k) {
    const std::vector<JudgedWalk>& headings = groups[2 * k];
    const std::vector<JudgedWalk>& terrain = groups[2 * k + 1];
    outcome.verdicts.push_back(judged_in_full_only(judge_rate(headings, reference, reach), brief));
    if (terrain.empty()) continue;
    // A foot that strikes an edge is noticed up to 20 ms late: one walk in twenty may not arrive.
    const auto all = static_cast<int>(terrain.size());
    const int least = periods[k] > 0.010 ? all - 1 : all;
    outcome.verdicts.push_back(judged_in_full_only(judge_rate_on_terrain(terrain, least), brief));
  }
  return outcome;
}

}  // namespace hexagait::experiments

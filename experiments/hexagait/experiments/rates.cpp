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
    walk.simulation.physics_dt = recording::physics_step_for(control_dt);
  }
}

}  // namespace

Verdict judge_rate(const RatedWalks& walks, std::span<const JudgedWalk> reference, double reach) {
  const auto& headings = walks.headings;
  // Above 10 ms a foot is up to a centimetre on when its contact is noticed.
  const double allowance = walks.control_dt > 0.010 ? 0.010 : 0.0;
  const double share = worst(headings, [&](const JudgedWalk& w) {
    return w.summary.lateral_mean / std::max(w.max_lateral, allowance);
  });
  const double lateral =
      worst(headings, [](const JudgedWalk& w) { return w.summary.lateral_mean; });
  std::vector<double> speeds;  // as shares of the reference's
  for (std::size_t k = 0; k < headings.size() && k < reference.size(); ++k)
    speeds.push_back(outermost_speed(headings[k], reach) / outermost_speed(reference[k], reach));
  return {.claim = fmt::format("{} headings on flat ground at a control period of {}",
                               headings.size(), in_ms(walks.control_dt)),
          .safety = no_fall(summaries(headings)),
          .checks = {
              none_stuck(headings),
              {{fmt::format("mean distance from the path, share of {} mm (crab 45°: 15 mm)",
                            allowance > 0.0 ? 10 : 5),
                "%", 100.0 * share, fmt::format("at worst {:.2f} mm", 1e3 * lateral)},
               at_most(100.0)},
              {{fmt::format("share of the speed at {}, slowest heading", in_ms(kReferencePeriod)),
                "%", 100.0 * statistics::least(speeds)},
               at_least(97.0)}}};
}

Verdict judge_rate_on_terrain(const RatedWalks& walks, int least_arrived) {
  const auto arrived =
      share_of(walks.terrain, [](const JudgedWalk& w) { return w.summary.arrived; });
  const auto speed = each(walks.terrain, [](const JudgedWalk& w) { return w.summary.speed; });
  const auto off = each(walks.terrain, [](const JudgedWalk& w) { return w.summary.lateral_mean; });
  const double share = 100.0 * least_arrived / static_cast<double>(walks.terrain.size());
  return {.claim = fmt::format("{} m of {} at a control period of {}, {} seeds",
                               walks.terrain.front().simulation.trial.distance,
                               walks.terrain.front().group, in_ms(walks.control_dt),
                               walks.terrain.size()),
          .checks = {{{"walks that arrive", arrived}, at_least(share)}},
          .remark =
              fmt::format("{:.3f} m/s, {:.2f} cm from the path on average",
                          statistics::estimate(speed).mean, 1e2 * statistics::estimate(off).mean)};
}

Outcome rates(const ExperimentContext& context, figures::StagedFiles& files) {
  const bool brief = context.short_form;
  const std::vector<double> periods =
      brief ? std::vector{0.002, 0.020} : std::vector{0.001, 0.002, 0.005, 0.010, 0.020};
  const int seeds = brief ? 1 : 20;
  std::vector<RatedWalks> rated;
  std::vector<std::vector<JudgedWalk>> groups;
  for (const double period : periods) {
    groups.push_back(ten_headings(brief ? 4.0 : 40.0));
    groups.push_back({});
    if (period == kReferencePeriod || period >= 0.010)
      groups.back() =
          over_terrain("boxes:0.10", static_cast<std::uint64_t>(seeds), brief ? 0.5 : 5.0);
    for (std::size_t k = groups.size() - 2; k < groups.size(); ++k) set_period(groups[k], period);
  }
  if (!walk_all(context, groups)) return {};
  files.write("rates.csv", table(groups).text());

  for (std::size_t k = 0; k < periods.size(); ++k)
    rated.push_back({periods[k], groups[2 * k], groups[2 * k + 1]});
  const auto reference = std::ranges::find(rated, kReferencePeriod, &RatedWalks::control_dt);
  const double reach = farthest_workspace(*context.robot);
  Outcome outcome{.settings = {{"robot", context.robot->name}}};
  for (const RatedWalks& walks : rated) {
    outcome.verdicts.push_back(
        judged_in_full_only(judge_rate(walks, reference->headings, reach), brief));
    if (walks.terrain.empty()) continue;
    // A foot that strikes an edge is noticed up to 20 ms late: one walk in twenty may not arrive.
    const int least = walks.control_dt > 0.010 ? seeds - 1 : seeds;
    outcome.verdicts.push_back(judged_in_full_only(judge_rate_on_terrain(walks, least), brief));
  }
  return outcome;
}

}  // namespace hexagait::experiments

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// [PC04] Fig. 7-B: mean speed on rough ground from 100 random postures, 500 slices each. Descents
// of 3 … 7 slices, and random ground profiles from flat to far rougher than a foot is raised.
#include <fmt/format.h>

#include <algorithm>
#include <hexagait/figures/csv.hpp>
#include <hexagait/pc04/fig7b.gp.hpp>
#include <hexagait/pc04/pc04.hpp>
#include <hexagait/pc04/slice_comparison.hpp>

namespace hexagait::experiments {
namespace {

enum Gait : std::size_t { kTripod, kFree, kUnadjusted, kWave };

const std::vector<std::string> kGaits = {"tripod", "free", "unadjusted", "wave:0.6"};
const std::vector<std::string> kDescents = {"descent:4-6", "descent:3-7", "descent:2-8",
                                            "descent:1-9"};
constexpr std::array<double, 12> kRoughness = {0, 0.5, 1, 1.5, 2,  3,
                                               4, 6,   8, 12,  20, 40};  // [descent per slice]
constexpr double kRoughest = 12.0;  // of which the claim is judged: beyond, a foot is raised by
                                    // less than half of the highest obstacles

std::string profile(double roughness) { return fmt::format("profile:{}", roughness); }

void write_profiles(figures::StagedFiles& files, const std::vector<SliceComparison>& profiles) {
  figures::Csv csv(
      "gait_number,gait,roughness,mean,half_width_95,ahead,ahead_half_width_95,sweep,"
      "share_of_bound");
  for (std::size_t gait = 0; gait < kGaits.size(); ++gait) {
    for (std::size_t k = 0; k < profiles.size(); ++k) {
      const SliceComparison& c = profiles[k];
      const statistics::Estimate speed = statistics::estimate(c.speeds(gait)),
                                 ahead = c.ahead_of_first(gait);
      csv.row(gait, kGaits[gait], kRoughness[k], speed.mean, speed.half_width, ahead.mean,
              ahead.half_width, c.mean(gait, [](const auto& r) { return r.summary.sweep; }),
              c.mean(gait, [](const auto& r) { return r.summary.fraction_of_bound(); }));
    }
    csv.gap();
  }
  files.write("fig7b-profiles.csv", csv.text());
}

Verdict ahead(const std::vector<SliceComparison>& rough) {
  const SliceComparison* worst = nullptr;
  for (const SliceComparison& c : rough)
    if (worst == nullptr || c.ahead_of_first(kFree).lower() < worst->ahead_of_first(kFree).lower())
      worst = &c;
  return {"On rough ground the free gait is ahead of the tripod controller",
          worst->ahead_of_first(kFree).lower() > 0.0,
          fmt::format("on {} grounds, least on {}: {} units per slice", rough.size(),
                      worst->terrain, spelt(worst->ahead_of_first(kFree))),
          {}};
}

// Below: the 95 % interval of the paired difference lies below 0 (1e-9: rounding).
Verdict never_below(const std::vector<SliceComparison>& all, bool settled) {
  std::string where;
  int below = 0;
  for (const SliceComparison& c : all) {
    const statistics::Estimate e =
        settled ? statistics::paired_difference(c.settled_speeds(kFree), c.settled_speeds(kTripod))
                : c.ahead_of_first(kFree);
    if (e.upper() > -1e-9) continue;
    ++below;
    where += fmt::format("{}{}: {}", where.empty() ? "" : ", ", c.terrain, spelt(e));
  }
  return {settled ? "The same, once the first 20 slices are over" : "On no terrain is it below it",
          below == 0,
          fmt::format("below on {} of {} grounds{}", below, all.size(),
                      where.empty() ? "" : " (" + where + ")"),
          {}};
}

std::vector<Verdict> judge(const std::vector<SliceComparison>& descents,
                           const std::vector<SliceComparison>& profiles) {
  std::vector<SliceComparison> rough = descents, all = descents;
  for (std::size_t k = 0; k < profiles.size(); ++k) {
    all.push_back(profiles[k]);
    // Up to half a slice's descent nobody feels it.
    if (0.5 < kRoughness[k] && kRoughness[k] <= kRoughest) rough.push_back(profiles[k]);
  }
  Verdict strictly = never_below(all, false);
  strictly.why_not =
      "where the ground is flat to the feet both make 50 units every 6 slices, but from a random "
      "posture the free gait takes up to two steps to find the tripod gait that the other begins "
      "with: 0.6 % of 500 slices, and nothing of those that follow";

  const SliceComparison& c = descents[1];
  const double free_stroke =
      statistics::estimate(c.each(kFree, [](const auto& r) { return r.summary.sweep; })).mean;
  const double stroke =
      statistics::estimate(c.each(kTripod, [](const auto& r) { return r.summary.sweep; })).mean;
  const auto share = [&](Gait gait) {
    return statistics::estimate(
               c.each(gait, [](const auto& r) { return r.summary.fraction_of_bound(); }))
        .mean;
  };
  const Verdict longer_strokes{
      "(Ours, not the paper's.) It pays with longer strokes: a leg that waits for a neighbour on "
      "low "
      "ground is carried farther back. A robot whose workspaces end there gains less",
      free_stroke > stroke,
      fmt::format("on {} feet sweep up to {:.0f} units, the tripod controller's {:.0f}; speeds are "
                  "{:.2f} and {:.2f} of what such strokes allow",
                  c.terrain, free_stroke, stroke, share(kFree), share(kTripod))};
  return {ahead(rough), strictly, never_below(all, true), longer_strokes};
}

}  // namespace

Outcome fig7b(const ExperimentContext& context, figures::StagedFiles& files) {
  std::vector<SliceComparison> descents, profiles;
  double done = 0.0;
  const auto compare = [&](const std::string& terrain) {
    if (context.progress)
      context.progress(done++ / static_cast<double>(kDescents.size() + kRoughness.size()));
    return compare_gaits(kGaits, terrain);
  };
  for (const std::string& terrain : kDescents) descents.push_back(compare(terrain));
  for (const double roughness : kRoughness) profiles.push_back(compare(profile(roughness)));
  write_profiles(files, profiles);
  draw_comparison(files,
                  context.figure("fig7b", 1500, 960, "Mean speed on rough ground",
                                 described(descents[1]) + " · after [PC04] Fig. 7-B"),
                  descents[1], {{"terrain_title", "Descents of 3 … 7 slices"}},
                  scripts::pc04::fig7b);

  Outcome outcome{.verdicts = judge(descents, profiles), .settings = settings_of(descents[1])};
  for (const auto* group : {&descents, &profiles})
    for (const SliceComparison& c : *group) {
      const figures::Table table = summary_table(c);
      outcome.table.header = table.header;
      outcome.table.rows.insert(outcome.table.rows.end(), table.rows.begin(), table.rows.end());
      outcome.compute_seconds += c.seconds;
    }
  figures::write_csv(files, "fig7b.csv", outcome.table);
  return outcome;
}

}  // namespace hexagait::experiments

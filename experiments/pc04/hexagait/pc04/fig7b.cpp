// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// [PC04] Fig. 7-B: mean speed on rough ground from 100 random postures, 500 slices each. Descents
// of 3 … 7 slices, and random ground profiles from flat to far rougher than a foot is raised.
#include <fmt/format.h>

#include <algorithm>
#include <hexagait/figures/csv.hpp>
#include <hexagait/pc04/fig7b.gp.hpp>
#include <hexagait/pc04/judges.hpp>
#include <hexagait/pc04/pc04.hpp>

namespace hexagait::experiments {
namespace {

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
              ahead.half_width, c.mean(gait, [](const auto& r) { return r.summary.stroke; }),
              c.mean(gait, [](const auto& r) { return r.summary.fraction_of_bound(); }));
    }
    csv.gap();
  }
  files.write("fig7b-profiles.csv", csv.text());
}

// The grounds of the claim that it is ahead, and all grounds.
std::vector<Verdict> judge(const std::vector<SliceComparison>& descents,
                           const std::vector<SliceComparison>& profiles) {
  std::vector<SliceComparison> rough = descents, all = descents;
  for (std::size_t k = 0; k < profiles.size(); ++k) {
    all.push_back(profiles[k]);
    // Up to half a slice's descent nobody feels it.
    if (0.5 < kRoughness[k] && kRoughness[k] <= kRoughest) rough.push_back(profiles[k]);
  }
  return judge_fig7b(rough, all, descents[1]);
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

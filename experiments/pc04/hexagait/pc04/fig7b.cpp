// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// [PC04] Fig. 7-B: mean speed on rough ground from 100 random postures, 500 slices each. Descents
// of 3 … 7 slices, and random ground profiles from flat to far rougher than a foot is raised.
#include <fmt/format.h>

#include <hexagait/pc04/fig7b.gp.hpp>
#include <hexagait/pc04/judges.hpp>
#include <hexagait/pc04/pc04.hpp>
#include <iterator>

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
  figures::write_tables(files, "fig7b", {{"profiles", csv}});
}

}  // namespace

Outcome fig7b(const ExperimentContext& context, figures::StagedFiles& files) {
  std::vector<SliceComparison> all;  // the descents, then the profiles
  std::vector<std::string> terrains = kDescents;
  for (const double roughness : kRoughness) terrains.push_back(profile(roughness));
  for (const std::string& terrain : terrains) {
    context.tell(all.size(), terrains.size());
    all.push_back(compare_gaits(kGaits, terrain));
  }
  const std::vector<SliceComparison> profiles(all.begin() + std::ssize(kDescents), all.end());
  const SliceComparison& shown = all[1];
  write_profiles(files, profiles);
  draw_comparison(files,
                  context.figure("fig7b", 1500, 960, "Mean speed on rough ground",
                                 described(shown) + " · after [PC04] Fig. 7-B"),
                  shown, {{"terrain_title", "Descents of 3 … 7 slices"}}, scripts::pc04::fig7b);

  // The grounds of the claim that it is ahead: up to half a slice's descent nobody feels it.
  std::vector<SliceComparison> rough(all.begin(), all.begin() + std::ssize(kDescents));
  for (std::size_t k = 0; k < profiles.size(); ++k)
    if (0.5 < kRoughness[k] && kRoughness[k] <= kRoughest) rough.push_back(profiles[k]);
  Outcome outcome{.verdicts = judge_fig7b(rough, all, shown),
                  .settings = settings_of(shown),
                  .table = summary_table(all)};
  for (const SliceComparison& c : all) outcome.compute_seconds += c.seconds;
  files.write("fig7b.csv", outcome.table.text());
  return outcome;
}

}  // namespace hexagait::experiments

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// [PC04] Fig. 6: the advance per time slice in the first steps, with the tripod gait (A), the free
// gait (B), and the free gait without CCN adjustment from a start with CCN = 2 (C).
#include <fmt/format.h>

#include <hexagait/figures/csv.hpp>
#include <hexagait/pc04/fig6.gp.hpp>
#include <hexagait/pc04/judges.hpp>
#include <hexagait/pc04/pc04.hpp>
#include <hexagait/sim2d/slice_model.hpp>

namespace hexagait::experiments {
namespace {

constexpr int kFirstSlices = 72;  // slices
constexpr std::uint64_t kSeed = 1;
constexpr std::array<const char*, 3> kGenerators = {"tripod", "free", "unadjusted"};

sim2d::SliceConfig config_of(const std::string& gait) {
  return {.gait = gait_state::parse_gait_choice(gait).value(), .slices = kFirstSlices};
}

// The first trial that starts with CCN = 2; all three generators start from it.
std::uint32_t trial_with_ccn_2() {
  for (std::uint32_t trial = 0;; ++trial) {
    sim2d::SliceRobot robot(config_of("unadjusted"), {kSeed, trial});
    if (robot.advance().gait.state.ccn() == 2) return trial;
  }
}

FirstSteps walk(const std::string& gait, std::uint32_t trial) {
  FirstSteps walk;
  sim2d::run_slices(config_of(gait), {kSeed, trial},
                    [&](const sim2d::SliceRecord& record, const sim2d::SliceRobot&) {
                      walk.advance.push_back(record.advance);
                      walk.most_lifts = std::max(walk.most_lifts, record.airborne.size());
                    });
  for (int slice = kFirstSlices / 2; slice < kFirstSlices; ++slice)
    walk.mean += walk.advance[static_cast<std::size_t>(slice)] / (0.5 * kFirstSlices);
  return walk;
}

}  // namespace

Outcome fig6(const ExperimentContext& context, figures::StagedFiles& files) {
  const std::uint32_t trial = trial_with_ccn_2();
  std::array<FirstSteps, 3> walks;
  for (std::size_t k = 0; k < kGenerators.size(); ++k) walks[k] = walk(kGenerators[k], trial);

  figures::Csv csv("slice,tripod,free,unadjusted");
  for (std::size_t slice = 0; slice < kFirstSlices; ++slice)
    csv.row(slice, walks[0].advance[slice], walks[1].advance[slice], walks[2].advance[slice]);
  files.write("fig6.csv", csv.text());
  figures::draw_figure(
      files,
      context.figure("fig6", 1200, 800, "Advance per time slice in the first steps",
                     "the same start, with CCN = 2 · units per slice · dashed: mean of the second "
                     "half · after [PC04] Fig. 6"),
      {{"titles", std::vector<std::string>{"A Tripod gait, waiting for all legs", "B Free gait",
                                           "C Free gait without CCN adjustment"}},
       {"means", std::vector<double>{walks[0].mean, walks[1].mean, walks[2].mean}}},
      scripts::pc04::fig6);
  return {.verdicts = judge_fig6(walks),
          .settings = {{"seed", std::to_string(kSeed)},
                       {"trial", std::to_string(trial)},
                       {"slices", std::to_string(kFirstSlices)},
                       {"terrain", "flat"}}};
}

}  // namespace hexagait::experiments

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// [PC04] Fig. 7-A: mean speed on flat ground from 100 random postures, 500 slices each, of the
// tripod controller, the free gait, and the free gait without CCN adjustment; and beside them the
// adjustment to the letter of section 3.3, and slower wave gaits.
#include <hexagait/pc04/fig7a.gp.hpp>
#include <hexagait/pc04/judges.hpp>
#include <hexagait/pc04/pc04.hpp>

namespace hexagait::experiments {
Outcome fig7a(const ExperimentContext& context, figures::StagedFiles& files) {
  const SliceComparison c = compare_gaits(
      {"tripod", "free", "unadjusted", "literal", "wave:0.75", "wave:0.8333333333333334"}, "flat");
  draw_comparison(files,
                  context.figure("fig7a", 1400, 620, "Mean speed on flat ground",
                                 described(c) + " · after [PC04] Fig. 7-A"),
                  c, {{"slices", kSlices}}, scripts::pc04::fig7a);
  const figures::Csv table = summary_table({c});
  files.write("fig7a.csv", table.text());
  return {.verdicts = judge_fig7a(c),
          .settings = settings_of(c),
          .table = table,
          .compute_seconds = c.seconds};
}

}  // namespace hexagait::experiments

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// [PC04] Fig. 7-A: mean speed on flat ground from 100 random postures, 500 slices each, of the
// tripod controller, the free gait, and the free gait without CCN adjustment; and beside them the
// adjustment to the letter of section 3.3, and slower wave gaits.
#include <fmt/format.h>

#include <algorithm>
#include <hexagait/figures/gnuplot.hpp>
#include <hexagait/pc04/judges.hpp>
#include <hexagait/pc04/pc04.hpp>

namespace hexagait::experiments {
namespace {

constexpr const char* kScript = R"(
set multiplot
lift = 1.75; lead_format = "%+.3f ± %.3f"
set label 1 headline at screen 0.02, 0.945 left noenhanced font sized("", 15) textcolor rgb ink
set label 2 subtitle at screen 0.02, 0.88 left noenhanced font sized("", 10.5) textcolor rgb grey
set tmargin at screen 0.76; set bmargin at screen 0.14
set lmargin at screen 0.19; set rmargin at screen 0.60
set label 3 "{/:Bold a}   Mean speed over 500 slices, per start [units per slice]" \
    at graph 0, graph 1 offset 0, 0.8 left textcolor rgb ink
set xrange [0:9]; set xtics 1
plot @speeds
unset label 1; unset label 2
set lmargin at screen 0.655; set rmargin at screen 0.98
set label 3 "{/:Bold b}   Ahead of the tripod controller, in pairs"
unset ytics
set xrange [-7.4:0.9]; set xtics 1
set arrow 1 from 0, graph 0 to 0, graph 1 nohead lc rgb grey lw 1 dt 2
plot @leads
unset multiplot
)";

void draw(figures::StagedFiles& files, const SliceComparison& c) {
  write_comparison(files, "fig7a", c);
  std::ofstream script = files.create("fig7a.gp");
  script
      << figures::figure_preamble("fig7a.svg", 1400, 620)
      << "headline = 'Flat ground: the free gait is as fast as the tripod gait, if its adjustment "
         "is remembered'\n"
      << "subtitle = '100 random starts × 500 slices · dots: starts · diamonds: means with 95 % "
         "confidence intervals · after [PC04] Fig. 7-A'\n"
      << comparison_script("fig7a", c) << kScript;
  script.close();
  figures::draw_figure(files, "fig7a");
}

}  // namespace

Outcome fig7a(const ExperimentContext&, figures::StagedFiles& files) {
  const SliceComparison c = compare_gaits(
      {"tripod", "free", "unadjusted", "literal", "wave:0.75", "wave:0.8333333333333334"}, "flat");
  draw(files, c);
  const figures::Table table = summary_table(c);
  figures::write_csv(files, "fig7a.csv", table);
  return {.verdicts = judge_fig7a(c),
          .settings = settings_of(c),
          .table = table,
          .compute_seconds = c.seconds};
}

}  // namespace hexagait::experiments

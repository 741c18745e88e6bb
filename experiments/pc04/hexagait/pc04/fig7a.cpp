// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// [PC04] Fig. 7-A: mean speed on flat ground from 100 random postures, 500 slices each, of the
// tripod controller, the free gait, and the free gait without CCN adjustment; and beside them the
// adjustment to the letter of section 3.3, and slower wave gaits.
#include <fmt/format.h>

#include <algorithm>
#include <hexagait/figures/gnuplot.hpp>
#include <hexagait/pc04/pc04.hpp>
#include <hexagait/pc04/slice_comparison.hpp>

namespace hexagait::experiments {
namespace {

enum Gait : std::size_t { kTripod, kFree, kUnadjusted, kLiteral };

constexpr double kLevel = 0.99;  // of the tripod's speed: "the same level"

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

// Share of the tripod's mean speed, and whether it is 99 % with 95 % confidence.
Verdict at_level(const SliceComparison& c, Gait gait, const std::string& claim) {
  std::vector<double> needed = c.speeds(kTripod);
  for (double& speed : needed) speed *= kLevel;
  const statistics::Estimate margin = statistics::paired_difference(c.speeds(gait), needed);
  const statistics::Estimate speed = statistics::estimate(c.speeds(gait)),
                             tripod = statistics::estimate(c.speeds(kTripod));
  return {
      claim,
      margin.lower() >= 0.0,
      fmt::format("{} against {} units per slice: {:.1f} %, difference {}", spelt(speed),
                  spelt(tripod), 100.0 * speed.mean / tripod.mean, spelt(c.ahead_of_first(gait))),
      {}};
}

std::vector<Verdict> judge(const SliceComparison& c) {
  Verdict literal =
      at_level(c, kLiteral, "So it does with the mechanism to the letter of section 3.3");
  literal.why_not =
      "relations found anew in every slice forget the adjustment, which moves no pair < > and so "
      "changes nobody's turn: slice for slice it walks as without adjustment. The free gait here "
      "remembers adjusted relations (docs/theory.md 1, the latch)";

  const Verdict unadjusted = at_level(c, kUnadjusted, "");
  const statistics::Estimate settled =
      statistics::paired_difference(c.settled_speeds(kFree), c.settled_speeds(kTripod));
  const auto hashes = [&](Gait gait) {
    std::vector<std::uint64_t> all;
    for (const auto& run : c.runs[gait]) all.push_back(run.summary.hash);
    return all;
  };
  const bool same_walk = hashes(kLiteral) == hashes(kUnadjusted);
  literal.numbers += same_walk ? "; the same 100 walks, bit for bit, as without adjustment"
                               : "; not the same walks as without adjustment";
  return {at_level(c, kFree, "On flat ground the free gait performs at the tripod's level (99 %)"),
          {"Only if the CCN is adjusted", !unadjusted.holds,
           "without adjustment " + unadjusted.numbers},
          {"After the start transient it is the tripod gait",
           std::abs(settled.mean) + settled.half_width < 1e-9,
           fmt::format("difference after {} slices: {}, in every one of {} starts",
                       SliceComparison::kTransient, spelt(settled), SliceComparison::kTrials)},
          literal};
}

}  // namespace

Outcome fig7a(const ExperimentContext&, figures::StagedFiles& files) {
  const SliceComparison c = compare_gaits(
      {"tripod", "free", "unadjusted", "literal", "wave:0.75", "wave:0.8333333333333334"}, "flat");
  draw(files, c);
  const figures::Table table = summary_table(c);
  figures::write_csv(files, "fig7a.csv", table);
  return {.verdicts = judge(c),
          .settings = settings_of(c),
          .table = table,
          .compute_seconds = c.seconds};
}

}  // namespace hexagait::experiments

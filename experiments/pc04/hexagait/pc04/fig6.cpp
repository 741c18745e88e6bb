// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// [PC04] Fig. 6: the advance per time slice in the first steps, with the tripod gait (A), the free
// gait (B), and the free gait without CCN adjustment from a start with CCN = 2 (C).
#include <fmt/format.h>
#include <fmt/ostream.h>

#include <hexagait/figures/gnuplot.hpp>
#include <hexagait/pc04/judges.hpp>
#include <hexagait/pc04/pc04.hpp>
#include <hexagait/sim2d/slice_model.hpp>

namespace hexagait::experiments {
namespace {

constexpr int kShown = 72;  // slices
constexpr std::uint64_t kSeed = 1;
constexpr std::array<const char*, 3> kGaits = {"tripod", "free", "unadjusted"};

sim2d::SliceConfig config_of(const std::string& gait) {
  return {.gait = gait_state::parse_gait_choice(gait).value(), .slices = kShown};
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
  for (int slice = kShown / 2; slice < kShown; ++slice)
    walk.mean += walk.advance[static_cast<std::size_t>(slice)] / (0.5 * kShown);
  return walk;
}

constexpr const char* kScript = R"(
set multiplot
set label 1 headline at screen 0.06, 0.955 left noenhanced font sized("", 15) textcolor rgb ink
set label 2 subtitle at screen 0.06, 0.905 left noenhanced font sized("", 10.5) textcolor rgb grey
set xrange [-0.7:71.7]; set yrange [-12:58]
set xtics 6; set ytics 25
set style fill solid 1 noborder
set boxwidth 0.7
unset key
do for [p=1:3] {
  top = 0.83 - 0.27*(p-1)
  set lmargin at screen 0.06; set rmargin at screen 0.985
  set tmargin at screen top; set bmargin at screen top - 0.2
  set label 3 word(names, p) at graph 0, graph 1 offset 0, 0.8 left textcolor rgb ink \
      font sized("", 11)
  set label 4 sprintf("mean %.2f", means[p]) at graph 0.998, first means[p] offset 0, 0.7 right \
      textcolor rgb accent font sized(":Bold", 9.5) front
  if (p == 3) { set xlabel "time [slices]" offset 0, 0.4 }
  plot "fig6.csv" using 1:p+1 with boxes lc rgb left_side, \
       means[p] with lines dt 2 lw 1.6 lc rgb accent
  unset label 1; unset label 2
}
unset multiplot
)";

void draw(figures::StagedFiles& files, const std::array<FirstSteps, 3>& walks) {
  std::ofstream script = files.create("fig6.gp");
  script
      << figures::figure_preamble("fig6.svg", 1200, 800)
      << "headline = 'Advance per time slice in the first steps'\n"
      << "subtitle = 'the same start, with CCN = 2 · units per slice · dashed: mean of the second "
         "half · after [PC04] Fig. 6'\n"
      << "names = '\"A   Tripod gait, waiting for all legs\" \"B   Free gait\" \"C   Free gait "
         "without CCN adjustment\"'\n"
      << fmt::format("array means[3] = [{:.6f}, {:.6f}, {:.6f}]\n", walks[0].mean, walks[1].mean,
                     walks[2].mean)
      << kScript;
  script.close();
  figures::draw_figure(files, "fig6");
}

}  // namespace

Outcome fig6(const ExperimentContext&, figures::StagedFiles& files) {
  const std::uint32_t trial = trial_with_ccn_2();
  std::array<FirstSteps, 3> walks;
  for (std::size_t k = 0; k < kGaits.size(); ++k) walks[k] = walk(kGaits[k], trial);

  std::ofstream csv = files.create("fig6.csv");
  csv << "slice,tripod,free,unadjusted\n";
  for (std::size_t slice = 0; slice < kShown; ++slice)
    fmt::print(csv, "{},{},{},{}\n", slice, walks[0].advance[slice], walks[1].advance[slice],
               walks[2].advance[slice]);
  csv.close();
  draw(files, walks);
  return {.verdicts = judge_fig6(walks),
          .settings = {{"seed", std::to_string(kSeed)},
                       {"trial", std::to_string(trial)},
                       {"slices", std::to_string(kShown)},
                       {"terrain", "flat"}}};
}

}  // namespace hexagait::experiments

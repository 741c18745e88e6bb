// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// [PC04] Fig. 7-B: mean speed on rough ground from 100 random postures, 500 slices each. Descents
// of 3 … 7 slices, and random ground profiles from flat to far rougher than a foot is raised.
#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <hexagait/figures/gnuplot.hpp>
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

constexpr const char* kScript = R"(
set multiplot
lift = 1.6; lead_format = "%+.2f ± %.2f"
small = sized("", 9)
set label 1 headline at screen 0.02, 0.965 left noenhanced font sized("", 15) textcolor rgb ink
set label 2 subtitle at screen 0.02, 0.925 left noenhanced font sized("", 10.5) textcolor rgb grey
set tmargin at screen 0.85; set bmargin at screen 0.555
set lmargin at screen 0.165; set rmargin at screen 0.56
set label 3 "{/:Bold a}   Descents of 3 … 7 slices: mean speed, per start [units per slice]" \
    at graph 0, graph 1 offset 0, 0.8 left textcolor rgb ink
set xrange [0:9]; set xtics 1
plot @speeds
unset label 1; unset label 2
set lmargin at screen 0.625; set rmargin at screen 0.98
set label 3 "{/:Bold b}   Ahead of the tripod controller, in pairs"
unset ytics
set xrange [-7:2]; set xtics 1
set arrow 1 from 0, graph 0 to 0, graph 1 nohead lc rgb grey lw 1 dt 2
plot @leads
unset arrow 1
set ytics nomirror scale 0.5 textcolor rgb ink autofreq; set grid ytics
set tmargin at screen 0.42; set bmargin at screen 0.09

# x: roughness, on a scale that shows 0 and 40
squeezed(r) = r**0.5
dash(k) = k == 3 ? 3 : k == 2 ? 2 : 1
set xtics ("0" 0, "½" squeezed(0.5), "1" 1, "2" squeezed(2), "4" 2, "8" squeezed(8), "12" squeezed(12), "20" squeezed(20), "40" squeezed(40))
set xrange [0:squeezed(40)]
set xlabel "roughness [descent per slice]" offset 0, 0.4
set lmargin at screen 0.045; set rmargin at screen 0.33
set label 3 "{/:Bold c}   Ground profiles, feet raised by 5: speed"
set yrange [0:9]
set key at graph 0.98, graph 0.97 right top reverse Left samplen 1.5 font small
plot for [k=0:3] "fig7b-profiles.csv" using (squeezed($3)):($1 == k ? $4-$5 : NaN):($1 == k ? $4+$5 : NaN) \
         with filledcurves fs transparent solid 0.25 lc rgb gait_colour(k) notitle, \
     for [k=0:3] "fig7b-profiles.csv" using ($1 == k ? squeezed($3) : NaN):4 with linespoints pt 7 ps 0.5 \
         lw 1.8 dt dash(k) lc rgb gait_colour(k) title word(titles, k+1)
set lmargin at screen 0.385; set rmargin at screen 0.66
set label 3 "{/:Bold d}   Free gait ahead of the tripod"
set yrange [-0.2:0.8]; set ytics 0.2
unset key
plot "fig7b-profiles.csv" using (squeezed($3)):($1 == 1 ? $6-$7 : NaN):($1 == 1 ? $6+$7 : NaN) \
         with filledcurves fs transparent solid 0.25 lc rgb gait_colour(1), \
     "fig7b-profiles.csv" using ($1 == 1 ? squeezed($3) : NaN):6 with linespoints pt 7 ps 0.5 lw 1.8 \
         lc rgb gait_colour(1), \
     0 with lines dt 2 lw 1 lc rgb grey
set lmargin at screen 0.71; set rmargin at screen 0.98
set label 3 "{/:Bold e}   Longest stroke that it needs [units]"
set yrange [0:100]; set ytics 25
plot for [k=0:3] "fig7b-profiles.csv" using ($1 == k ? squeezed($3) : NaN):8 with linespoints pt 7 ps 0.5 \
         lw 1.8 dt dash(k) lc rgb gait_colour(k)
unset multiplot
)";

void write_profiles(figures::StagedFiles& files, const std::vector<SliceComparison>& profiles) {
  std::ofstream csv = files.create("fig7b-profiles.csv");
  csv << "gait_number,gait,roughness,mean,half_width_95,ahead,ahead_half_width_95,sweep,"
         "share_of_bound\n";
  for (std::size_t gait = 0; gait < kGaits.size(); ++gait) {
    for (std::size_t k = 0; k < profiles.size(); ++k) {
      const SliceComparison& c = profiles[k];
      const statistics::Estimate speed = statistics::estimate(c.speeds(gait)),
                                 ahead = c.ahead_of_first(gait);
      fmt::print(
          csv, "{},{},{},{},{},{},{},{},{}\n", gait, kGaits[gait], kRoughness[k], speed.mean,
          speed.half_width, ahead.mean, ahead.half_width,
          statistics::estimate(c.each(gait, [](const auto& r) { return r.summary.sweep; })).mean,
          statistics::estimate(c.each(gait, [](const auto& r) {
            return r.summary.fraction_of_bound();
          })).mean);
    }
    csv << '\n';
  }
}

void draw(figures::StagedFiles& files, const SliceComparison& descents,
          const std::vector<SliceComparison>& profiles) {
  write_comparison(files, "fig7b", descents);
  write_profiles(files, profiles);
  std::string titles;
  for (const std::string& gait : kGaits) titles += fmt::format("\"{}\" ", title_of(gait));
  std::ofstream script = files.create("fig7b.gp");
  script
      << figures::figure_preamble("fig7b.svg", 1500, 960)
      << "headline = 'Rough ground: the free gait is ahead of the tripod controller, with longer "
         "strokes'\n"
      << "subtitle = '100 random starts × 500 slices · the same ground for every gait · bands and "
         "bars: 95 % confidence intervals · after [PC04] Fig. 7-B'\n"
      << "titles = " << figures::quoted(titles) << '\n'
      << comparison_script("fig7b", descents) << kScript;
  script.close();
  figures::draw_figure(files, "fig7b");
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
  draw(files, descents[1], profiles);

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

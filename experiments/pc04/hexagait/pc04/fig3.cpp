// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// [PC04] Fig. 3: the slow wave gait (β = 5/6) as a gait diagram with the types of its gait states,
// and the rest of the family of wave gaits, of which section 3.2 tells in words.
#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <hexagait/figures/gnuplot.hpp>
#include <hexagait/pc04/judges.hpp>
#include <hexagait/pc04/pc04.hpp>
#include <hexagait/sim2d/slice_model.hpp>

namespace hexagait::experiments {
namespace {

constexpr int kShown = 72;      // slices: two periods of the slow wave
constexpr int kSettling = 720;  // slices before: the gait has long settled

std::vector<WaveGait> family() {
  return {{"5/6", "wave:0.8333333333333334", "ABC"},
          {"3/4", "wave:0.75", "BC"},
          {"2/3", "wave:0.6666666666666667", "BCD"},
          {"1/2", "wave:0.5", "D"}};
}

// Paper's numbers of legs, "1+6".
std::string numbers(LegSet legs) {
  std::string text;
  for (LegId leg = 0; leg < 6; ++leg)
    if (legs.contains(leg)) text += fmt::format("{}{}", text.empty() ? "" : "+", leg + 1);
  return text;
}

// "BCBCBC" is "BC" again and again, from any of its letters; the shortest, first in the alphabet.
std::string period_of(const std::string& types) {
  for (std::size_t length = 1; 2 * length <= types.size(); ++length) {
    bool repeats = true;
    for (std::size_t k = length; k < types.size(); ++k) repeats &= types[k] == types[k - length];
    if (!repeats) continue;
    std::string text = types.substr(0, length), first = text;
    for (std::size_t turn = 0; turn < length; ++turn) {
      std::rotate(text.begin(), text.begin() + 1, text.end());
      first = std::min(first, text);
    }
    return first;
  }
  return types;
}

// A settled robot that is about to lift leg 6, at the right rear: a wave begins with it.
sim2d::SliceRobot settled_robot(const WaveGait& gait) {
  sim2d::SliceRobot robot({.gait = gait_state::parse_gait_choice(gait.spelling).value()}, {1, 0});
  for (int slice = 0;; ++slice) {
    const sim2d::SliceRobot before = robot;
    if (robot.advance().lifted.contains(5) && slice >= kSettling) return before;
  }
}

// Rows "panel,from,to,…" of the times in which value(record) stays the same; rows without are left
// out.
template <class Value>
void write_spans(std::ostream& out, std::size_t panel, const std::vector<sim2d::SliceRecord>& walk,
                 const Value& value) {
  for (std::size_t from = 0, to = 0; from < walk.size(); from = to) {
    const std::string row = value(walk[from]);
    while (to < walk.size() && value(walk[to]) == row) ++to;
    if (!row.empty()) fmt::print(out, "{},{},{},{}\n", panel, from, to, row);
  }
}

void walk(WaveGait& gait, std::size_t panel, std::ostream& steps, std::ostream& states) {
  sim2d::SliceRobot robot = settled_robot(gait);
  std::vector<sim2d::SliceRecord> records;
  std::string types;
  for (int slice = 0; slice < kShown; ++slice) {
    const sim2d::SliceRecord& record = records.emplace_back(robot.advance());
    ++gait.slices;
    gait.slices_not_ccn_3 += record.gait.state.ccn() == 3 ? 0 : 1;
    if (record.lifted.empty()) continue;
    types += letter_of(type_of(record.gait.state));
    if (slice < kShown / 2)
      gait.lifts += fmt::format("{}{}", gait.lifts.empty() ? "" : " · ", numbers(record.lifted));
  }
  gait.found = period_of(types);

  for (LegId leg = 0; leg < 6; ++leg)
    write_spans(steps, panel, records, [&](const sim2d::SliceRecord& record) {
      return record.airborne.contains(leg) ? std::to_string(leg + 1) : std::string();
    });
  write_spans(states, panel, records, [](const sim2d::SliceRecord& record) {
    const auto type = type_of(record.gait.state);
    return fmt::format("{},{},{}", to_string(record.gait.state), letter_of(type),
                       static_cast<int>(type));
  });
}

constexpr const char* kScript = R"(
set multiplot
state_font = sized(":Bold", 9)
set label 1 headline at screen 0.05, 0.955 left noenhanced font sized("", 15) textcolor rgb ink
set label 2 subtitle at screen 0.05, 0.905 left noenhanced font sized("", 10.5) textcolor rgb grey
unset key
set xrange [0:72]; set yrange [7.75:0.4]
set xtics 12
set grid noytics
set style fill solid 1 noborder
row(leg) = leg == 2 ? 1 : leg == 4 ? 2 : leg == 6 ? 3 : leg == 1 ? 4 : leg == 3 ? 5 : 6
set ytics ("2" 1, "4" 2, "6" 3, "1" 4, "3" 5, "5" 6, "state" 7.2) scale 0
do for [p=0:3] {
  left = 0.05 + 0.49*(p % 2); top = 0.82 - 0.415*(p/2)
  set lmargin at screen left; set rmargin at screen left + 0.435
  set tmargin at screen top; set bmargin at screen top - 0.30
  set label 3 word(betas, p+1) at graph 0, graph 1 offset 0, 0.9 left textcolor rgb ink \
      font sized(":Bold", 11)
  set label 4 word(lifts, p+1) at graph 1, graph 1 offset 0, 0.9 right textcolor rgb grey \
      font sized("", 9.5)
  if (p > 1) { set xlabel "time [slices]" offset 0, 0.4 } else { unset xlabel }
  plot "fig3-steps.csv" using ($1 == p && int($4) % 2 == 1 ? $2 : NaN):(row($4)):2:3:(row($4)-0.34):(row($4)+0.34) \
           with boxxyerror lc rgb left_side, \
       "fig3-steps.csv" using ($1 == p && int($4) % 2 == 0 ? $2 : NaN):(row($4)):2:3:(row($4)-0.34):(row($4)+0.34) \
           with boxxyerror lc rgb right_side, \
       "fig3-states.csv" using ($1 == p ? $2 : NaN):(7):2:3:(6.85):(7.55):(type_shade($6)) \
           with boxxyerror lc rgb variable, \
       "fig3-states.csv" using ($1 == p ? 0.5*($2+$3) : NaN):(7.2):5:($6 == 4 ? 0xffffff : 0x1d2b36) \
           with labels font state_font textcolor rgb variable
  unset label 1; unset label 2
}
unset multiplot
)";

void draw(figures::StagedFiles& files, const std::vector<WaveGait>& gaits) {
  std::string betas, lifts;
  for (const WaveGait& gait : gaits) {
    betas += fmt::format("\"β = {}\" ", gait.label);
    lifts += fmt::format("\"legs {}\" ", gait.lifts);
  }
  std::ofstream script = files.create("fig3.gp");
  script
      << figures::figure_preamble("fig3.svg", 1300, 780)
      << "headline = 'One family of wave gaits, from the slow wave to the tripod gait'\n"
      << "subtitle = 'bars: the leg is in the air; right legs above, left legs below · last row: "
         "type of the gait state · after [PC04] Fig. 3 and section 3.2'\n"
      << "betas = " << figures::quoted(betas) << "\nlifts = " << figures::quoted(lifts) << '\n'
      << kScript;
  script.close();
  figures::draw_figure(files, "fig3");
}

}  // namespace

Outcome fig3(const ExperimentContext&, figures::StagedFiles& files) {
  std::vector<WaveGait> gaits = family();
  std::ofstream steps = files.create("fig3-steps.csv"), states = files.create("fig3-states.csv");
  steps << "panel,from,to,leg\n";
  states << "panel,from,to,state,type,type_number\n";
  for (std::size_t k = 0; k < gaits.size(); ++k) walk(gaits[k], k, steps, states);
  steps.close();
  states.close();
  draw(files, gaits);

  figures::Table table{{"duty factor", "types", "lifts of half the time shown"}, {}};
  for (const WaveGait& gait : gaits) table.rows.push_back({gait.label, gait.found, gait.lifts});
  return {.verdicts = judge_fig3(gaits),
          .settings = {{"step_time_slices", "6"}, {"seed", "1"}},
          .table = table};
}

}  // namespace hexagait::experiments

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// [PC04] Fig. 3: the slow wave gait (β = 5/6) as a gait diagram with the types of its gait states,
// and the rest of the family of wave gaits, of which section 3.2 tells in words.
#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <hexagait/experiments/experiment.hpp>
#include <hexagait/experiments/gait_tables.hpp>
#include <hexagait/experiments/gnuplot.hpp>
#include <hexagait/sim2d/slice_model.hpp>

namespace hexagait::experiments {
namespace {

constexpr int kShown = 72;      // slices: two periods of the slow wave
constexpr int kSettling = 720;  // slices before: the gait has long settled

struct WaveGait {
  const char* label;      // of β
  const char* spelling;   // as a gait choice
  std::string sequence;   // types of the gait states, as section 3.2 tells them
  std::string found;      // the same, as walked
  bool has_ccn_3 = true;  // in every slice
  std::string lifts;      // per period, in the paper's numbers
};

std::vector<WaveGait> family() {
  return {{"5/6", "wave:0.8333333333333334", "ABC", "", true, ""},
          {"3/4", "wave:0.75", "BC", "", true, ""},
          {"2/3", "wave:0.6666666666666667", "BCD", "", true, ""},
          {"1/2", "wave:0.5", "D", "", true, ""}};
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
      std::ranges::rotate(text, text.begin() + 1);
      first = std::min(first, text);
    }
    return first;
  }
  return types;
}

void walk(WaveGait& gait, std::size_t panel, std::ostream& steps, std::ostream& states) {
  sim2d::SliceRobot robot({.gait = gait_state::parse_gait_choice(gait.spelling).value()}, {1, 0});
  // Until a slice after kSettling in which leg 6, at the right rear, lifts: a wave begins with it.
  sim2d::SliceRecord record;
  for (int slice = 0; slice < kSettling || !record.lifted.contains(5); ++slice) {
    sim2d::SliceRobot before = robot;
    record = robot.advance();
    if (slice >= kSettling && record.lifted.contains(5)) robot = before;
  }

  std::string types;
  for (int slice = 0; slice < kShown; ++slice) {
    record = robot.advance();
    const char type = letter_of(type_of(record.gait.state));
    gait.has_ccn_3 &= record.gait.state.ccn() == 3;
    fmt::print(states, "{},{},{},{},{}\n", panel, slice, to_string(record.gait.state), type,
               type - 'A' + 1);
    for (LegId leg = 0; leg < 6; ++leg)
      if (record.airborne.contains(leg))
        fmt::print(steps, "{},{},{},{:d}\n", panel, slice, leg + 1, record.lifted.contains(leg));
    if (record.lifted.empty()) continue;
    types += type;
    if (slice < kShown / 2)
      gait.lifts += fmt::format("{}{}", gait.lifts.empty() ? "" : " · ", numbers(record.lifted));
  }
  gait.found = period_of(types);
}

constexpr const char* kScript = R"(
set multiplot
set label 1 headline at screen 0.05, 0.955 left noenhanced font sized("", 15) textcolor rgb ink
set label 2 subtitle at screen 0.05, 0.905 left noenhanced font sized("", 10.5) textcolor rgb grey
type_shade(k) = k == 4 ? 0x5d7a8c : k == 3 ? 0x93a9b7 : k == 2 ? 0xbccad4 : 0xdfe6eb
unset key
set xrange [0:72]; set yrange [7.75:0.4]
set ytics ("6" 6, "4" 4, "2" 2, "5" 5, "3" 3, "1" 1, "state" 7.15) scale 0
set xtics 12
set grid noytics
set style fill solid 1 noborder
row(leg) = leg == 2 ? 1 : leg == 4 ? 2 : leg == 6 ? 3 : leg == 1 ? 4 : leg == 3 ? 5 : 6
set ytics ("2" 1, "4" 2, "6" 3, "1" 4, "3" 5, "5" 6, "state" 7.2)
do for [p=0:3] {
  left = 0.05 + 0.49*(p % 2); top = 0.82 - 0.415*(p/2)
  set lmargin at screen left; set rmargin at screen left + 0.435
  set tmargin at screen top; set bmargin at screen top - 0.30
  set label 3 word(betas, p+1) at graph 0, graph 1 offset 0, 0.9 left textcolor rgb ink \
      font sized(":Bold", 11)
  set label 4 word(lifts, p+1) at graph 1, graph 1 offset 0, 0.9 right textcolor rgb grey \
      font sized("", 9.5)
  if (p > 1) { set xlabel "time [slices]" offset 0, 0.4 } else { unset xlabel }
  plot "fig3-steps.csv" using ($1 == p && $3 % 2 == 1 ? $2 : NaN):(row($3)):2:($2+1):(row($3)-0.34):(row($3)+0.34) \
           with boxxyerror lc rgb left_side, \
       "fig3-steps.csv" using ($1 == p && $3 % 2 == 0 ? $2 : NaN):(row($3)):2:($2+1):(row($3)-0.34):(row($3)+0.34) \
           with boxxyerror lc rgb right_side, \
       "fig3-states.csv" using ($1 == p ? $2 : NaN):(7):2:($2+1):(6.85):(7.55):(type_shade($5)) \
           with boxxyerror lc rgb variable, \
       "fig3-states.csv" using ($1 == p && int($2) % 6 == 2 ? $2 + 1 : NaN):(7.2):4 \
           with labels font sized(":Bold", 9) textcolor rgb ink
  unset label 1; unset label 2
}
unset multiplot
)";

void draw(StagedFiles& files, const std::vector<WaveGait>& gaits) {
  std::string betas, lifts;
  for (const WaveGait& gait : gaits) {
    betas += fmt::format("\"β = {}\" ", gait.label);
    lifts += fmt::format("\"legs {}\" ", gait.lifts);
  }
  std::ofstream script = files.create("fig3.gp");
  script
      << figure_preamble("fig3.svg", 1300, 780)
      << "headline = 'One family of wave gaits, from the slow wave to the tripod gait'\n"
      << "subtitle = 'bars: the leg is in the air; right legs above, left legs below · last row: "
         "type of the gait state · after [PC04] Fig. 3 and section 3.2'\n"
      << "betas = " << quoted(betas) << "\nlifts = " << quoted(lifts) << '\n'
      << kScript;
  script.close();
  draw_figure(files, "fig3");
}

}  // namespace

Outcome fig3(const ExperimentContext&, StagedFiles& files) {
  std::vector<WaveGait> gaits = family();
  std::ofstream steps = files.create("fig3-steps.csv"), states = files.create("fig3-states.csv");
  steps << "panel,slice,leg,lifts\n";
  states << "panel,slice,state,type,type_number\n";
  for (std::size_t k = 0; k < gaits.size(); ++k) walk(gaits[k], k, steps, states);
  steps.close();
  states.close();
  draw(files, gaits);

  Outcome outcome{.settings = {{"step_time_slices", "6"}, {"seed", "1"}},
                  .table = {{"duty factor", "types", "lifts of half the time shown"}, {}}};
  bool all_3 = true;
  for (const WaveGait& gait : gaits) {
    all_3 &= gait.has_ccn_3;
    outcome.table.rows.push_back({gait.label, gait.found, gait.lifts});
    outcome.verdicts.push_back(
        {fmt::format("The wave gait of β = {} goes through states of types {}…", gait.label,
                     gait.sequence),
         gait.found == gait.sequence,
         fmt::format("{}… in the slice model; lifts {}", gait.found, gait.lifts)});
  }
  outcome.verdicts.push_back({"All wave gaits have CCN = 3", all_3,
                              "every slice of two periods of each, with the free gait's priorities "
                              "and delayed rear legs"});
  return outcome;
}

}  // namespace hexagait::experiments

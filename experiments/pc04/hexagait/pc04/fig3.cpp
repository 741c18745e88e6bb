// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// [PC04] Fig. 3: the slow wave gait (β = 5/6) as a gait diagram with the types of its gait states,
// and the rest of the family of wave gaits, of which section 3.2 tells in words.
#include <fmt/format.h>

#include <algorithm>
#include <hexagait/figures/csv.hpp>
#include <hexagait/pc04/fig3.gp.hpp>
#include <hexagait/pc04/gait_tables.hpp>
#include <hexagait/pc04/judges.hpp>
#include <hexagait/pc04/pc04.hpp>
#include <hexagait/sim2d/slice_model.hpp>

namespace hexagait::experiments {
namespace {

constexpr int kShownSlices = 72;  // slices: two periods of the slow wave
constexpr int kSettling = 720;    // slices before: the gait has long settled

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
    if (repeats) return least_rotation(types.substr(0, length));
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

// write(from, to, key) of each time in which key(record) stays the same.
template <class Key, class Write>
void for_each_span(const std::vector<sim2d::SliceRecord>& walk, const Key& key,
                   const Write& write) {
  for (std::size_t from = 0, to = 0; from < walk.size(); from = to) {
    const auto of_span = key(walk[from]);
    while (to < walk.size() && key(walk[to]) == of_span) ++to;
    write(from, to, of_span);
  }
}

void walk(WaveGait& gait, std::size_t panel, figures::Csv& steps, figures::Csv& states) {
  sim2d::SliceRobot robot = settled_robot(gait);
  std::vector<sim2d::SliceRecord> records;
  std::string types;
  for (int slice = 0; slice < kShownSlices; ++slice) {
    const sim2d::SliceRecord& record = records.emplace_back(robot.advance());
    ++gait.slices;
    gait.slices_not_ccn_3 += record.gait.state.ccn() == 3 ? 0 : 1;
    if (record.lifted.empty()) continue;
    types += letter_of(type_of(record.gait.state));
    if (slice < kShownSlices / 2)
      gait.lifts += fmt::format("{}{}", gait.lifts.empty() ? "" : " · ", numbers(record.lifted));
  }
  gait.found = period_of(types);

  for (LegId leg = 0; leg < 6; ++leg)
    for_each_span(
        records, [&](const auto& record) { return record.airborne.contains(leg); },
        [&](std::size_t from, std::size_t to, bool in_air) {
          if (in_air) steps.row(panel, from, to, leg + 1);
        });
  for_each_span(
      records, [](const auto& record) { return record.gait.state; },
      [&](std::size_t from, std::size_t to, const gait_state::GaitState& state) {
        const auto type = type_of(state);
        states.row(panel, from, to, to_string(state), letter_of(type), static_cast<int>(type));
      });
}

figures::Variables variables(const std::vector<WaveGait>& gaits) {
  std::vector<std::string> titles, lifts;
  for (const WaveGait& gait : gaits) {
    titles.push_back(fmt::format("β = {}", gait.label));
    lifts.push_back("legs " + gait.lifts);
  }
  return {{"titles", titles}, {"lifts", lifts}};
}

}  // namespace

Outcome fig3(const ExperimentContext& context, figures::StagedFiles& files) {
  std::vector<WaveGait> gaits = family();
  figures::Csv steps("panel,from,to,leg"), states("panel,from,to,state,type,type_number");
  for (std::size_t k = 0; k < gaits.size(); ++k) walk(gaits[k], k, steps, states);
  figures::write_tables(files, "fig3", {{"steps", steps}, {"states", states}});
  figures::draw_figure(
      files,
      context.figure("fig3", 1300, 780, "Wave gaits of four duty factors",
                     "bars: the leg is in the air; right legs above, left legs below · last row: "
                     "type of the gait state · after [PC04] Fig. 3 and section 3.2"),
      variables(gaits), scripts::pc04::fig3);

  figures::Csv table("duty factor,types,lifts of half the time shown");
  for (const WaveGait& gait : gaits) table.row(gait.label, gait.found, gait.lifts);
  return {.verdicts = judge_fig3(gaits),
          .settings = {{"step_time_slices", "6"}, {"seed", "1"}},
          .table = table};
}

}  // namespace hexagait::experiments

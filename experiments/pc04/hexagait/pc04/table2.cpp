// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// [PC04] Table 2: from a state of type B with one leg in the air to the tripod gait, event by
// event. The library decides who steps and what becomes of the gait state; the rows are compared
// with the printed ones.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <hexagait/figures/drawing.hpp>
#include <hexagait/pc04/gait_tables.hpp>
#include <hexagait/pc04/judges.hpp>
#include <hexagait/pc04/pc04.hpp>

namespace hexagait::experiments {
namespace {

using gait_state::GaitState;

constexpr std::size_t kRows = 15;

// The legs by their letters a … f: ring positions 0 … 5 (legs 1, 2, 4, 6, 5, 3 in the paper).
std::string letters(LegSet legs) {
  std::string text;
  for (int k = 0; k < kLegs; ++k)
    if (legs.contains(gait_state::leg_at(k, kLegs)))
      text += fmt::format("{}{:c}", text.empty() ? "" : ", ", 'a' + k);
  return text;
}

Table2Row row(const GaitState& state, LegSet airborne, const std::string& event) {
  std::string ground;
  for (int k = 0; k < kLegs; ++k)
    ground += airborne.contains(gait_state::leg_at(k, kLegs)) ? 'o' : '*';
  return {to_string(state), ground, letter_of(type_of(state)), event};
}

std::string happened(LegSet legs, const char* of_one, const char* of_several) {
  return letters(legs) + (legs.size() == 1 ? of_one : of_several);
}

// "a<b<c>d<e>f>a", and a line of discs below it.
void draw_row(figures::Drawing& drawing, double y, const Table2Row& row, std::size_t number,
              bool agrees) {
  constexpr double kState = 130.0, kPitch = 76.0;
  drawing.text({80.0, y}, std::to_string(number), {.points = 11.0, .colour = figures::kGrey});
  for (int k = 0; k <= kLegs; ++k) {
    const auto i = static_cast<std::size_t>(k % kLegs);
    const double x = kState + kPitch * k;
    const bool stands = row.ground[i] == '*';
    drawing.disc({x, y + 11.0}, 5.0, stands ? figures::kInk : figures::kWhite, figures::kInk);
    drawing.text(
        {x, y - 9.0}, std::string(1, static_cast<char>('a' + k % kLegs)),
        {.points = 11.5, .colour = stands ? figures::kInk : figures::kAccent, .bold = !stands});
    if (k < kLegs)
      drawing.text({x + 0.5 * kPitch, y - 9.0}, std::string(1, row.state[i]),
                   {.points = 11.5, .colour = figures::kGrey, .mono = true});
  }
  drawing.box({655.0, y - 13.0}, {695.0, y + 13.0}, figures::type_shade(row.type));
  drawing.text(
      {675.0, y}, std::string(1, row.type),
      {.points = 11.0, .colour = row.type == 'D' ? figures::kWhite : figures::kInk, .bold = true});
  drawing.text({730.0, y}, row.event, {.points = 11.0, .align = "left"});
  drawing.text({985.0, y}, agrees ? "as printed" : "differs",
               {.points = 9.5, .colour = agrees ? figures::kGrey : figures::kAccent});
}

figures::Drawing drawn(const std::vector<Table2Row>& rows) {
  constexpr double kTop = 135.0, kPitch = 48.0;
  figures::Drawing drawing;
  drawing.text({675.0, kTop - 34.0}, "type", {.points = 9.5, .colour = figures::kGrey});
  drawing.text({730.0, kTop - 34.0}, "event",
               {.points = 9.5, .colour = figures::kGrey, .align = "left"});
  for (std::size_t k = 0; k < rows.size(); ++k)
    draw_row(drawing, kTop + kPitch * static_cast<double>(k), rows[k], k + 1,
             rows[k] == table2_printed()[k]);
  return drawing;
}

}  // namespace

std::vector<Table2Row> table2_rows(int step_time, int remaining) {
  GaitState state = gait_state::parse_gait_state("<<><>>").value();
  std::array<int, kLegs> left{};  // slices in the air, by leg
  LegSet airborne;
  const auto lift = [&](LegId leg, int slices) {
    airborne.insert(leg);
    left[static_cast<std::size_t>(leg)] = slices;
  };
  lift(gait_state::leg_at(kLegs - 1, kLegs), remaining);  // f

  // In a slice first landings, then lifts.
  std::vector<Table2Row> rows = {row(state, airborne, "Initial Gait State")};
  while (rows.size() < kRows) {
    LegSet landed;
    for (LegId leg = 0; leg < kLegs; ++leg)
      if (airborne.contains(leg) && left[static_cast<std::size_t>(leg)]-- == 0) landed.insert(leg);
    for (LegId leg = 0; leg < kLegs; ++leg) {
      if (!landed.contains(leg)) continue;
      airborne.erase(leg);
      // A leg that lifted when it had no priority keeps its relations.
      if (priority_legs(state).contains(leg)) state = after_step(state, leg);
    }
    if (!landed.empty())
      rows.push_back(row(state, airborne, happened(landed, " contacts ground", " contact ground")));

    const LegSet lifted = may_step(state, airborne);
    for (LegId leg = 0; leg < kLegs; ++leg)
      if (lifted.contains(leg)) lift(leg, step_time - 1);
    if (!lifted.empty())
      rows.push_back(row(state, airborne, happened(lifted, " starts a step", " start a step")));
  }
  rows.resize(kRows);
  return rows;
}

const std::vector<Table2Row>& table2_printed() {
  static const std::vector<Table2Row> rows = {
      {"<<><>>", "*****o", 'B', "Initial Gait State"},
      {"<<><>>", "**o**o", 'B', "c starts a step"},
      {"<<><>>", "**o***", 'B', "f contacts ground"},
      {"<<><>>", "**o*o*", 'B', "e starts a step"},
      {"<><<>>", "****o*", 'C', "c contacts ground"},
      {"<><<>>", "*o**o*", 'C', "b starts a step"},
      {"<><><>", "*o****", 'D', "e contacts ground"},
      {"<><><>", "*o*o*o", 'D', "d, f start a step"},
      {"><<><>", "***o*o", 'B', "b contacts ground"},
      {"><><><", "******", 'D', "d, f contact ground"},
      {"><><><", "o*o*o*", 'D', "a, c, e start a step"},
      {"<><><>", "******", 'D', "a, c, e contact ground"},
      {"<><><>", "*o*o*o", 'D', "b, d, f start a step"},
      {"><><><", "******", 'D', "b, d, f contact ground"},
      {"><><><", "o*o*o*", 'D', "a, c, e start a step"},
  };
  return rows;
}

Outcome table2(const ExperimentContext& context, figures::StagedFiles& files) {
  const std::vector<Table2Row> rows = table2_rows(6, 3);
  figures::Csv table("row,state,ground,type,ccn,event,as_printed");
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const bool agrees = rows[k] == table2_printed()[k];
    table.row(k + 1, rows[k].state, rows[k].ground, rows[k].type,
              std::ranges::count(rows[k].state, '<'), rows[k].event, agrees ? "yes" : "no");
  }
  files.write("table2.csv", table.text());
  drawn(rows).draw(
      files, context.figure("table2", 1070, 850, "From a gait state of type B on, event by event",
                            "a … f: the legs along the ring · filled: on the ground · open: in the "
                            "air · after [PC04] Table 2"));
  return {.verdicts = {judge_table2(rows)},
          .settings = {{"state", "<<><>>"}, {"step_time_slices", "6"}, {"remaining_slices", "3"}},
          .table = table};
}

}  // namespace hexagait::experiments

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// [PC04] Table 1: the gait states of six legs, modulo rotations of the ring, by their clockwise
// circularity number and their type. Made by going through all of them.
#include <fmt/format.h>

#include <algorithm>
#include <hexagait/figures/drawing.hpp>
#include <hexagait/pc04/gait_tables.hpp>
#include <hexagait/pc04/judges.hpp>
#include <hexagait/pc04/pc04.hpp>

namespace hexagait::experiments {
namespace {

using gait_state::GaitState;

std::string spaced(const std::string& state) {
  std::string text;
  for (const char relation : state)
    text += text.empty() ? std::string(1, relation) : std::string{' ', relation};
  return text;
}

figures::Drawing drawn(const std::vector<Table1Cell>& cells) {
  constexpr double kLeft = 150.0, kTop = 150.0, kWide = 230.0, kHigh = 84.0;
  figures::Drawing drawing;
  const char* const meaning[] = {"one leg", "two with a common neighbour", "two without",
                                 "three legs"};
  for (int column = 0; column < 4; ++column) {
    const double x = kLeft + kWide * (column + 0.5);
    drawing.text({x, kTop - 42.0}, std::string(1, static_cast<char>('A' + column)),
                 {.points = 14.0, .bold = true});
    drawing.text({x, kTop - 17.0}, meaning[column], {.points = 9.5, .colour = figures::kGrey});
  }
  for (int ccn = 1; ccn <= 5; ++ccn)
    drawing.text({kLeft - 50.0, kTop + kHigh * (ccn - 0.5)}, fmt::format("CCN {}", ccn),
                 {.points = 11.5, .align = "center", .bold = ccn == kLegs / 2});
  for (const Table1Cell& cell : cells) {
    const Vector2 corner(kLeft + kWide * (cell.type - 'A'), kTop + kHigh * (cell.ccn - 1));
    const bool is_target = cell.ccn == kLegs / 2;
    drawing.box(corner + Vector2(5.0, 5.0), corner + Vector2(kWide - 5.0, kHigh - 5.0),
                is_target ? figures::type_shade(cell.type) : "'#f3f5f7'");
    const char* const ink = is_target && cell.type == 'D' ? figures::kWhite : figures::kInk;
    for (const std::string& state : cell.classes)
      drawing.text(corner + Vector2(0.5 * kWide, 0.5 * kHigh - 10.0), spaced(state),
                   {.points = 14.0, .colour = ink, .mono = true});
    drawing.text(corner + Vector2(0.5 * kWide, 0.5 * kHigh + 18.0),
                 fmt::format("× {}", cell.states),
                 {.points = 9.5, .colour = is_target ? ink : figures::kGrey});
  }
  return drawing;
}

}  // namespace

char letter_of(gait_state::GaitType type) {
  return type == gait_state::GaitType::none ? '-'
                                            : static_cast<char>('A' + static_cast<int>(type) - 1);
}

std::string least_rotation(std::string text) {
  std::string least = text;
  for (std::size_t turn = 0; turn < text.size(); ++turn) {
    std::rotate(text.begin(), text.begin() + 1, text.end());
    least = std::min(least, text);
  }
  return least;
}

std::vector<Table1Cell> table1_cells() {
  std::vector<Table1Cell> cells;
  for (int ccn = 1; ccn < kLegs; ++ccn)
    for (const char type : {'A', 'B', 'C', 'D'}) {
      Table1Cell cell{.ccn = ccn, .type = type};
      for (gait_state::RingBits bits = 1; bits < gait_state::ring_mask(kLegs); ++bits) {
        const GaitState state{bits, kLegs};
        if (state.ccn() != ccn || letter_of(type_of(state)) != type) continue;
        ++cell.states;
        const std::string least = least_rotation(to_string(state));
        if (std::ranges::find(cell.classes, least) == cell.classes.end())
          cell.classes.push_back(least);
      }
      if (cell.states > 0) cells.push_back(cell);
    }
  return cells;
}

Outcome table1(const ExperimentContext& context, figures::StagedFiles& files) {
  const std::vector<Table1Cell> cells = table1_cells();
  figures::Csv table("ccn,type,state,rotations");
  for (const Table1Cell& cell : cells)
    for (const std::string& state : cell.classes)
      table.row(cell.ccn, cell.type, state, cell.states);
  files.write("table1.csv", table.text());
  drawn(cells).draw(
      files, context.figure(
                 "table1", 1120, 610, "The gait states of six legs, modulo rotations of the ring",
                 "rows: clockwise circularity number · columns: who may step · below each "
                 "state: how many rotations it has · after [PC04] Table 1"));
  return {.verdicts = {judge_table1(cells)}, .settings = {{"legs", "6"}}, .table = table};
}

}  // namespace hexagait::experiments

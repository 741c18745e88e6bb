// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/pc04/gait_tables.hpp>

namespace hexagait::experiments {
namespace {

// The counts of docs/theory.md; C(6, ccn) states of each CCN.
TEST(Table1, HasOneClassPerCellAndSixtyTwoStates) {
  const std::vector<std::tuple<int, char, int, std::string>> expected = {
      {1, 'A', 6, "<>>>>>"}, {2, 'A', 6, "<<>>>>"}, {2, 'B', 6, "<><>>>"}, {2, 'C', 3, "<>><>>"},
      {3, 'A', 6, "<<<>>>"}, {3, 'B', 6, "<<><>>"}, {3, 'C', 6, "<<>><>"}, {3, 'D', 2, "<><><>"},
      {4, 'A', 6, "<<<<>>"}, {4, 'B', 6, "<<<><>"}, {4, 'C', 3, "<<><<>"}, {5, 'A', 6, "<<<<<>"}};
  std::vector<std::tuple<int, char, int, std::string>> found;
  int states = 0;
  for (const Table1Cell& cell : table1_cells()) {
    ASSERT_EQ(cell.classes.size(), 1U);
    found.emplace_back(cell.ccn, cell.type, cell.states, cell.classes.front());
    states += cell.states;
  }
  EXPECT_EQ(found, expected);
  EXPECT_EQ(states, 62);
}

// Whenever leg f lands before c does, the order of events is the printed one.
TEST(Table2, ComesOutAsPrintedRowByRow) {
  for (int remaining = 1; remaining < 6; ++remaining) {
    const std::vector<Table2Row> rows = table2_rows(6, remaining);
    ASSERT_EQ(rows.size(), table2_printed().size());
    for (std::size_t k = 0; k < rows.size(); ++k)
      EXPECT_EQ(rows[k], table2_printed()[k]) << "row " << k + 1 << ", " << remaining << " left";
  }
}

}  // namespace
}  // namespace hexagait::experiments

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/gait_state/gait_state.hpp>
#include <string>
#include <vector>

namespace hexagait::experiments {

/// Of the robots of the paper's tables and of Fig. 4.
inline constexpr int kLegs = 6;

/// 'A' … 'D', or '-' for none.
[[nodiscard]] char letter_of(gait_state::GaitType type);

/// Of all rotations of a text the first in the alphabet: a gait state's begins with its longest run
/// of `<`.
[[nodiscard]] std::string least_rotation(std::string text);

/// A cell of [PC04] Table 1: the states of one CCN and one type.
struct Table1Cell {
  int ccn = 0;
  char type = '-';
  int states = 0;                         ///< how many of the 62
  std::vector<std::string> classes = {};  ///< one state per class of rotations
};

/// The cells that are not empty, by CCN and type, from all 62 states.
[[nodiscard]] std::vector<Table1Cell> table1_cells();

/// A row of [PC04] Table 2.
struct Table2Row {
  std::string state;   ///< six relations, beginning between the legs a and b
  std::string ground;  ///< six legs a … f: '*' on the ground, 'o' in the air
  char type = '-';
  std::string event;
  friend bool operator==(const Table2Row&, const Table2Row&) = default;
};

/// The rows as the library makes them: its permission to step and its rule for a step that ends, on
/// legs that take `step_time` slices, with leg f in the air for `remaining` slices more.
[[nodiscard]] std::vector<Table2Row> table2_rows(int step_time, int remaining);

/// The rows as printed.
[[nodiscard]] const std::vector<Table2Row>& table2_printed();

}  // namespace hexagait::experiments

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace hexagait::verify {

using CaseValue = std::variant<std::int64_t, double, std::string>;

/// Numbers about the cases of a theorem. Every row has a value per column.
struct CaseTable {
  std::vector<std::string> columns;  ///< snake_case: keys in JSON; with spaces, headings in text
  std::vector<std::vector<CaseValue>> rows;

  /// Adds a row.
  template <class... Values>
  void add(const Values&... cells) {
    std::vector<CaseValue>& row = rows.emplace_back();
    row.reserve(sizeof...(cells));
    (row.emplace_back(cells), ...);
  }
};

/// A statement about finitely many cases, all of which are checked.
struct Theorem {
  std::string name;        ///< one word or two, snake_case
  std::string statement;   ///< what holds
  std::string convention;  ///< definitions that the statement and its table use
  std::int64_t cases = 0;
  std::string counterexample;  ///< the first one found; empty if the theorem holds
  CaseTable table;

  [[nodiscard]] bool holds() const { return counterexample.empty(); }

  /// Records a counterexample, if it is the first.
  /// @param words  returns its description; called only if needed
  /// @returns `is_true`
  template <class Words>
  bool check(bool is_true, const Words& words) {
    if (!is_true && holds()) counterexample = words();
    return is_true;
  }
};

struct TheoremReport {
  std::vector<Theorem> theorems;

  [[nodiscard]] bool holds() const { return std::ranges::all_of(theorems, &Theorem::holds); }
};

}  // namespace hexagait::verify

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace hexagait::verify {

using Cell = std::variant<std::int64_t, double, std::string>;

/// Numbers that go with a theorem: a row of cells per case, all as long as `columns`.
struct Table {
  std::vector<std::string> columns;  ///< snake_case: keys in JSON, headings with spaces in text
  std::vector<std::vector<Cell>> rows;

  /// Adds a row.
  template <class... Values>
  void add(const Values&... cells) {
    std::vector<Cell>& row = rows.emplace_back();
    row.reserve(sizeof...(cells));
    (row.emplace_back(cells), ...);
  }
};

/// A statement about finitely many cases, of which each was tried.
struct Theorem {
  std::string name;        ///< one word or two, snake_case
  std::string statement;   ///< what holds
  std::string convention;  ///< how to read it: what counts as what
  std::int64_t cases = 0;
  std::string counterexample;  ///< the first one; empty: the theorem holds
  Table table;

  [[nodiscard]] bool holds() const { return counterexample.empty(); }

  /// Notes the first counter-example.
  /// @param words  called for its description only if it is one
  /// @returns `is_true`
  template <class Words>
  bool check(bool is_true, const Words& words) {
    if (!is_true && holds()) counterexample = words();
    return is_true;
  }
};

struct Report {
  std::vector<Theorem> theorems;

  [[nodiscard]] bool holds() const { return std::ranges::all_of(theorems, &Theorem::holds); }
};

}  // namespace hexagait::verify

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <concepts>
#include <hexagait/figures/staged_files.hpp>
#include <hexagait/math/geometry.hpp>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hexagait::figures {

/// Rows under a header: comma-separated values as RFC 4180 has them, for gnuplot, for spreadsheets;
/// or cells, for a page.
///
///     Csv csv("time_s,x_m,y_m,z_m");
///     csv.row(0.02, p_WB);
class Csv {
 public:
  using Row = std::vector<std::string>;

  Csv() = default;
  /// @param header  names of the columns, with commas between them
  explicit Csv(std::string_view header);

  /// One row. Numbers have nine significant digits, NaN is an empty cell, truth 0 or 1; a vector
  /// fills a cell per coordinate; text with a comma, a quote or a line break is quoted.
  template <class... Values>
  void row(const Values&... values) {
    rows_.emplace_back();
    (add(values), ...);
  }
  /// A blank line, one at a time: a curve through the rows is interrupted here.
  void gap() {
    if (rows_.empty() || !rows_.back().empty()) rows_.emplace_back();
  }

  [[nodiscard]] const Row& header() const { return header_; }
  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }
  [[nodiscard]] std::string text() const;

 private:
  void add(double value);
  void add(std::string_view value) { rows_.back().emplace_back(value); }
  void add(const char* value) { add(std::string_view(value)); }
  void add(char value) { add(std::string_view(&value, 1)); }
  void add(std::integral auto value) { add(std::to_string(value)); }
  template <int N>
  void add(const Eigen::Matrix<double, N, 1>& value) {
    for (const double coordinate : value) add(coordinate);
  }

  Row header_;
  std::vector<Row> rows_;
};

/// The tables that a figure is made of: stem-NAME.csv each.
void write_tables(StagedFiles& files, const std::string& stem,
                  std::initializer_list<std::pair<std::string_view, const Csv&>> tables);

}  // namespace hexagait::figures

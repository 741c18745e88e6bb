// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <concepts>
#include <hexagait/math/geometry.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace hexagait::figures {

/// Comma-separated values under a header, as RFC 4180 has them: for gnuplot, for spreadsheets.
///
///     Csv csv("time_s,x_m,y_m,z_m");
///     csv.row(0.02, p_WB);
class Csv {
 public:
  Csv() = default;
  explicit Csv(std::string_view header) : text_(header) { text_ += '\n'; }

  /// One row. Numbers have nine significant digits, NaN is an empty cell, truth 0 or 1; a vector
  /// fills a cell per coordinate; text with a comma, a quote or a line break is quoted.
  template <class... Values>
  void row(const Values&... values) {
    (add(values), ...);
    text_.back() = '\n';
  }
  void cells(const std::vector<std::string>& row) {
    for (const std::string& cell : row) add(cell);
    text_.back() = '\n';
  }
  /// A blank line, one at a time: a curve through the rows is interrupted here.
  void gap() {
    if (!text_.ends_with("\n\n")) text_ += '\n';
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  void add(double value);
  void add(std::string_view value);
  void add(const char* value) { add(std::string_view(value)); }
  void add(char value) { add(std::string_view(&value, 1)); }
  void add(std::integral auto value) {
    text_ += std::to_string(value);
    text_ += ',';
  }
  template <int N>
  void add(const Eigen::Matrix<double, N, 1>& value) {
    for (const double coordinate : value) add(coordinate);
  }

  std::string text_;
};

}  // namespace hexagait::figures

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/text/mark.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace hexagait {

/// Collects everything that is wrong with one input, so that a user sees it all at once: up to
/// kMost, after which it throws, so that a large file of nothing else needs no longer list.
class Violations {
 public:
  static constexpr std::size_t kMost = 100;

  /// @param source  names the input in every line, e.g. the file's path
  explicit Violations(std::string source) : source_(std::move(source)) {}

  /// Adds the line "source: element: problem". The problem names the value and what would be right.
  /// @throws InvalidInput  if it is the last that is listed
  void add(std::string_view element, std::string_view problem);

  /// Adds the line "source:line: element: problem"; of line 0, as above.
  void add(int line, std::string_view element, std::string_view problem);

  /// Adds the line "source:line:column: problem", unless it is there already: what is referred to
  /// twice is found twice. @throws InvalidInput  as above
  void add(const Mark& mark, std::string_view problem);

  [[nodiscard]] std::size_t size() const { return lines_.size(); }
  [[nodiscard]] bool empty() const { return lines_.empty(); }

  /// @throws InvalidInput  with all lines, if there are any
  void throw_if_any() const;

 private:
  void add_line(std::string line);

  std::string source_;
  std::vector<std::string> lines_;
};

/// A number as it is shown in messages: shortest form, six digits or as many as are asked for.
[[nodiscard]] std::string in_words(double value, int digits = 6);

}  // namespace hexagait

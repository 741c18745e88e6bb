// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/figures/panel.hpp>
#include <hexagait/figures/staged_files.hpp>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace hexagait::figures {

/// What is drawn, and what stands above it.
struct Figure {
  std::string stem;                 ///< names of all files, without their endings
  std::string suffix = {};          ///< ".png", ".svg" or ".pdf"; empty: a file of each
  std::string headline, subtitle;   ///< both empty: no titles, on a sheet that is less tall
  int width = 1500, height = 1000;  ///< of the sheet with titles [px of a PNG]
};

/// What C++ tells a gnuplot script: a variable of each name, of text or number; lists are arrays,
/// from 1. A panel NAME is set up by `eval NAME_panel`, and NAME_top is its upper edge; a box NAME
/// is shown by `eval NAME_range`.
class Variables {
 public:
  using Value = std::variant<int, double, std::string, std::vector<double>,
                             std::vector<std::string>, Panel, Box>;
  Variables() = default;
  Variables(std::initializer_list<std::pair<std::string_view, Value>> values) {
    for (const auto& [name, value] : values) set(name, value);
  }
  void set(std::string_view name, const Value& value);

  /// The assignments, a line each.
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// Writes stem.gp, which has all it needs but the data: figure, width, height, stem, headline and
/// subtitle; the preamble (preamble.gp); the variables; the script. Then runs it. The caller has
/// registered stem.suffix, unless there is a file of each kind.
/// @throws std::runtime_error  with what gnuplot said, if it fails
void draw_figure(StagedFiles& files, const Figure& figure, const Variables& variables,
                 std::string_view script);

}  // namespace hexagait::figures

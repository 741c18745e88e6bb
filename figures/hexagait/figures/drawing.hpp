// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/figures/figure.hpp>
#include <string>
#include <vector>

namespace hexagait::figures {

/// Colours of the palette, by their names in preamble.gp; any other one is as "'#ffffff'".
inline constexpr const char* kInk = "ink";
inline constexpr const char* kGrey = "grey";
inline constexpr const char* kAccent = "accent";
inline constexpr const char* kWhite = "'#ffffff'";

/// Shade of a gait state's type A, B, C, D: the more legs have priority, the darker.
[[nodiscard]] inline std::string type_shade(char type) {
  return "type_shade(" + std::to_string(type - 'A' + 1) + ")";
}

/// Shapes and text on a white sheet, for figures that plot no data. Places in pixels of the PNG,
/// y downwards. What comes later covers what came before; text is above all.
class Drawing {
 public:
  struct TextStyle {
    double points = 10.5;
    const char* colour = kInk;
    const char* align = "center";  ///< left, center, right
    bool bold = false, mono = false;
  };

  void text(const Vector2& place, const std::string& text, const TextStyle& style);
  void box(const Vector2& least, const Vector2& greatest, const std::string& fill);
  void disc(const Vector2& centre, double radius, const std::string& fill,
            const std::string& border);
  /// Through all points, with an arrow-head at the last.
  void arrow(const std::vector<Vector2>& points, const std::string& colour, double line_width);

  void draw(StagedFiles& files, const Figure& figure) const;

 private:
  int count_ = 0;
  std::string data_, plots_, front_;
};

}  // namespace hexagait::figures

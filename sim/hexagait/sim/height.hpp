// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace hexagait {

/// A parsed height, or why the text is not one.
struct ParsedHeight {
  double metres = 0.0;
  std::string problem = {};  ///< empty if there is none
};

/// Reads a height of terrain such as 0.05, 0.05m, 5cm or 50mm: finite, not negative.
[[nodiscard]] ParsedHeight parse_height(std::string_view text);

}  // namespace hexagait

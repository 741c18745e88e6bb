// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace hexagait {

/// What a text says, or what is wrong with it.
struct ParsedHeight {
  double metres = 0.0;
  std::string problem = {};  ///< empty: nothing
};

/// Reads a height of terrain such as 0.05, 0.05m, 5cm or 50mm: finite, not negative.
[[nodiscard]] ParsedHeight parse_height(std::string_view text);

}  // namespace hexagait

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace hexagait::sim3d {

/// Levels on a grid of square pixels, as a picture has them: row 0 is its upper edge.
struct Heightmap {
  int columns = 0, rows = 0;  ///< at least 2 each
  std::vector<float> levels;  ///< row by row; of a picture 0 (black) to 1 (white)

  /// Between the middles of four pixels bilinear; beyond the edges as on them.
  /// @param column,row  0, 0 is the middle of the first pixel
  [[nodiscard]] double at(double column, double row) const;
  [[nodiscard]] double lowest() const;
  [[nodiscard]] double highest() const;
  /// FNV-1a of size and levels.
  [[nodiscard]] std::uint64_t hash() const;
};

/// Reads a grey PNG of 8 or 16 bits, or a table of numbers with commas between them.
/// @throws InvalidInput  with the file and what is wrong with it; also for a PNG, if this library was
///                       built without libpng
[[nodiscard]] Heightmap load_heightmap(const std::string& file);

}  // namespace hexagait::sim3d

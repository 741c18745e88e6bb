// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hexagait::sim3d {

/// The kind and dimensions of a terrain.
struct TerrainSpec {
  enum class Kind {
    flat,   ///< the plane z = 0
    boxes,  ///< square cells at random levels, with vertical faces between them
    steps,  ///< the same levels as a heightfield, with ramps one sample wide between cells
    step,   ///< one step up, at the front edge of the start pad
  };
  Kind kind = Kind::flat;
  double height = 0.0;  ///< random levels are uniform in [0, height); or height of the step [m]
  double cell = 0.3;    ///< edge of a cell [m]

  friend bool operator==(const TerrainSpec&, const TerrainSpec&) = default;
};

/// The description of a kind of terrain, for `--help` and messages.
struct TerrainDescription {
  std::string_view syntax;   ///< e.g. "boxes:H"
  std::string_view meaning;  ///< one line
};

/// All terrains that parse_terrain() understands.
[[nodiscard]] const std::vector<TerrainDescription>& known_terrains();

/// Reads "flat", "boxes:H", "steps:H" or "step:H", where H is a length such as 0.10, 0.10m, 10cm or
/// 100mm.
/// @throws InvalidInput  with the text and the known terrains, for an unknown kind, a missing,
///         negative or non-finite height, or trailing text
[[nodiscard]] TerrainSpec parse_terrain(std::string_view text);

/// Inverse of parse_terrain(), exactly.
[[nodiscard]] std::string to_string(const TerrainSpec& spec);

/// An unbounded terrain: its height is a pure function of position, spec and seed.
///
/// Cell (i, j) covers [i·cell, (i+1)·cell) × [j·cell, (j+1)·cell) in the world frame. Its level is
/// random number (i, j) of RandomStream::terrain, independent of the order of queries. For a step,
/// it is 0 or the height. The 4 × 4 cells around the origin are the start pad, at level 0.
/// Coordinates may be up to 10⁸ cells.
class Terrain {
 public:
  /// @throws InvalidInput  if the height is negative or not finite, or the cell not positive
  Terrain(const TerrainSpec& spec, std::uint64_t seed);

  [[nodiscard]] const TerrainSpec& spec() const { return spec_; }

  /// Level of a cell [m]; 0 on flat ground and on the start pad.
  [[nodiscard]] double level(int i, int j) const;

  /// Index, along one axis, of the cell that contains this coordinate [m].
  [[nodiscard]] int cell_index(double coordinate) const;

  /// Height of the surface at (x, y), world frame [m]. On a boundary between boxes, the level of
  /// the cell with the larger index.
  [[nodiscard]] double height_at(double x, double y) const;

  /// Spacing of the heightfield's samples [m]; the width of the ramps of `steps`.
  [[nodiscard]] double sample_spacing() const { return spec_.cell / kSamplesPerCell; }

  /// Height of the heightfield's sample (a, b) [m], at ((a + ½) · spacing, (b + ½) · spacing).
  [[nodiscard]] double sample(int a, int b) const;

  /// Samples per cell along one axis.
  static constexpr int kSamplesPerCell = 12;

 private:
  [[nodiscard]] double heightfield_at(double x, double y) const;

  TerrainSpec spec_;
  std::uint64_t seed_;
};

}  // namespace hexagait::sim3d

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hexagait::sim3d {

/// What the ground looks like, without its random numbers.
struct TerrainSpec {
  enum class Kind {
    flat,   ///< the plane z = 0
    boxes,  ///< square cells at random levels, with vertical faces between them
    steps,  ///< the same levels as a heightfield: between cells a ramp one sample wide
    step,   ///< 0 behind the front end of the start pad, from there on the height
  };
  Kind kind = Kind::flat;
  double height = 0.0;  ///< levels are uniform in [0, height), or of the step [m]
  double cell = 0.3;    ///< edge of a cell [m]

  friend bool operator==(const TerrainSpec&, const TerrainSpec&) = default;
};

/// A kind of terrain, described for a person.
struct TerrainDescription {
  std::string_view syntax;   ///< e.g. "boxes:H"
  std::string_view meaning;  ///< one line
};

/// All terrains that parse_terrain() understands.
[[nodiscard]] const std::vector<TerrainDescription>& known_terrains();

/// Reads "flat", "boxes:H", "steps:H" or "step:H", where H is a length such as 0.10, 0.10m, 10cm or
/// 100mm.
/// @throws InvalidInput  naming the text and what would be right, for an unknown kind, a missing,
///                       negative or non-finite height, or anything left over
[[nodiscard]] TerrainSpec parse_terrain(std::string_view text);

/// The spec as text that parse_terrain() reads back exactly.
[[nodiscard]] std::string to_string(const TerrainSpec& spec);

/// Ground without end: the height as a function of the place, a pure function of (spec, seed).
///
/// Cell (i, j) covers [i·cell, (i+1)·cell) × [j·cell, (j+1)·cell) in the world frame. Its level is
/// random number (i, j) of RandomStream::terrain, so it depends neither on where the robot is nor
/// on which cells were asked for before. Of a step it is 0 or the height. The 4 × 4 cells around
/// the origin are the start pad, at 0. Coordinates may be up to 10⁸ cells.
class Terrain {
 public:
  /// @throws InvalidInput  if the height is negative or not finite, or the cell not positive
  Terrain(const TerrainSpec& spec, std::uint64_t seed);

  [[nodiscard]] const TerrainSpec& spec() const { return spec_; }

  /// Level of a cell [m]; 0 on flat ground and on the start pad.
  [[nodiscard]] double level(int i, int j) const;

  /// Index of the cell, or of the slab of cells, that contains this coordinate [m].
  [[nodiscard]] int cell_index(double coordinate) const;

  /// Height of the surface [m] at (x, y) [m] in the world frame. On a cell boundary of boxes, the
  /// level of the cell with the larger index.
  [[nodiscard]] double height_at(double x, double y) const;

  /// Spacing of the heightfield's samples [m]; the width of the ramps of `steps`.
  [[nodiscard]] double sample_spacing() const { return spec_.cell / kSamplesPerCell; }

  /// Height of the heightfield's sample (a, b) [m], which stands half a spacing inside the lower
  /// corner of its square: at ((a + ½) · spacing, (b + ½) · spacing).
  [[nodiscard]] double sample(int a, int b) const;

  /// Samples per cell along one axis.
  static constexpr int kSamplesPerCell = 12;

 private:
  [[nodiscard]] double heightfield_at(double x, double y) const;

  TerrainSpec spec_;
  std::uint64_t seed_;
};

}  // namespace hexagait::sim3d

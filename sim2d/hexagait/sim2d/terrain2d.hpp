// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/math/geometry.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace hexagait::sim2d {

/// The ground of a side view: a profile under the left legs and one under the right ones.
struct TerrainSpec2d {
  enum class Kind {
    flat,   ///< z = 0
    rough,  ///< cells at random levels, left and right independent, with vertical faces
    step,   ///< one step up and later one down, the same left and right
    steps,  ///< one up and one down again and again
  };
  Kind kind = Kind::flat;
  double height = 0.0;  ///< rough: levels are uniform in [0, height); else the rise of a step [m]

  friend bool operator==(const TerrainSpec2d&, const TerrainSpec2d&) = default;
};

/// A kind of terrain, described for a person.
struct TerrainDescription2d {
  std::string_view syntax;   ///< e.g. "rough:H"
  std::string_view meaning;  ///< one line
};

/// All terrains that parse_terrain2d() understands.
[[nodiscard]] const std::vector<TerrainDescription2d>& known_terrains2d();

/// Reads "flat", "rough:H", "step:H" or "steps:H", where H is a length such as 0.05, 5cm or 50mm.
/// @throws InvalidInput  naming the text and what would be right, for an unknown kind, a missing,
///                       negative or non-finite height, or anything left over
[[nodiscard]] TerrainSpec2d parse_terrain2d(std::string_view text);

/// The spec as text that parse_terrain2d() reads back exactly.
[[nodiscard]] std::string to_string(const TerrainSpec2d& spec);

enum class Side : std::uint8_t { left, right };

/// Ground without end, both ways: the height as a function of side and place, a pure function of
/// (spec, seed). The level of cell k of a side is random number (k, side) of
/// RandomStream::terrain: no controller changes it. The cells around the origin are the start pad,
/// at 0.
///
/// `step` rises at |x| = 0.50 m + u and falls back 1.2 m further, with u uniform in one cell: seeds
/// meet the edge in different phases of their steps. `steps` repeats that every 2.4 m.
class Terrain2d {
 public:
  static constexpr double kCell = 0.1;  ///< length of a cell of `rough` [m]

  /// @throws InvalidInput  if the height is negative or not finite
  Terrain2d(const TerrainSpec2d& spec, std::uint64_t seed);

  [[nodiscard]] const TerrainSpec2d& spec() const { return spec_; }

  /// Height of the surface at x [m]. On a vertical face, that of its right end.
  [[nodiscard]] double height_at(Side side, double x) const;

  /// The surface from x0 to x1 as a line of points (x, z), from left to right: two per face. [m]
  [[nodiscard]] std::vector<Vector2> profile(Side side, double x0, double x1) const;

 private:
  [[nodiscard]] double level(Side side, long cell) const;
  [[nodiscard]] std::vector<double> faces(double x0, double x1) const;

  TerrainSpec2d spec_;
  std::uint64_t seed_;
  double first_edge_ = 0.0;  ///< of a step [m]
};

}  // namespace hexagait::sim2d

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hexagait::sim3d {

/// Kinds of ground. "Ahead" is along +x from the end of the start pad, 0.6 m ahead of the origin; that
/// of boxes, steps and rubble is two cells wide to each side.
enum class TerrainKind : std::uint8_t {
  flat,       ///< the plane z = 0
  boxes,      ///< square cells at random levels, with vertical faces between them
  steps,      ///< the same levels as a heightfield, with ramps one sample wide between cells
  step,       ///< one step up or down, ahead
  stairs,     ///< flights of 10 steps up and down again, ahead, with landings of 5 steps
  ditches,    ///< across the way, 1 m deep, one in each 1.5 m
  stones,     ///< square stepping stones at level 0; 1 m deep between them
  slope,      ///< level on the pad, then a plane
  waves,      ///< sines along x and y
  ramps,      ///< up and down in turn, ahead
  rubble,     ///< cells at random levels, each tilted at random, with ramps one sample wide between
  ice,        ///< squares of 0.6 m, half of which have another friction
  cliff,      ///< a square around the origin; beyond its edges it goes down
  arena,      ///< a square around the origin between walls and cliffs, with pits and pillars in it
  heightmap,  ///< the levels of a file, ahead; beyond its edges as on them
  soft,       ///< all of the ground gives way, as a spring and a damper under each foot
};

/// Edge of the cells of boxes, steps and rubble unless told otherwise, and of an arena's cells [m].
inline constexpr double kCellEdge = 0.3;
/// The start pad ends so many cells from the origin, to each side.
inline constexpr double kPadCells = 2.0;

/// One kind of ground with its dimensions. Terrains are sums of parts.
struct TerrainPart {
  TerrainKind kind = TerrainKind::flat;
  /// Height [m] of boxes, steps, a step, one of the stairs, waves, ramps, rubble; width of a ditch
  /// or edge of a stone, a cliff's square or an arena [m]; angle of a slope [rad]; coefficient of
  /// friction of ice; level of a heightmap's white, or 1 [m]; stiffness of soft ground [N/m].
  double size = 0.0;
  /// Edge of the cells of boxes, steps and rubble, depth of the stairs' treads, gap between stones,
  /// length of a wave or a ramp, depth of a cliff [m]; direction in which a slope rises, from +x
  /// [rad]; share of an arena's cells that are pits or pillars; length of a heightmap along x [m];
  /// damping of soft ground [N s/m].
  double extent = 0.0;
  std::string file = {};  ///< of a heightmap

  friend bool operator==(const TerrainPart&, const TerrainPart&) = default;
};

/// A terrain: the sum of its parts; none is flat ground.
struct TerrainSpec {
  std::vector<TerrainPart> parts;

  TerrainSpec() = default;
  /// One part, with the default extent of its kind.
  TerrainSpec(TerrainKind kind, double size);

  /// Sum of the heights of its parts [m]: of boxes, steps, a step, one of the stairs, waves, ramps
  /// and rubble.
  [[nodiscard]] double roughness() const;

  friend bool operator==(const TerrainSpec&, const TerrainSpec&) = default;
};

/// The description of a kind of terrain, for `--help` and messages.
struct TerrainDescription {
  std::string_view syntax;   ///< e.g. "boxes:H"
  std::string_view meaning;  ///< one line
  std::string_view example;  ///< e.g. "boxes:10cm"
  bool reads_file = false;   ///< the example names a file that need not exist
};

/// All kinds that parse_terrain() understands.
[[nodiscard]] const std::vector<TerrainDescription>& known_terrains();

/// Reads a kind with its dimensions, such as "flat", "boxes:10cm" or "stairs:17cm,29cm", or a sum
/// of them, such as "slope:10deg+boxes:0.1". It opens no file: Terrain does.
/// @throws InvalidInput  with the text, the reason and the known terrains
[[nodiscard]] TerrainSpec parse_terrain(std::string_view text);

/// Inverse of parse_terrain(), exactly.
[[nodiscard]] std::string to_string(const TerrainSpec& spec);

}  // namespace hexagait::sim3d

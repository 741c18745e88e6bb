// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/sim3d/heightmap.hpp>
#include <hexagait/sim3d/terrain_spec.hpp>
#include <optional>
#include <vector>

namespace hexagait::sim3d {

/// The cells of a terrain along one axis: all of one width, or of two widths in turn. Cell 0 begins
/// at the origin.
struct CellAxis {
  double even = kCellEdge;  ///< width of cells 0, 2, … [m]
  double odd = 0.0;         ///< and of the others [m]; 0: there are no others, all cells are even

  /// Where cell i begins, and cell i − 1 ends [m].
  [[nodiscard]] double edge(int i) const;
  [[nodiscard]] double middle(int i) const;  ///< of cell i [m]
  /// The cell that contains this coordinate [m]; on a boundary, that with the larger index.
  [[nodiscard]] int index(double coordinate) const;
};

/// An unbounded terrain: its height is a pure function of position, spec and seed.
///
/// Terrains of one part that has vertical faces (boxes, a step, stairs, ditches, stones, a cliff,
/// an arena) are cells, each level. Any other is a heightfield: what has vertical faces has ramps one sample wide in a
/// sum.
///
/// Cell (i, j) covers [x(i), x(i+1)) × [y(j), y(j+1)) in the world frame. A random level is number
/// (i, j) of RandomStream::terrain, independent of the order of queries. Cells that reach into the
/// square within 0.6 m of the origin are the start pad, at level 0; of boxes, steps and rubble the
/// square ends two of their cells from the origin. Coordinates may be up to 10⁸ cells.
class Terrain {
 public:
  /// By what the ground gives way under a foot; several contacts of one foot share it.
  struct Softness {
    double stiffness = 0.0;  ///< [N/m]
    double damping = 0.0;    ///< [N s/m]
  };

  /// What the ground is made of.
  enum class Surface : std::uint8_t { plane, cells, samples };

  /// @throws InvalidInput  if a dimension is out of the range that parse_terrain() accepts, or a
  ///         heightmap's file can't be read
  Terrain(const TerrainSpec& spec, std::uint64_t seed);

  [[nodiscard]] const TerrainSpec& spec() const { return spec_; }
  [[nodiscard]] Surface surface() const { return surface_; }

  /// Height of the surface at (x, y), world frame [m]. On a boundary between cells, the level of
  /// the cell with the larger index.
  [[nodiscard]] double height_at(double x, double y) const;

  /// Bounds of the height [m]; infinite on slopes.
  [[nodiscard]] double highest() const { return highest_; }
  [[nodiscard]] double lowest() const { return lowest_; }

  /// Coefficient of friction at (x, y), if it is `otherwise` where there is no ice.
  [[nodiscard]] double friction_at(double x, double y, double otherwise) const;

  /// That of soft ground; of several soft parts the least stiff. Nothing: the ground is rigid.
  [[nodiscard]] const std::optional<Softness>& softness() const { return softness_; }

  /// The cells of a terrain of cells; of others, those of boxes.
  [[nodiscard]] const CellAxis& x_axis() const { return cells_.x; }
  [[nodiscard]] const CellAxis& y_axis() const { return cells_.y; }

  /// Level of a cell of a terrain of cells [m]; 0 of others.
  [[nodiscard]] double level(int i, int j) const;

  /// Spacing of the heightfield's samples [m]; the width of its ramps.
  [[nodiscard]] double sample_spacing() const { return spacing_; }

  /// Height of the heightfield's sample (a, b) [m], at ((a + ½) · spacing, (b + ½) · spacing).
  [[nodiscard]] double sample(int a, int b) const;

  /// Samples per cell along one axis.
  static constexpr int kSamplesPerCell = 12;

 private:
  struct Cells {
    CellAxis x, y;
    double pad = kPadCells * kCellEdge;  ///< half an edge of the start pad [m]
  };
  /// One part, and what does not depend on the place.
  struct Layer {
    TerrainPart part;
    Cells cells;
    std::uint32_t draws = 0;           ///< the first of its numbers of RandomStream::terrain
    double along = 0.0, across = 0.0;  ///< a slope's rise per metre in x and in y
    Heightmap map = {};
  };

  [[nodiscard]] static Layer layer(const TerrainPart& part, std::uint32_t draws);
  [[nodiscard]] double random(const Layer& layer, std::uint32_t which, int i, int j) const;
  [[nodiscard]] double level(const Layer& layer, int i, int j) const;
  [[nodiscard]] double arena(const Layer& layer, int i, int j) const;
  [[nodiscard]] double rubble(const Layer& layer, double x, double y) const;
  [[nodiscard]] static double on_map(const Layer& layer, double x, double y);
  [[nodiscard]] double height(const Layer& layer, double x, double y) const;
  [[nodiscard]] double heightfield_at(double x, double y) const;

  TerrainSpec spec_;
  std::uint64_t seed_;
  Surface surface_ = Surface::plane;
  Cells cells_;
  std::vector<Layer> layers_;
  double lowest_ = 0.0, highest_ = 0.0;
  double spacing_ = kCellEdge / kSamplesPerCell;
  std::optional<Softness> softness_;
};

}  // namespace hexagait::sim3d

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/figures/csv.hpp>
#include <hexagait/figures/figure.hpp>
#include <hexagait/sim3d/terrain.hpp>
#include <span>
#include <string>

namespace hexagait::recording {

/// A terrain, and what it is called in a figure.
struct NamedTerrain {
  std::string name;
  sim3d::Terrain terrain;
};

/// Draws terrains on one sheet, four in a row, each from the right and above with its name: from the
/// start pad to 4.5 m ahead, and 1.5 m to each side. Writes the figure and the tables it was made of.
/// @throws std::runtime_error  if gnuplot fails
void draw_terrains(figures::StagedFiles& files, figures::Figure figure,
                   std::span<const NamedTerrain> terrains);

/// The ground as a grid: x_m, y_m, z_m and paint, a number from −1 (low) to 1 (high), 2 on ice and 3 where
/// the ground is soft.
[[nodiscard]] figures::Csv ground_table(const sim3d::Terrain& terrain);

}  // namespace hexagait::recording

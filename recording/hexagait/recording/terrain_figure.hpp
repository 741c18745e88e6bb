// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/figures/csv.hpp>
#include <hexagait/figures/figure.hpp>
#include <hexagait/sim3d/terrain.hpp>
#include <span>

namespace hexagait::recording {

/// Draws terrains on one sheet, four in a row, each from the right and above with its name: from the
/// start pad to 4.5 m ahead, and 1.5 m to each side. Writes the figure and the tables it was made of.
/// @param seed  of all of them
/// @throws InvalidInput        if a terrain reads a file that can't be read
/// @throws std::runtime_error  if gnuplot fails
void draw_terrains(figures::StagedFiles& files, figures::Figure figure,
                   std::span<const std::string> terrains, std::uint64_t seed);

/// The ground as a grid: x_m, y_m, z_m and paint, a number from −1 (low) to 1 (high), 2 on ice and 3 where
/// the ground is soft.
[[nodiscard]] figures::Csv ground_table(const sim3d::Terrain& terrain);

}  // namespace hexagait::recording

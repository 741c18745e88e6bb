// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <hexagait/recording/figures/detail/sheet.hpp>
#include <hexagait/recording/figures/terrain_figure.gp.hpp>
#include <hexagait/recording/figures/terrain_figure.hpp>

namespace hexagait::recording {
namespace {

using detail::kColumns;
using detail::kTitles;
using detail::kWidth;

constexpr int kTerrainRow = 270;                            // [px]
constexpr double kBack = -0.9, kAhead = 4.5, kAside = 1.5;  // [m]
constexpr double kGrid = 0.05;                              // [m]
constexpr double kColoured = 0.25;                          // height of the last colour [m]
constexpr double kIcy = 2.0, kSoft = 3.0, kShown = 0.8;     // paints; depth that is shown [m]

double paint(const sim3d::Terrain& terrain, double x, double y, double z) {
  if (terrain.friction_at(x, y, -1.0) >= 0.0) return kIcy;
  return terrain.softness() ? kSoft : std::clamp(z / kColoured, -1.0, 1.0);
}

}  // namespace

figures::Csv ground_table(const sim3d::Terrain& terrain) {
  figures::Csv table("x_m,y_m,z_m,paint");
  const int along = static_cast<int>(std::lround((kAhead - kBack) / kGrid)),
            aside = static_cast<int>(std::lround(2.0 * kAside / kGrid));
  for (int i = 0; i <= along; ++i) {
    for (int j = 0; j <= aside; ++j) {
      // Not on boundaries between cells.
      const double x = kBack + (i + 0.3) * kGrid, y = -kAside + (j + 0.3) * kGrid;
      const double z = terrain.height_at(x, y);
      table.row(x, y, std::clamp(z, -kShown, kShown), paint(terrain, x, y, z));
    }
    table.gap();
  }
  return table;
}

void draw_terrains(figures::StagedFiles& files, figures::Figure figure,
                   std::span<const NamedTerrain> terrains) {
  const int count = static_cast<int>(terrains.size()), columns = std::min(count, kColumns);
  const int rows = (count + kColumns - 1) / kColumns;
  figure.width = kWidth;
  figure.height = count == 1 ? 900 : rows * kTerrainRow + kTitles;
  std::vector<std::string> names;
  for (int k = 0; k < count; ++k) {
    const auto& [name, terrain] = terrains[static_cast<std::size_t>(k)];
    names.push_back(name);
    const figures::Csv table = ground_table(terrain);
    figures::write_tables(files, figure.stem, {{fmt::format("{}", k + 1), table}});
  }
  figures::draw_figure(
      files, figure,
      {{"names", names},
       {"columns", columns},
       {"rows", rows},
       {"below_titles", 1.0 - (figure.headline.empty() ? 0.0 : double{kTitles} / figure.height)}},
      scripts::recording::terrain_figure);
}

}  // namespace hexagait::recording

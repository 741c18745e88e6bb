// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/statistics/statistics.hpp>
#include <limits>
#include <string>
#include <vector>

namespace hexagait::experiments {

/// How walks with one plant went on one terrain.
struct Cost {
  statistics::Proportion arrived;
  double speed = std::numeric_limits<double>::quiet_NaN();     ///< of those that walked on [m/s]
  double off_path = std::numeric_limits<double>::quiet_NaN();  ///< mean distance, the same [m]
  double losses = 0.0, real_losses = 0.0;  ///< contacts lost per step, of all walks
};

/// The walks with one plant.
struct PlantCost {
  std::string plant;  ///< as --plant reads it
  Cost flat, boxes;
};

/// Sizes of one imperfection, from small to large.
struct Ladder {
  std::string fault;                ///< name of the number; empty: plants of their own
  std::vector<std::string> plants;  ///< as --plant reads them
};

/// All of them; the short form has a few.
[[nodiscard]] std::vector<Ladder> ladders(bool short_form);

/// Does it still walk: do four of five arrive, on both terrains, at four fifths of the speed with an
/// ideal plant?
[[nodiscard]] bool still_walks(const PlantCost& cost, const PlantCost& ideal);

/// The first of the ladder's plants with which it no longer does; empty if there is none.
[[nodiscard]] std::string breaks_at(const Ladder& ladder, const std::vector<PlantCost>& costs);

/// The costs of a plant. @pre it is there
[[nodiscard]] const PlantCost& cost_of(const std::string& plant,
                                       const std::vector<PlantCost>& costs);

/// What the page says of how it was made.
struct PageHead {
  double distance = 0.0;  ///< of each walk [m]
  double seconds = 0.0;   ///< that it may take
  std::uint64_t flat_seeds = 0, boxes_seeds = 0;
  bool short_form = false;
};

/// docs/sensitivity.md. The first of the costs are those of the ideal plant.
[[nodiscard]] std::string page(const PageHead& head, const std::vector<Ladder>& ladders,
                               const std::vector<PlantCost>& costs);

}  // namespace hexagait::experiments

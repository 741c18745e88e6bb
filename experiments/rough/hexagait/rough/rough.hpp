// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/experiments/experiment.hpp>
#include <hexagait/sweep/sweep.hpp>

namespace hexagait::experiments {

/// Success and cost against the height of boxes, of four controllers: docs/rough_terrain.md.
Outcome rough(const ExperimentContext& context, figures::StagedFiles& files);

/// How much of it is walked.
struct RoughSize {
  std::vector<double> heights;  ///< of the boxes; 0: flat ground [m]
  std::uint64_t seeds = 0;      ///< of the terrains, from 1 on
  double distance = 0.0;        ///< to arrive at [m]
  double seconds = 0.0;         ///< within which [s]
};

/// That of the protocol: boxes of up to 0.8 of the reach of a leg. A short form has two heights and
/// some seconds.
[[nodiscard]] RoughSize rough_size(const RobotModel& robot, std::uint64_t seeds, bool short_form);

/// The reach of the longest leg [m].
[[nodiscard]] double leg_reach(const RobotModel& robot);

/// Its walks: the plants × heights × seeds × controllers.
[[nodiscard]] sweep::Sweep rough_sweep(const RobotModel& robot, const RoughSize& size,
                                       std::vector<recording::PlantSetup> plants);

}  // namespace hexagait::experiments

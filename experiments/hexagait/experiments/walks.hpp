// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/experiments/experiment.hpp>
#include <hexagait/figures/csv.hpp>
#include <hexagait/recording/simulation.hpp>
#include <span>

/// The walks by which the controller is judged, and the verdicts on them.
namespace hexagait::experiments {

struct JudgedWalk {
  std::string group, name;
  recording::Simulation simulation;
  double max_lateral = 0.0;  ///< bound on the mean distance from the path [m]; 0: none
  walk::Summary summary = {};
};

/// Ten constant headings on flat ground: straight on, arcs, spins, crabs and backwards.
[[nodiscard]] std::vector<JudgedWalk> ten_headings(double seconds);

/// Straight on over terrain, as far as asked, with a walk for each seed from 1 on.
/// @param terrain  as on the command line, "boxes:0.10"
/// @param plant    as on the command line, "real"
[[nodiscard]] std::vector<JudgedWalk> over_terrain(const std::string& terrain, std::uint64_t count,
                                                   double metres,
                                                   const std::string& plant = "ideal");

/// Walks them, on all cores, and fills in their summaries. Reports progress. If the context's plant is
/// not ideal, all are on it.
/// @returns false if it was stopped before the end
[[nodiscard]] bool walk_all(const ExperimentContext& context,
                            std::span<std::vector<JudgedWalk>> groups);

/// A row for each walk.
[[nodiscard]] figures::Csv table(std::span<const std::vector<JudgedWalk>> groups);

[[nodiscard]] Check none_stuck(std::span<const JudgedWalk> walks);

/// Horizontal distance of the farthest workspace centre from the base [m].
[[nodiscard]] double farthest_workspace(const RobotModel& robot);

/// Speed of a foot below the farthest workspace centre, on the outside of a curve [m/s]: also of a
/// spin, where the base goes nowhere.
/// @param reach  distance of that centre from the base [m]
[[nodiscard]] double outermost_speed(const JudgedWalk& walk, double reach);

/// Constant headings on flat ground.
/// @param reach  of the farthest workspace centre from the base [m]
[[nodiscard]] Verdict judge_headings(std::span<const JudgedWalk> walks, double reach);

/// Straight on, from random postures.
[[nodiscard]] Verdict judge_postures(std::span<const JudgedWalk> walks);

/// A new random heading every second.
[[nodiscard]] Verdict judge_commands(std::span<const JudgedWalk> walks);

/// From straight on, at full speed, to a command that leaves the line.
[[nodiscard]] Verdict judge_sharp_changes(std::span<const JudgedWalk> walks);

/// Straight on over rough ground, as far as asked.
[[nodiscard]] Verdict judge_terrain(std::span<const JudgedWalk> walks);

/// The same with a plant that is not ideal: no fall, and where it ends.
[[nodiscard]] Verdict judge_plant(std::span<const JudgedWalk> walks);

/// The same with the plant real: 95 % arrive, and at most 5 % fall.
[[nodiscard]] Verdict judge_real_plant(std::span<const JudgedWalk> walks);

/// The walk of `./run`, an arc over boxes, of several seeds.
[[nodiscard]] Verdict judge_first_walk(std::span<const JudgedWalk> walks);

}  // namespace hexagait::experiments

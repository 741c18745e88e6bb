// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/experiments/claim.hpp>
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

/// Constant headings on flat ground.
/// @param reach  of the farthest workspace centre from the base [m]
[[nodiscard]] Verdict judge_headings(std::span<const JudgedWalk> walks, double reach);

/// Straight on, from random postures.
[[nodiscard]] Verdict judge_postures(std::span<const JudgedWalk> walks);

/// A new random heading every second.
[[nodiscard]] Verdict judge_commands(std::span<const JudgedWalk> walks);

/// Straight on over rough ground, as far as asked.
[[nodiscard]] Verdict judge_terrain(std::span<const JudgedWalk> walks);

}  // namespace hexagait::experiments

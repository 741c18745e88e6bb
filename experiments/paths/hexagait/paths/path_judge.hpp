// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/experiments/claim.hpp>
#include <hexagait/walk/paths/path_pilot.hpp>
#include <hexagait/walk/referee/summary.hpp>
#include <string>
#include <vector>

namespace hexagait::experiments {

/// A walk along a path, and how it went.
struct PathWalk {
  std::string shape;    ///< "figure of eight", "square"
  std::string terrain;  ///< "flat", "boxes:0.15"
  std::uint64_t seed = 1;
  walk::LocalisedBy localised_by = walk::LocalisedBy::odometry;
  double look_ahead = 0.0;  ///< [m]
  walk::Summary summary = {};
  std::vector<Vector2> trace = {};  ///< of the base, in the path's frame [m]
};

/// That both shapes are kept, on flat ground and over boxes.
[[nodiscard]] std::vector<Verdict> judge_paths(const std::vector<PathWalk>& walks);

}  // namespace hexagait::experiments

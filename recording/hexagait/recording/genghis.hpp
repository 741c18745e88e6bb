// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <hexagait/sim2d/genghis.hpp>
#include <hexagait/walk/trial.hpp>

namespace hexagait::recording {

/// What only a walk of Genghis in the side view has to tell.
struct SideView {
  sim2d::TerrainSpec2d terrain;
  double underside_time = 0.0;  ///< in which the underside touched the ground: allowed [s]
  int blocked = 0;              ///< times that an advance ran into something
  int searches = 0;             ///< times that no ground was found within reach
};

/// How it went, by ground truth. There is no odometry: its errors are NaN.
struct GenghisSummary : walk::Summary {
  SideView side_view;
};

/// Walks Genghis before the referee of all walks. It is stuck without 2 cm of progress in 30 s: it
/// may take so long to feel its way over a step. Same trial and binary, same bits
/// (real_time_factor apart).
/// @param observer  called after every tick
/// @param stop      once true, the walk ends
/// @throws InvalidInput  if a number is out of range
[[nodiscard]] GenghisSummary simulate(const sim2d::GenghisTrial& trial,
                                      const walk::Observer& observer = {},
                                      const std::atomic<bool>* stop = nullptr);

}  // namespace hexagait::recording

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/math/leg.hpp>
#include <optional>
#include <vector>

namespace hexagait::gait_state {

/// A leg was commanded to lift.
struct TimedLift {
  LegId leg = 0;
  double time = 0.0;  ///< [s]
};

/// Leg lifts before the tripod gait: the number of lifts before the first of four consecutive
/// groups of n/2 lifts that are alternately the one and the other tripod, each lifted within 20 %
/// of a step time. None if that never happens.
[[nodiscard]] std::optional<int> first_tripod_gait(const std::vector<TimedLift>& lifts,
                                                   int num_legs, double step_time);

}  // namespace hexagait::gait_state

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/math/leg.hpp>
#include <optional>
#include <vector>

namespace hexagait::gait_state {

/// The command to lift a leg.
struct TimedLift {
  LegId leg = 0;
  double time = 0.0;  ///< [s]
};

/// Number of lifts before the tripod gait: before the first of four consecutive groups of n/2 lifts
/// that are alternately the first and the second tripod, each lifted within 20 % of a step time.
/// Nothing if there are no such groups.
[[nodiscard]] std::optional<int> first_tripod_gait(const std::vector<TimedLift>& lifts,
                                                   int num_legs, double step_time);

}  // namespace hexagait::gait_state

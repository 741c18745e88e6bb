// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/experiments/experiment.hpp>

#include "terminal/progress.hpp"

namespace hexagait::app {

/// Terrains a height that rough has where it is one experiment of many: all of its own take hours.
inline constexpr std::uint64_t kRoughSeedsOfMany = 10;

/// What every experiment gets, whichever command runs it. It refers to its arguments.
/// @param robot  argos
[[nodiscard]] experiments::ExperimentContext experiment_context(const RobotModel& robot,
                                                                Progress& progress,
                                                                const std::atomic<bool>& stop,
                                                                bool short_form);

}  // namespace hexagait::app

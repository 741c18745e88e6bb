// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/experiments/experiment.hpp>

#include "progress.hpp"

namespace hexagait::app {

/// What every experiment gets, whichever command runs it. It refers to its arguments.
/// @param robot  argos
[[nodiscard]] experiments::ExperimentContext experiment_context(const RobotModel& robot,
                                                                Progress& progress,
                                                                const std::atomic<bool>& stop,
                                                                bool short_form);

}  // namespace hexagait::app

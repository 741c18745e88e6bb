// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/experiments/claim.hpp>
#include <hexagait/figures/csv.hpp>
#include <hexagait/gallery/robot_trial.hpp>
#include <span>

namespace hexagait::experiments {

/// Of those that can stand, nearly all walk straight on, along an arc and in place.
[[nodiscard]] Verdict judge_random_robots(std::span<const RobotTrial> trials);

/// A row for each robot.
[[nodiscard]] figures::Csv table(std::span<const RobotTrial> trials);

}  // namespace hexagait::experiments

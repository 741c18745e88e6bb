// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/figures/figure.hpp>
#include <hexagait/recording/recording.hpp>

namespace hexagait::recording {

/// Draws a walk: from the side, the robot at some instants over the ground under its left and right
/// feet (of a long walk the beginning); the path from above; the gait diagram; height and tilt over
/// time. Writes the figure, and what it was made of: stem.gp and a stem-NAME.csv of each table. The
/// caller has registered stem.suffix.
/// @throws std::runtime_error  if gnuplot fails
void draw_walk(figures::StagedFiles& files, figures::Figure figure, const Recording& recording,
               const RobotModel& robot);

/// The files that draw_walk() writes beside the figure.
[[nodiscard]] std::vector<std::string> walk_figure_files(const std::string& stem);

}  // namespace hexagait::recording

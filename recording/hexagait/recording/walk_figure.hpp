// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/figures/figure.hpp>
#include <hexagait/recording/recording.hpp>

namespace hexagait::recording {

/// Draws a walk in three panels: the path from above, the gait diagram, the body over time. Writes
/// the figure, and what it was made of: stem.gp, stem-body.csv, stem-steps.csv, stem-gait.csv.
/// The caller has registered stem.suffix.
/// @throws std::runtime_error  if gnuplot fails
void draw_walk(figures::StagedFiles& files, const figures::Figure& figure,
               const Recording& recording, const RobotModel& robot);

}  // namespace hexagait::recording

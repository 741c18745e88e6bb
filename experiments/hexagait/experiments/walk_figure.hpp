// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/experiments/recording.hpp>
#include <hexagait/experiments/staged_files.hpp>
#include <string>

namespace hexagait::experiments {

struct WalkFigure {
  std::string stem;    ///< names of all files, without their endings
  std::string suffix;  ///< ".png", ".svg" or ".pdf"
  std::string headline, subtitle;
};

/// Draws a walk in three panels: the path from above, the gait diagram, the body over time. Writes
/// the figure, and what it was made of: stem.gp, stem-body.csv, stem-steps.csv, stem-gait.csv.
/// The caller has registered stem.suffix.
/// @throws std::runtime_error  if gnuplot fails
void draw_walk(StagedFiles& files, const WalkFigure& figure, const Recording& recording,
               const RobotModel& robot);

}  // namespace hexagait::experiments

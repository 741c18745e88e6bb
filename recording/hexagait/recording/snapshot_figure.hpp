// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/figures/staged_files.hpp>
#include <hexagait/recording/recording.hpp>
#include <string>

namespace hexagait::recording {

struct SnapshotFigure {
  std::string stem, headline, subtitle;
  std::vector<double> times;  ///< of the snapshots A, B, C … [s]
  /// Drawn below the robot if it isn't flat.
  const sim3d::Terrain* terrain = nullptr;
};

/// Draws a walk from above, the robot itself at some instants: its body, its legs, where its feet
/// stood. Writes stem.svg, .pdf and .png, and what they were made of: stem.gp, stem-body.csv,
/// stem-steps.csv, stem-outlines.csv, stem-legs.csv, and stem-terrain.csv.
/// @throws std::runtime_error  if gnuplot fails
void draw_snapshots(figures::StagedFiles& files, const SnapshotFigure& figure,
                    const Recording& recording, const RobotModel& robot);

}  // namespace hexagait::recording

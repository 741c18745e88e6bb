// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/figures/figure.hpp>
#include <hexagait/recording/genghis_recording.hpp>

namespace hexagait::recording {

/// Draws a walk of Genghis: from the side, with both ground profiles, the robot at some instants
/// and all footfalls; the gait diagram; height and pitch over time. Of a long walk the first 3 m
/// are seen from the side. Writes the figure, and what it was made of: stem.gp and CSV files.
/// The caller has registered stem.suffix.
/// @throws std::runtime_error  if gnuplot fails
void draw_genghis(figures::StagedFiles& files, const figures::Figure& figure,
                  const GenghisRecording& recording, const sim2d::Terrain2d& terrain);

}  // namespace hexagait::recording

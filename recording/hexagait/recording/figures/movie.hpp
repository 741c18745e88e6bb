// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/figures/staged_files.hpp>
#include <hexagait/recording/recording.hpp>
#include <string>

namespace hexagait::recording {

struct MovieOptions {
  int samples_per_frame = 4;  ///< of Recording::kSampling: 12.5 frames a second
  double seconds = 8.0;       ///< of the walk's end that are shown, at most [s]
};

/// Draws a walk as an animated GIF, in real time: the robot from the side and from above, the way of
/// each foot in the last second, the support polygon, the footprints. Writes stem.gif and what it was
/// made of: movie_files(). The caller has registered stem.gif.
/// @throws std::runtime_error  if gnuplot fails
void draw_movie(figures::StagedFiles& files, const std::string& stem, const Recording& recording,
                const RobotModel& robot, const MovieOptions& options = {});

/// The files that draw_movie() writes beside the picture.
[[nodiscard]] std::vector<std::string> movie_files(const std::string& stem);

}  // namespace hexagait::recording

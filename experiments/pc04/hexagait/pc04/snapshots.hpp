// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/experiments/experiment.hpp>
#include <hexagait/recording/recording.hpp>
#include <hexagait/recording/simulation.hpp>
#include <string>
#include <vector>

namespace hexagait::experiments {

/// A walk that was simulated, and what of it is drawn.
struct RecordedWalk {
  recording::Recording recording;
  walk::Summary summary;
};

/// Simulates the context's robot before the context's spectator, and tells its progress by the walk's
/// time.
[[nodiscard]] RecordedWalk record(const ExperimentContext& context,
                                  const recording::Simulation& simulation);

/// The first sample at this time [s] or later; the last one if there is none.
[[nodiscard]] const recording::Recording::Sample& sample_at(const recording::Recording& recording,
                                                            double time);

/// The longest time between two lifts, also before the first one and after the last [s].
[[nodiscard]] double longest_pause(const recording::Recording& recording);

/// Draws a walk from above, the robot itself at some instants, A, B, C …: its body, its legs, where
/// its feet stood; below it the ground, if that is rough. The figure's size follows from the ground
/// that is seen. Writes it, and what it was made of: stem.gp, stem-body.csv, stem-steps.csv,
/// stem-outlines.csv, stem-legs.csv, stem-snapshots.csv, and stem-terrain.csv.
/// @param times     of the instants [s]
/// @param commands  times at which a command came, each a circle on the path [s]
void draw_snapshots(figures::StagedFiles& files, figures::Figure figure,
                    const std::vector<double>& times, const sim3d::Terrain& terrain,
                    const recording::Recording& recording, const RobotModel& robot,
                    const std::vector<double>& commands = {});

}  // namespace hexagait::experiments

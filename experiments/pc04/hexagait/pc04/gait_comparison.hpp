// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/experiments/walk_checks.hpp>
#include <hexagait/statistics/statistics.hpp>
#include <string>
#include <vector>

namespace hexagait::experiments {

/// Gaits on one ground, trial by trial from the same starts.
template <class Summary>
struct GaitComparison {
  struct Run {
    Summary summary = {};
    double settled_speed = 0.0;  ///< after the transient, in the unit of summary.speed
  };

  std::string terrain;
  std::vector<std::string> gaits = {};      ///< as gait choices are spelt
  std::vector<std::vector<Run>> runs = {};  ///< by gait and trial
  double scale = 1.0;    ///< what speeds are multiplied by to be in the figure's unit
  double seconds = 0.0;  ///< that it took

  /// One value of every trial of a gait.
  template <class Value>
  [[nodiscard]] std::vector<double> each(std::size_t gait, Value value) const {
    return experiments::each(runs[gait], value);
  }
  template <class Value>
  [[nodiscard]] double mean(std::size_t gait, Value value) const {
    return statistics::estimate(each(gait, value)).mean;
  }
  [[nodiscard]] std::vector<double> speeds(std::size_t gait) const {
    return each(gait, [this](const Run& run) { return scale * run.summary.speed; });
  }
  [[nodiscard]] std::vector<double> settled_speeds(std::size_t gait) const {
    return each(gait, [this](const Run& run) { return scale * run.settled_speed; });
  }
  /// Speed of a gait minus that of the first one, trial by trial.
  [[nodiscard]] statistics::Estimate ahead_of_first(std::size_t gait) const {
    return statistics::paired_difference(speeds(gait), speeds(0));
  }
};

}  // namespace hexagait::experiments

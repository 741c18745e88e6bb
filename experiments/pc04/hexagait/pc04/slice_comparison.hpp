// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/figures/figure.hpp>
#include <hexagait/figures/table.hpp>
#include <hexagait/sim2d/slice_model.hpp>
#include <hexagait/statistics/statistics.hpp>

namespace hexagait::experiments {

/// Gaits in the slice model, trial by trial from the same starts over the same ground.
struct SliceComparison {
  struct Run {
    sim2d::SliceSummary summary;
    double settled_speed = 0.0;  ///< mean of the slices after kTransient [units per slice]
  };
  static constexpr int kTrials = 100, kSlices = 500;
  static constexpr int kTransient = 20;  ///< leaves 480 slices, 80 steps of the tripod gait
  static constexpr std::uint64_t kSeed = 1;

  std::string terrain;
  std::vector<std::string> gaits;      ///< as gait choices are spelt
  std::vector<std::vector<Run>> runs;  ///< by gait and trial
  double seconds = 0.0;                ///< that it took

  [[nodiscard]] const std::string& name() const { return terrain; }
  /// One value of every trial of a gait.
  template <class Value>
  [[nodiscard]] std::vector<double> each(std::size_t gait, Value value) const {
    std::vector<double> values;
    for (const Run& run : runs[gait]) values.push_back(value(run));
    return values;
  }
  template <class Value>
  [[nodiscard]] double mean(std::size_t gait, Value value) const {
    return statistics::estimate(each(gait, value)).mean;
  }
  [[nodiscard]] std::vector<double> speeds(std::size_t gait) const;
  [[nodiscard]] std::vector<double> settled_speeds(std::size_t gait) const;
  /// Speed of a gait minus that of the first one, trial by trial.
  [[nodiscard]] statistics::Estimate ahead_of_first(std::size_t gait) const;
};

[[nodiscard]] SliceComparison compare_gaits(const std::vector<std::string>& gaits,
                                            const std::string& terrain);

/// A row per gait: speed with SD and interval, difference to the first gait, S, share of the bound.
[[nodiscard]] figures::Table summary_table(const SliceComparison& comparison);

/// "8.35 ± 0.01": a mean and the half width of its 95 % confidence interval.
[[nodiscard]] std::string spelt(const statistics::Estimate& estimate);

/// What the manifest says of it.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> settings_of(
    const SliceComparison& comparison);

/// Of the figures' subtitles: "100 random starts × 500 slices · …".
[[nodiscard]] std::string described(const SliceComparison& comparison);

/// Draws a figure with a row per gait, by slice_comparison.gp and what comes after it. Writes
/// stem-trials.csv, a row per gait and trial, and stem-means.csv, a row per gait.
void draw_comparison(figures::StagedFiles& files, const figures::Figure& figure,
                     const SliceComparison& comparison, figures::Variables variables,
                     std::string_view script);

}  // namespace hexagait::experiments

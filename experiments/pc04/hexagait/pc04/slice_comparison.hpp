// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/figures/csv.hpp>
#include <hexagait/figures/figure.hpp>
#include <hexagait/pc04/gait_comparison.hpp>
#include <hexagait/sim2d/slice_model.hpp>

namespace hexagait::experiments {

/// Gaits in the slice model; speeds in units per slice.
using SliceComparison = GaitComparison<sim2d::SliceSummary>;

inline constexpr int kSliceTrials = 100, kSlices = 500;
inline constexpr int kSliceTransient = 20;  ///< leaves 480 slices, 80 steps of the tripod gait
inline constexpr std::uint64_t kSliceSeed = 1;

[[nodiscard]] SliceComparison compare_gaits(const std::vector<std::string>& gaits,
                                            const std::string& terrain);

/// A row per ground and gait: speed with SD and interval, difference to the first gait, S, share of
/// the bound.
[[nodiscard]] figures::Csv summary_table(const std::vector<SliceComparison>& comparisons);

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

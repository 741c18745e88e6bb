// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <hexagait/experiments/claim.hpp>
#include <hexagait/figures/csv.hpp>
#include <hexagait/sweep/report.hpp>
#include <span>

namespace hexagait::experiments {

/// The mean of the walks that neither fell nor got stuck, with its 95 % interval; NaN if there are
/// none.
struct RoughMean {
  double value = std::numeric_limits<double>::quiet_NaN();
  double lower = value, upper = value;

  [[nodiscard]] RoughMean times(double factor) const {
    return {value * factor, lower * factor, upper * factor};
  }
};

/// The walks of one controller with one plant over boxes of one height.
struct RoughPoint {
  std::string plant, controller;
  double height = 0.0;  ///< [m]
  statistics::Proportion arrived;
  int fell = 0, stuck = 0, late = 0;  ///< of those that did not arrive; the others failed otherwise
  RoughMean speed = {};               ///< [m/s]
  RoughMean off_path = {};            ///< mean distance from the path [m]
  RoughMean slip = {};                ///< of a stance, 95th percentile [m]
  RoughMean touchdown = {};           ///< speed of touchdowns, 95th percentile [m/s]
  RoughMean cost = {};                ///< of transport
  RoughMean margin = {};              ///< least stability margin [m]
  /// Speed less that of the waiting tripod, of the terrains on which both walked on [m/s].
  RoughMean lead = {};
};

/// Reads the walks of a sweep whose first controller is the waiting tripod.
[[nodiscard]] std::vector<RoughPoint> tally(const std::filesystem::path& sweep);

/// The one of a plant, a controller and a height; null if there is none.
[[nodiscard]] const RoughPoint* point(std::span<const RoughPoint> points, const std::string& plant,
                                      const std::string& controller, double height);

/// A row per point. @param reach  of a leg [m]
[[nodiscard]] figures::Csv table(std::span<const RoughPoint> points, double reach);

/// As Markdown, a table per plant.
[[nodiscard]] std::string page(std::span<const RoughPoint> points, double reach);

/// The free gait arrives, with the ideal plant, over each height that is claimed and was walked.
[[nodiscard]] Verdict judge_success(std::span<const RoughPoint> points);

/// With the plant `real` it arrives as often, but for 3 points.
[[nodiscard]] Verdict judge_real(std::span<const RoughPoint> points);

/// It is as fast as the waiting tripod on each height, and ahead on 15 and 20 cm.
[[nodiscard]] Verdict judge_lead(std::span<const RoughPoint> points);

}  // namespace hexagait::experiments

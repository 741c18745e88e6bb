// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/experiments/claim.hpp>
#include <hexagait/figures/csv.hpp>
#include <hexagait/gallery/robot_trial.hpp>
#include <span>

namespace hexagait::experiments {

/// One walk of one robot of the gallery.
struct GalleryWalk {
  std::string robot, heading;
  double height = 0.0;     ///< of the boxes; 0: flat ground [m]
  std::uint64_t seed = 1;  ///< of the boxes
  WalkEnd end = {};
};

/// A robot of the gallery and its walks.
struct GalleryRobot {
  RobotModel model;
  RobotScale scale;
  double leg_reach = 0.0;  ///< of the longest leg [m]
  double boxes = 0.0;      ///< height of its boxes [m]
  std::vector<GalleryWalk> walks = {};

  /// Those on flat ground, or over boxes.
  [[nodiscard]] std::vector<GalleryWalk> walks_on(bool boxes) const;
};

/// With its measures. Boxes are 15 % of a leg's reach high, for four legs 10 %.
[[nodiscard]] GalleryRobot in_gallery(const RobotModel& model);

/// All of them walk each heading on flat ground.
[[nodiscard]] Verdict judge_flat(std::span<const GalleryRobot> robots);

/// 19 of 20 walks of each arrive, over boxes; of some robots it is declared that they do not.
[[nodiscard]] Verdict judge_boxes(std::span<const GalleryRobot> robots);

/// A row for each walk.
[[nodiscard]] figures::Csv table(std::span<const GalleryRobot> robots);

/// docs/gallery.md.
/// @param plant  on which they walked, as --plant reads it
[[nodiscard]] std::string gallery_page(std::span<const GalleryRobot> robots,
                                       const std::string& plant, bool short_form);

}  // namespace hexagait::experiments

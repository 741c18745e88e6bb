// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/figures/figure.hpp>
#include <hexagait/model/robot_model.hpp>
#include <span>

namespace hexagait::recording {

/// A robot and what stands below its picture.
struct Pictured {
  RobotModel robot;
  std::string caption;
};

/// Draws robots in their nominal stances on one sheet, four in a row: each from above with its front to
/// the right, and from the side, in the same measure. Writes the figure and the tables it was made of.
/// @throws std::runtime_error  if gnuplot fails
void draw_robots(figures::StagedFiles& files, figures::Figure figure,
                 std::span<const Pictured> robots);

}  // namespace hexagait::recording

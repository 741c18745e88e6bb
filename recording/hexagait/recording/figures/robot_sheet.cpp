// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <hexagait/recording/figures/detail/robot_tables.hpp>
#include <hexagait/recording/figures/detail/sheet.hpp>
#include <hexagait/recording/figures/robot_sheet.gp.hpp>
#include <hexagait/recording/figures/robot_sheet.hpp>

namespace hexagait::recording {
namespace {

using detail::kColumns;
using detail::kTitles;
using detail::kWidth;

constexpr int kRobotRow = 420;  // [px]

using figures::Box;
using figures::Panel;

// Robot k's part of the sheet, from above or from the side.
Panel place(int k, int rows, bool above) {
  const int down = k / kColumns;
  const double height = rows * kRobotRow + kTitles;
  const double left = (0.02 + k % kColumns) / kColumns;
  const double top = (height - kTitles - kRobotRow * down) / height, row = kRobotRow / height;
  const double from = above ? 0.42 : 0.13, to = above ? 0.90 : 0.38;
  return {left, left + 0.96 / kColumns, top - (1.0 - from) * row, top - (1.0 - to) * row};
}

}  // namespace

void draw_robots(figures::StagedFiles& files, figures::Figure figure,
                 std::span<const Pictured> robots) {
  const int count = static_cast<int>(robots.size()), rows = (count + kColumns - 1) / kColumns;
  figure.width = kWidth;
  figure.height = rows * kRobotRow + kTitles;
  figures::Variables variables;
  std::vector<std::string> names, captions;
  std::vector<double> grounds;
  for (int k = 0; k < count; ++k) {
    const auto& [robot, caption] = robots[static_cast<std::size_t>(k)];
    figures::write_tables(files, fmt::format("{}-{}", figure.stem, robot.name),
                          {{"above", detail::body_table(robot, 1)},
                           {"side", detail::body_table(robot, 2)},
                           {"legs", detail::legs_table(robot)}});
    const Panel above = place(k, rows, true), side = place(k, rows, false);
    const Box box = detail::bounds(robot, 1);
    const Box shown = box.grown(0.03 * box.size().maxCoeff()).fitted(above, kWidth, figure.height);
    // The side view has the same width, so the same measure.
    const Box from_side = detail::bounds(robot, 2);
    Box low = from_side;
    low.least.x() = shown.least.x();
    low.greatest.x() = shown.greatest.x();
    variables.set(fmt::format("above{}", k + 1), above);
    variables.set(fmt::format("side{}", k + 1), side);
    variables.set(fmt::format("above{}", k + 1), shown);
    variables.set(fmt::format("side{}", k + 1), low.fitted(side, kWidth, figure.height));
    double lowest = 0.0;
    for (const LegModel& leg : robot.legs)
      lowest = std::min(lowest, leg.p_BC.z() - robot.foot_radius);
    names.push_back(robot.name);
    captions.push_back(caption);
    grounds.push_back(lowest);
  }
  variables.set("names", names);
  variables.set("captions", captions);
  variables.set("grounds", grounds);
  draw_figure(files, figure, variables, scripts::recording::robot_sheet);
}

}  // namespace hexagait::recording

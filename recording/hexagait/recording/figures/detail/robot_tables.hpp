// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/figures/csv.hpp>
#include <hexagait/figures/panel.hpp>
#include <hexagait/model/robot_model.hpp>

/// A robot in its nominal stance, as tables for gnuplot. An axis is 1 for y, seen from above, and 2
/// for z, seen from the side.
namespace hexagait::recording::detail {

[[nodiscard]] LegJoints stance_of(const LegModel& leg);

/// Polygons that make up the body: of a cylinder its ends, and what is between them.
[[nodiscard]] figures::Csv body_table(const RobotModel& robot, int axis);

/// A line per leg, from its hip to its foot: leg,x_m,y_m,z_m,foot.
[[nodiscard]] figures::Csv legs_table(const RobotModel& robot);

/// Of body, legs and workspaces [m].
[[nodiscard]] figures::Box bounds(const RobotModel& robot, int axis);

}  // namespace hexagait::recording::detail

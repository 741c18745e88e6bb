// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/figures/figure.hpp>
#include <hexagait/model/robot_model.hpp>

namespace hexagait::recording {

/// Draws what was recognised of a robot, in its nominal stance: from above with front, workspaces and
/// centre of mass; from the side on the ground; and what one leg reaches in its plane. Writes the
/// figure, and what it was made of: stem.gp and a stem-NAME.csv of each table. The caller has
/// registered stem.suffix.
/// @throws std::runtime_error  if gnuplot fails
void draw_robot(figures::StagedFiles& files, figures::Figure figure, const RobotModel& robot);

}  // namespace hexagait::recording

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/model/robot_model.hpp>

namespace hexagait::testing {

/// The robot of most tests, robots/argos.urdf, loaded once in a program.
[[nodiscard]] const RobotModel& argos();

/// @param foot_radius  in place of its own; 0: feet are points [m]
[[nodiscard]] RobotModel argos(double foot_radius);

}  // namespace hexagait::testing

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/model/robot_model.hpp>
#include <hexagait/sim3d/world.hpp>

namespace hexagait::sim3d::detail {

/// @throws InvalidInput  listing all values from which no world can be made
void check(const RobotModel& robot, const WorldParams& params, const LegArray<LegJoints>& q);

}  // namespace hexagait::sim3d::detail

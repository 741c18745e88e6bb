// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/model/robot_model.hpp>
#include <hexagait/recording/simulation.hpp>
#include <string>

namespace hexagait::recording {

/// A walk and how it went.
struct WalkReport {
  std::string robot;  ///< its name
  Simulation simulation;
  walk::Summary summary;
  bool interrupted = false;  ///< stopped by the user
};

/// One JSON object, indented. JSON has no infinity: such a number is null, and lines are given by
/// their curvature.
[[nodiscard]] std::string to_json(const WalkReport& report);

/// What was recognised of a robot, as one JSON object.
[[nodiscard]] std::string to_json(const RobotModel& robot);

}  // namespace hexagait::recording

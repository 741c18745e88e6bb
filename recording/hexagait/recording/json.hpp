// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/model/robot_model.hpp>
#include <hexagait/recording/genghis.hpp>
#include <hexagait/recording/simulation.hpp>
#include <optional>
#include <string>
#include <vector>

namespace hexagait::recording {

/// Of all JSON objects that this project writes: the same name means the same thing in each. Goes
/// up when a name or its meaning changes, not when one is added. See docs/json.md.
inline constexpr int kJsonSchema = 2;

/// A walk and how it went.
struct WalkReport {
  std::string robot;  ///< its name
  Simulation simulation;
  walk::Summary summary;
  std::string hindrance = {};           ///< why it is stuck, in words; empty if it is not
  std::vector<std::string> found = {};  ///< by the controller, about its legs and the ground
  bool interrupted = false;             ///< stopped by the user
  std::optional<SideView> side_view =
      {};  ///< of Genghis: its terrain, not the simulation's, counts
};

/// A walk of Genghis, before it is walked, in the words of all walks.
[[nodiscard]] WalkReport report_of(const sim2d::GenghisTrial& trial);
/// How it went.
void take(WalkReport& report, const GenghisSummary& summary);

/// The ground, as `--terrain` reads it.
[[nodiscard]] std::string terrain_of(const WalkReport& report);

/// One JSON object, indented. JSON has no infinity: such a number is null, and lines are given by
/// their curvature.
/// @param files  that were written
[[nodiscard]] std::string to_json(const WalkReport& report,
                                  const std::vector<std::string>& files = {});

/// What was recognised of a robot, as one JSON object.
[[nodiscard]] std::string to_json(const RobotModel& robot);

}  // namespace hexagait::recording

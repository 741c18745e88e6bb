// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <string>
#include <vector>

namespace hexagait::app {

/// What overrules the recognition of a robot, as it was typed: UrdfOptions. An empty text is an option
/// that was not given.
struct RobotOverrides {
  std::string front, up, scale, foot_radius, mass, density, joint_speed, joint_effort, joint_range;
  std::string legs, body_height, splay;
  std::vector<std::string> feet, packages;
};

/// Adds the options, and where what is typed goes.
void add_robot_overrides(CLI::App& command, RobotOverrides& overrides);

/// What was typed, read. @throws InvalidInput  naming the option, its value, and what would be right
[[nodiscard]] UrdfOptions urdf_options(const RobotOverrides& overrides);

/// The robot of a file, or of a name that comes with hexagait. What of it is substituted, given or
/// left out is said on stderr, unless quiet.
/// @throws InvalidInput
[[nodiscard]] RobotModel load_robot(const std::string& robot, const RobotOverrides& overrides,
                                    bool quiet);

/// Says on stderr what of a robot is substituted, given or left out.
void tell_substitutions(const std::string& robot, const RobotModel& model);

/// What of a robot its file does not say, a line each; what is said of several in the same words is
/// one line. Brief: what differs in numbers only is one line too, and what is derived is left out.
[[nodiscard]] std::vector<std::string> in_words(const std::vector<Substitution>& substitutions,
                                                bool brief);

}  // namespace hexagait::app

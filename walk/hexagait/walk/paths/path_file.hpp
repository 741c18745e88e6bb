// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/model/robot_model.hpp>
#include <hexagait/path_following/pursuit.hpp>
#include <string>

namespace hexagait::walk {

/// Reads a path from a YAML file,
///
///     closed: true             # goes on to the first point after the last; default false
///     shape: spline            # or lines, the default
///     unit: size               # or metres, the default: of the robot's stance, L of scale_of()
///     facing: along            # or keep, car, or an angle
///     speed: 0.1               # bound [m/s], until a point has its own
///     points:
///       - [0, 0]
///       - {x: 2, y: 0.5, facing: 90deg, speed: 0.05}
///
/// as a task for a robot: one lap, with the look-ahead of its stroke. A robot with legs of two joints, which
/// can't crab, follows it as a car.
/// @param step  of the robot: the look-ahead follows from its stroke
/// @throws InvalidInput  with file, line, value and what would be right, for everything that is wrong
[[nodiscard]] path_following::PathTask load_path(const std::string& file, const RobotModel& robot,
                                                 const StepParams& step);

/// The same of a text. @param file  its name, for what is wrong
[[nodiscard]] path_following::PathTask parse_path(const std::string& text, const std::string& file,
                                                  const RobotModel& robot, const StepParams& step);

/// The same of a path that there is already, and that is none from a file.
/// @pre path_following::faults_of() finds none in it
[[nodiscard]] path_following::PathTask task_of(path_following::Path path, const RobotModel& robot,
                                               const StepParams& step);

/// Reads where to face: along, keep, car, points or an angle from x of the path's frame.
/// @throws InvalidInput
[[nodiscard]] path_following::FacingRule parse_facing(const std::string& text);

/// "along", "45°", …; as parse_facing() reads it, but for the angle's unit.
[[nodiscard]] std::string to_string(const path_following::FacingRule& facing);

}  // namespace hexagait::walk

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/heading_control/heading.hpp>
#include <hexagait/model/robot_model.hpp>
#include <optional>
#include <string>
#include <vector>

namespace hexagait::walk {

/// A command and the time from which it holds.
struct TimedCommand {
  double time = 0.0;  ///< [s]
  heading_control::Heading heading = heading_control::Heading::stop();
  /// β: from now on a wave gait of this duty factor; none: the gait stays as it was.
  std::optional<double> duty_factor = {};
};

/// Commands in the order of time, the first at 0.
using Schedule = std::vector<TimedCommand>;

/// The command that holds at a time; the first one before it.
[[nodiscard]] const TimedCommand& command_at(const Schedule& schedule, double time);

/// Reads a schedule from a YAML file: a list of commands, each with its time,
///
///     - {at: 0, radius: inf}                  # straight; crab: 0 if not given
///     - {at: 5, radius: 1.5, crab: 20deg}     # arc to the left
///     - {at: 9, spin: cw}
///     - {at: 12, duty_factor: 0.75}         # a wave gait from now on; the heading stays
///     - {at: 15, radius: -2, duty_factor: 0.5}
///     - {at: 20, stop: true}
///
/// Times, radii and angles are written as for parse_quantity().
/// @throws InvalidInput  with file, line and what would be right, for everything that is wrong
[[nodiscard]] Schedule load_schedule(const std::string& path);

/// A new random heading every `period` seconds: a radius of either sign (uniform curvature up to
/// that of `least_radius` [m], one in ten straight, one in ten a spin) and any crab angle.
[[nodiscard]] Schedule random_schedule(std::uint64_t seed, double period, double seconds,
                                       double least_radius);

/// Radius of the tightest arcs of random schedules for a robot, 0.3 of its size [m].
[[nodiscard]] double tightest_radius(const RobotModel& robot);

/// Reads an angle such as 30deg, 0.5rad or 0.5; at most 2π without a unit. @throws InvalidInput
[[nodiscard]] double parse_angle(const std::string& text);

/// Reads a radius such as 1.5, -80cm or inf: not 0. @throws InvalidInput
[[nodiscard]] double parse_radius(const std::string& text);

}  // namespace hexagait::walk

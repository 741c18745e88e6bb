// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/path_following/path.hpp>
#include <string>
#include <vector>

namespace hexagait::path_following {

/// Why some waypoints are no path for a robot.
struct PathFault {
  std::size_t waypoint = 0;  ///< from 0
  std::string problem;       ///< names the point, what is wrong, and what would be right
};

/// A path that turns by so much within a stride doubles back: no arc joins what is before and after [rad].
inline constexpr double kMostTurn = 2.6;

/// All that is wrong: fewer than two points, of a closed path three; a number that is none; two points
/// in a row at one place; turns of kMostTurn or more within a stride. What is wrong first hides what
/// can't be said without it: while points coincide, turns are not looked at.
/// @param stride  of the robot, more than 0 [m]
[[nodiscard]] std::vector<PathFault> faults_of(const std::vector<Waypoint>& waypoints, Shape shape,
                                               bool closed, double stride);

}  // namespace hexagait::path_following

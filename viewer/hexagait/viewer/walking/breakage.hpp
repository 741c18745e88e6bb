// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/walk/faults/part_faults.hpp>
#include <span>

namespace hexagait::viewer {

/// Faults that a robot may have at once.
inline constexpr std::size_t kMostFaults = 32;
/// The heaviest load, in masses of the robot; and the hardest push, in what gives it a speed of √(g h), with
/// the height h of its body: enough to throw it over, and no more than the simulator bears.
inline constexpr double kMostLoad = 5.0, kMostPush = 5.0;

/// A fault that a page asks for, for this robot: resolved().
/// @param present  that it has already
/// @throws InvalidInput  if it has no such leg or joint, has this fault or too many of them already; for a
///                       load or a push beyond the above
[[nodiscard]] walk::PartFault admitted(walk::PartFault fault,
                                       std::span<const walk::PartFault> present,
                                       const RobotModel& robot);

/// √(g h), with the height h of the robot's body over its feet [m/s].
[[nodiscard]] double falling_speed(const RobotModel& robot);

}  // namespace hexagait::viewer

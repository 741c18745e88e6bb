// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/params/params_for.hpp>
#include <string>

namespace hexagait {

/// The effort of the joint that is nearest to its limit while the robot stands in its stance, a foot
/// under its standing_load().
struct StandingEffort {
  double share = 0.0;  ///< of the joint's limit
  LegId leg = 0;
  int joint = 0;
  double effort = 0.0;  ///< [N m]
};

[[nodiscard]] StandingEffort standing_effort(const RobotModel& robot,
                                             double gravity = kStandardGravity);

/// Puts a robot whose nominal stance leaves little room for a swing, or asks too much of its joints,
/// into the stance in which it walks fastest: the yaw-pitch-pitch legs reach farther out or less far,
/// and the body is higher or lower. Other robots, and serial legs, keep their stance.
[[nodiscard]] RobotModel in_best_stance(const RobotModel& robot);

/// Why the robot can't stand and step in its stance, with numbers; empty if it can.
[[nodiscard]] std::string why_it_cannot_walk(const RobotModel& robot);

}  // namespace hexagait

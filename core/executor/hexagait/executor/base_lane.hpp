// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/executor/commands.hpp>
#include <hexagait/params/robot_params.hpp>

namespace hexagait {

/// The executor's lane of the base: its commanded velocity. A value.
struct BaseLane {
  PlanarTwist planar;     ///< body frame [m/s, rad/s]
  double vertical = 0.0;  ///< along body z [m/s]
  double roll = 0.0;      ///< [rad/s]
  double pitch = 0.0;     ///< [rad/s]

  [[nodiscard]] Twist twist() const {
    return {{planar.v.x(), planar.v.y(), vertical}, {roll, pitch, planar.w}};
  }
};

/// What the base moves besides a path: its velocity less that part that follows the path, ahead.
/// @param arm  of angular velocity [m]: BaseParams::outer_radius
[[nodiscard]] PlanarTwist off_path(const BaseLane& lane, const PlanarTwist& path,
                                   double arm) noexcept;

/// The same motion at another speed.
void scale(BaseLane& lane, double share) noexcept;

/// One tick of the base: towards the goal as fast as the limits of speed and acceleration allow. Motion
/// away from the path, after a sharp change of heading, ends first (base 2).
void advance(BaseLane& lane, const BaseAutoCommand& command, const BaseGoal& goal, double dt,
             const BaseParams& params) noexcept;

/// One tick without a goal: the base brakes to rest, within its limit of acceleration.
void brake(BaseLane& lane, double dt, const BaseParams& params) noexcept;

}  // namespace hexagait

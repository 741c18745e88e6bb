// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/executor/commands.hpp>

namespace hexagait {

/// Limits and gains of the base's motion.
struct BaseParams {
  /// Bound on the acceleration along the path, at the outermost foot [m/s²]. Larger: the
  /// zero-moment point leaves the support triangle and feet lose contact.
  double acceleration = 1.2;
  double max_speed = 0.60;         ///< along the path [m/s]
  double advance_rate = 8.0;       ///< speed over remaining path, near the goal [1/s]
  double correction_rate = 2.0;    ///< speed over deviation from the path [1/s]
  double correction_speed = 0.05;  ///< bound of the correction [m/s]
  double correction_turn = 0.10;   ///< the same [rad/s]
  double posture_rate = 2.0;       ///< speed over error of height, roll and pitch [1/s]
  double height_speed = 0.15;      ///< bound [m/s]
  double tilt_speed = 0.3;         ///< bound [rad/s]
  double outer_radius = 0.8;       ///< lever arm from angular to linear acceleration [m]
};

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

/// One tick of the base: towards the goal as fast as the limits of speed and acceleration allow.
void advance(BaseLane& lane, const BaseAutoCommand& command, const BaseGoal& goal, double dt,
             const BaseParams& params) noexcept;

/// One tick without a goal: the base brakes to rest, within its limit of acceleration.
void brake(BaseLane& lane, double dt, const BaseParams& params) noexcept;

}  // namespace hexagait

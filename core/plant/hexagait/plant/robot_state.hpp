// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/math/geometry.hpp>
#include <hexagait/math/leg.hpp>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/model/robot_model.hpp>
#include <hexagait/plant/inclination.hpp>

namespace hexagait {

/// What the robot rests on when a controller takes it over.
enum class RestsOn : std::uint8_t {
  feet,   ///< it stands: all feet are assumed to be on the ground
  belly,  ///< it lies on level ground: no foot counts as standing
};

/// The controller's estimate of the robot: the measurement and what follows from it.
/// Frames: O odom (z up), B body, F foot (centre of the spherical foot).
struct RobotState {
  double time = 0.0;             ///< [s]
  LegArray<LegJoints> q;         ///< measured joints [rad]
  LegArray<LegTrig> trig;        ///< their sines and cosines
  LegArray<Vector3> p_BF;        ///< measured feet, body frame [m]
  LegArray<bool> contact;        ///< the foot touches something
  Inclination inclination = {};  ///< measured, if there is an inclinometer
  Pose X_OB;                     ///< base in odom, by odometry
  Twist V_B;                     ///< base twist by odometry, body frame [m/s, rad/s]
  LegArray<Vector3> p_OF;        ///< feet in odom; of support legs, their footholds [m]
  LegArray<Vector3> print_O;     ///< last footprint of each foot, in odom [m]
  /// What each foot has slid in all while it stood, in odom: the way of its centre less its rolling.
  /// No legs: it is not known [m].
  LegArray<Vector3> slide_O;
};

}  // namespace hexagait

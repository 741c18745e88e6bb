// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/math/leg.hpp>
#include <hexagait/model/robot_model.hpp>
#include <hexagait/plant/inclination.hpp>
#include <optional>

namespace hexagait {

/// What an inertial measurement unit in the body feels, axes of the body.
struct InertialMeasurement {
  Vector3 acceleration = Vector3::Zero();  ///< less gravity: at rest g, upwards [m/s²]
  Vector3 rate = Vector3::Zero();          ///< angular velocity [rad/s]
};

/// What a robot measures at one instant: its joints, and which feet touch something; with an inertial
/// measurement unit, also what that feels.
struct Measurement {
  double time = 0.0;             ///< the plant's clock [s]
  LegArray<LegJoints> q;         ///< joint positions [rad]
  LegArray<bool> contact;        ///< the foot touches something (load above the sensor's threshold)
  Inclination inclination = {};  ///< if there is an inclinometer
  std::optional<InertialMeasurement> imu = {};
};

/// How a leg's servos are driven.
enum class ControlMode : std::uint8_t {
  position,  ///< to q, with qd and effort fed forward
  velocity,  ///< at qd; q is its integral, for servos with position control only
  effort,    ///< at `effort`; the position is free
};

/// The commands to the robot's servos until the next ones: where the joints are to be at the end of
/// the control period, and the constant velocities that take them there from their last targets.
struct JointTargets {
  LegArray<LegJoints> q;         ///< positions at the end of the period [rad]
  LegArray<LegJoints> qd;        ///< velocities, feed-forward [rad/s]
  LegArray<LegJoints> effort;    ///< efforts, feed-forward (load compensation) [N m]
  LegArray<ControlMode> mode{};  ///< per leg; if of size 0, all are driven by position
};

enum class PlantStatus {
  fresh,   ///< a new measurement
  late,    ///< none arrived in time; the measurement is the previous one
  closed,  ///< the plant is gone or has stopped
};

/// A robot, simulated or real: the only virtual interface of the library. The plant owns the clock:
/// read() waits for the next control period and so paces the loop. See docs/porting.md.
class Plant {
 public:
  virtual ~Plant() = default;

  /// Waits for the next control period and fills `measurement`. Never throws.
  virtual PlantStatus read(Measurement& measurement) = 0;

  /// Sends the targets of this period. Never throws.
  virtual void write(const JointTargets& targets) = 0;
};

}  // namespace hexagait

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/math/leg.hpp>
#include <hexagait/model/robot_model.hpp>

namespace hexagait {

/// What a robot can tell about itself at one instant. Nothing about the world but touch.
struct Measurement {
  double time = 0.0;       ///< the plant's clock [s]
  LegArray<LegJoints> q;   ///< joint positions [rad]
  LegArray<bool> contact;  ///< foot touches something (load above the sensor's threshold)
};

/// How a leg's servos are driven.
enum class ControlMode : std::uint8_t {
  position,  ///< to q, with qd and effort fed forward
  velocity,  ///< qd counts; q is its integral, for servos that know positions only
  effort,    ///< effort counts, the position is free
};

/// What the robot's servos are to do until the next command.
struct JointTargets {
  LegArray<LegJoints> q;         ///< positions [rad]
  LegArray<LegJoints> qd;        ///< velocities, feed-forward [rad/s]
  LegArray<LegJoints> effort;    ///< efforts, feed-forward (load compensation) [N m]
  LegArray<ControlMode> mode{};  ///< per leg; of size 0: all by position
};

enum class PlantStatus {
  fresh,   ///< a new measurement
  late,    ///< none arrived in time; the measurement is the last one
  closed,  ///< the plant is gone or has stopped itself
};

/// A robot, simulated or real: the only virtual interface of the library. The plant owns the clock:
/// read() waits for the next control period and so paces the loop. See docs/porting.md.
class Plant {
 public:
  virtual ~Plant() = default;

  /// Waits for the next control period and fills `measurement`. Never throws.
  virtual PlantStatus read(Measurement& measurement) = 0;

  /// Hands over the targets of this period. Never throws.
  virtual void write(const JointTargets& targets) = 0;
};

}  // namespace hexagait

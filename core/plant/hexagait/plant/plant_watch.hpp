// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/plant/plant.hpp>

namespace hexagait {

/// Why a controller has stopped; it does not move again before the next start().
enum class Fault : std::uint8_t {
  none,
  not_started,      ///< start() has not been called yet
  bad_measurement,  ///< a joint position is no angle, or the number of legs is wrong
  plant_late,       ///< no measurement for longer than the limit
  plant_closed,     ///< the plant is gone
  emergency_stop,   ///< requested by the program
  bad_command,      ///< a command is none, or one or a parameter led to targets that are not finite
};

[[nodiscard]] const char* to_string(Fault fault) noexcept;

/// No joint can be measured farther than this from its zero: 1600 turns [rad].
inline constexpr double kLargestJointAngle = 1e4;

/// Does the measurement have a finite time and the model's number of legs, are all their joint
/// positions within kLargestJointAngle, and what its inertial measurement unit feels is finite?
[[nodiscard]] bool valid(const Measurement& measurement, const RobotModel& model) noexcept;

/// Checks the input of a controller: everything behind it sees only valid, finite measurements.
class PlantWatch {
 public:
  /// @param dt          control period [s]
  /// @param late_limit  longest time without a measurement before a fault [s]
  /// @returns true for a fresh, valid measurement; otherwise the robot must hold
  [[nodiscard]] bool accepts(PlantStatus status, const Measurement& measurement,
                             const RobotModel& model, double dt, double late_limit) noexcept;

  /// Sets a fault, unless there is one already. An emergency stop also ends the coasting of a robot that was
  /// late for too long.
  void stop(Fault fault) noexcept {
    const bool coasts = fault_ == Fault::plant_late && fault == Fault::emergency_stop;
    if (fault_ == Fault::none || coasts) fault_ = fault;
  }

  [[nodiscard]] Fault fault() const { return fault_; }
  [[nodiscard]] bool holding() const { return holding_; }  ///< the last measurement was late

  /// After a measurement that was not accepted: none came, in time or for too long. The controller
  /// coasts. Whatever else is wrong stops the robot at once.
  [[nodiscard]] bool silent() const { return fault_ == Fault::none || fault_ == Fault::plant_late; }

  /// Time from the measurement before to the last one that was accepted [s].
  [[nodiscard]] double elapsed() const { return elapsed_; }

 private:
  Fault fault_ = Fault::none;
  bool holding_ = false;
  double silence_ = 0.0;  ///< time since the last fresh measurement [s]
  double elapsed_ = 0.0;
};

}  // namespace hexagait

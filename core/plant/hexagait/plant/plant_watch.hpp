// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/plant/plant.hpp>

namespace hexagait {

/// Why a controller stands still and will not move again until it is started anew.
enum class Fault : std::uint8_t {
  none,
  bad_measurement,  ///< a joint position that is not finite, or the wrong number of legs
  plant_late,       ///< no measurement for longer than the limit
  plant_closed,     ///< the plant is gone
  emergency_stop,   ///< asked for
};

[[nodiscard]] const char* to_string(Fault fault) noexcept;

/// Complete, and finite for every joint that there is?
[[nodiscard]] bool valid(const Measurement& measurement, const RobotModel& model) noexcept;

/// Lets through what a controller may work with: bad input ends here, and nothing behind it ever
/// sees a number that is not finite.
class PlantWatch {
 public:
  /// @param late_limit  without a measurement for longer there is a fault [s]
  /// @returns true for a fresh, valid measurement; else the robot is to hold
  [[nodiscard]] bool accepts(PlantStatus status, const Measurement& measurement,
                             const RobotModel& model, double dt, double late_limit) noexcept;

  /// The first fault stays.
  void stop(Fault fault) noexcept {
    if (fault_ == Fault::none) fault_ = fault;
  }

  [[nodiscard]] Fault fault() const { return fault_; }
  [[nodiscard]] bool holding() const { return holding_; }  ///< the measurement is late

 private:
  Fault fault_ = Fault::none;
  bool holding_ = false;
  double silence_ = 0.0;  ///< time since the last fresh measurement [s]
};

}  // namespace hexagait

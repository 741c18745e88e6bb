// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/executor/executor.hpp>
#include <hexagait/plant/odometry.hpp>

namespace hexagait {

/// Which sensors the robot has. What is missing is assumed to go as planned: without any the same
/// controller previews what it would do on ground that is as expected.
struct SensorMask {
  bool joint_feedback = true;  ///< without: the targets count as measured
  bool foot_contacts = true;   ///< without: the ground is where and when it was planned
};

/// From what the robot measures to what the controller knows: joints, feet, contacts, odometry.
class StateEstimator {
 public:
  StateEstimator(const RobotModel& model, SensorMask sensors)
      : model_(&model), sensors_(sensors), odometry_(model) {}

  /// The state of a robot that is taken over.
  /// @throws InvalidInput  if a joint position is missing or not finite
  [[nodiscard]] RobotState start(const Measurement& measurement, RestsOn rests_on = RestsOn::feet);

  /// @param measurement  valid()
  /// @param executor     as the last tick left it: what was planned, and which feet to rely on
  void update(RobotState& state, const Measurement& measurement, const Executor& executor,
              double dt) noexcept;

 private:
  const RobotModel* model_;
  SensorMask sensors_;
  Odometry odometry_;
};

}  // namespace hexagait

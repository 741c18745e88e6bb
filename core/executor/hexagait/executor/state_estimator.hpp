// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/executor/executor.hpp>
#include <hexagait/executor/felt_while_held.hpp>
#include <hexagait/executor/gravity_sense.hpp>
#include <hexagait/plant/odometry.hpp>
#include <hexagait/plant/tilt_filter.hpp>

namespace hexagait {

/// Which sensors the robot has. Without a sensor, things are assumed to go as planned; without any,
/// the controller previews what it would do on the expected ground.
struct SensorMask {
  bool joint_feedback = true;  ///< without: joints are assumed to be at their targets
  bool foot_contacts = true;   ///< without: feet touch the ground where and when planned
  bool imu = true;  ///< without, or without measurements of it: up is what odometry takes for it
};

/// Computes the RobotState from measurements: joints, feet, contacts, odometry, tilt. The robot model
/// must outlive the estimator.
class StateEstimator {
 public:
  StateEstimator(const RobotModel& model, SensorMask sensors, const ToleranceParams& tolerance = {})
      : model_(&model),
        sensors_(sensors),
        odometry_(model, tolerance),
        tilt_(odometry_.tolerance().tilt_time) {}
  StateEstimator(const RobotModel&&, SensorMask, const ToleranceParams& = {}) = delete;

  /// The state from which a controller starts.
  /// @throws InvalidInput  if a joint position is missing or not finite
  [[nodiscard]] RobotState start(const Measurement& measurement, RestsOn rests_on = RestsOn::feet);

  /// @param measurement  must be valid()
  /// @param executor     after the previous tick: the plan, and which feet carry load
  /// @param dt           control period [s]
  void update(RobotState& state, const Measurement& measurement, const Executor& executor,
              double dt) noexcept;

 private:
  void feel_gravity(RobotState& state, const Executor& executor, const LegArray<double>& footing,
                    double dt) noexcept;
  [[nodiscard]] bool has_imu(const Measurement& measurement) const {
    return sensors_.imu && measurement.imu.has_value();
  }

  const RobotModel* model_;
  SensorMask sensors_;
  Odometry odometry_;
  TiltFilter tilt_;
  GravitySense gravity_;
  FeltWhileHeld felt_while_held_;
  double since_imu_ = 0.0;  ///< time since its last measurement [s]
};

}  // namespace hexagait

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/executor/executor.hpp>
#include <hexagait/executor/state_estimator.hpp>
#include <hexagait/gait_state/latch.hpp>
#include <hexagait/gait_state/stepper.hpp>
#include <hexagait/model/robot_model.hpp>
#include <hexagait/params/robot_params.hpp>
#include <hexagait/text/violations.hpp>

namespace hexagait::footstep_gen {

/// What is kDerived follows from the robot's model.
struct WalkerParams {
  double control_dt = 0.002;  ///< control period [s], 1 to 20 ms
  SensorMask sensors;
  gait_state::GaitParams gait{.tie_tolerance = kDerived};
  /// Initial gait: free (a wave where the ground is very rough, (step 8)), wave or tripod.
  gait_state::StepperParams stepper;
  StepParams step;
  ExecutorParams executor;
  ToleranceParams tolerance;  ///< its `tie` is not used: that of `gait` is
  double late_limit = 0.1;    ///< longest time without a measurement before it stops [s]
  /// Legs that do not answer are lost, and sensors that are stuck or noisy are not believed: LegWatch.
  bool finds_faults = true;
  /// A robot that does not get on moves its body to where its feet are best used, and tries again from
  /// there: Deadlock. Not of robots that crawl, whose body sways from step to step, nor with legs of two
  /// joints, whose body cannot move sideways.
  bool resolves_deadlocks = true;
};

/// Sets what is kDerived to what follows from the robot's model.
[[nodiscard]] WalkerParams completed(WalkerParams params, const RobotModel& model);

/// The parameters, as they are.
/// @throws InvalidInput  listing all parameters that are out of range
[[nodiscard]] WalkerParams checked(const WalkerParams& params);

/// Adds what is wrong with a choice of gait.
void check_stepping(Violations& violations, const gait_state::StepperParams& stepper);

}  // namespace hexagait::footstep_gen

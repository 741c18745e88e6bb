// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/executor/state_estimator.hpp>
#include <hexagait/plant/plant_watch.hpp>
#include <hexagait/script/sequencer.hpp>

namespace hexagait {

/// What is kDerived follows from the robot's model.
struct RunnerParams {
  double control_dt = 0.002;  ///< control period [s], 1 to 20 ms
  SensorMask sensors;
  SequencerParams sequencer;
  ExecutorParams executor;
  ToleranceParams tolerance;
  double late_limit = 0.1;  ///< longest time without a measurement before it stops [s]
};

/// The desired state of the robot: the output of Free Gait ([FG16] II, "robot desired state").
struct DesiredState {
  LegSet support;                     ///< legs that carry load
  LegArray<Vector3> normal_O;         ///< of the ground under each foot, as expected
  JointTargets targets;               ///< per leg: mode, positions, velocities, efforts
  bool base_follows = false;          ///< the base follows a plan, otherwise it is at rest
  Pose X_OB;                          ///< pose of the base according to the plan, or as estimated
  Twist V_B;                          ///< commanded twist of the base, body frame [m/s, rad/s]
  Vector3 force_O = Vector3::Zero();  ///< of the feet on the base, fed forward [N]
};

/// Everything that one tick of a script computes.
struct ActionRecord {
  Measurement measurement;
  Fault fault = Fault::none;
  bool holding = false;
  RobotState state;
  ActionFeedback feedback;
  ActionResult result;  ///< of the last action that ended
  double margin = 0.0;  ///< stability_margin() of the centre of mass [m]
  LegArray<LegLane> legs;
  DesiredState desired;
  /// Of the virtual model's quadratic program; unless solved, the joints are driven by position in
  /// this tick.
  QpStatus contact_forces = QpStatus::solved;
};

/// Runs scripted actions: takes a measurement and returns joint targets once per control period. It
/// uses the same executor as footstep_gen's Walker.
///
/// The robot model must outlive the runner. A value: a copy can be run ahead. tick() neither throws
/// nor allocates.
class ActionRunner {
 public:
  /// @throws InvalidInput  listing all parameters that are out of range
  explicit ActionRunner(const RobotModel& model, const RunnerParams& params = {});
  explicit ActionRunner(const RobotModel&&, const RunnerParams& = {}) = delete;

  /// Takes the robot over in its present posture. Drops all actions; keeps the frames and the
  /// handler of custom commands.
  /// @throws InvalidInput  if a joint position is missing or not finite
  void start(const Measurement& measurement, RestsOn rests_on = RestsOn::feet);

  // To be called between ticks; see Sequencer.
  void submit(action::Action action, Preemption preemption = Preemption::at_once) {
    sequencer_.submit(std::move(action), preemption, executor_);
  }
  void replace(std::vector<action::Step> steps) { sequencer_.replace(std::move(steps), executor_); }
  void stop(Preemption when = Preemption::at_once) noexcept { sequencer_.stop(when); }
  void pause() noexcept { sequencer_.pause(); }
  void resume() noexcept { sequencer_.resume(); }
  void emergency_stop() noexcept { watch_.stop(Fault::emergency_stop); }
  void handle_custom(CustomHandler handler, void* context) noexcept {
    sequencer_.handle_custom(handler, context);
  }

  /// Poses of map and the registered frames; may be changed between any two ticks.
  [[nodiscard]] Frames& frames() { return frames_; }

  /// One control period. Before start() it only holds the joints where they are measured, with
  /// Fault::not_started.
  const ActionRecord& tick(PlantStatus status, const Measurement& measurement) noexcept;

  [[nodiscard]] bool idle() const { return sequencer_.idle(); }
  [[nodiscard]] const ActionRecord& record() const { return record_; }
  [[nodiscard]] const Executor& executor() const { return executor_; }
  [[nodiscard]] const Sequencer& sequencer() const { return sequencer_; }
  [[nodiscard]] const RobotModel& model() const { return *model_; }
  [[nodiscard]] const RunnerParams& params() const { return params_; }

 private:
  const ActionRecord& wait_for_start(const Measurement& measurement) noexcept;
  void stand_by(double dt) noexcept;
  void report() noexcept;

  const RobotModel* model_;
  RunnerParams params_;
  PlantWatch watch_;
  StateEstimator estimator_;
  Frames frames_;
  Sequencer sequencer_;
  Executor executor_;
  ActionRecord record_;
};

}  // namespace hexagait

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/executor/state_estimator.hpp>
#include <hexagait/plant/plant_watch.hpp>
#include <hexagait/script/sequencer.hpp>

namespace hexagait {

struct RunnerParams {
  double control_dt = 0.002;  ///< control period [s]
  SensorMask sensors;
  SequencerParams sequencer;
  ExecutorParams executor;
  double late_limit = 0.1;  ///< without a measurement for longer, the runner stops for good [s]
};

/// What the robot is to be and do now: the output of Free Gait, "robot desired state" ([FG16] II).
struct DesiredState {
  LegSet support;                     ///< legs that carry
  LegArray<Vector3> normal_O;         ///< of the ground under each foot, as expected
  JointTargets targets;               ///< per leg: mode, positions, velocities, efforts
  bool base_follows = false;          ///< the base is led along a plan, else it is at rest
  Pose X_OB;                          ///< base, where the plan wants it now; else where it is
  Twist V_B;                          ///< commanded twist of the base, body frame [m/s, rad/s]
  Vector3 force_O = Vector3::Zero();  ///< of the feet on the base, fed forward [N]
};

/// Everything that one tick of a script computed.
struct ActionRecord {
  Measurement measurement;
  Fault fault = Fault::none;
  bool holding = false;
  RobotState state;
  ActionFeedback feedback;
  ActionResult result;  ///< of the action that ended last
  double margin = 0.0;  ///< of the centre of mass within the feet that carry [m]
  LegArray<LegLane> legs;
  DesiredState desired;
};

/// Runs scripted actions on a robot: what it senses goes in, joint targets come out, once per
/// control period; the sister of the Walker, on the same executor.
///
/// The robot model must outlive the runner. A value: a copy can be played ahead. tick() neither
/// throws nor allocates.
class ActionRunner {
 public:
  explicit ActionRunner(const RobotModel& model, const RunnerParams& params = {});

  /// Takes the robot over as it stands or lies. Actions are forgotten; frames and the handler of
  /// custom commands stay.
  /// @throws InvalidInput  if a joint position is missing or not finite
  void start(const Measurement& measurement, RestsOn rests_on = RestsOn::feet);

  /// Between ticks.
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

  /// Where map and the registered frames are; may be changed between any two ticks.
  [[nodiscard]] Frames& frames() { return frames_; }

  const ActionRecord& tick(PlantStatus status, const Measurement& measurement) noexcept;

  [[nodiscard]] bool idle() const { return sequencer_.idle(); }
  [[nodiscard]] const ActionRecord& record() const { return record_; }
  [[nodiscard]] const Executor& executor() const { return executor_; }
  [[nodiscard]] const Sequencer& sequencer() const { return sequencer_; }
  [[nodiscard]] const RobotModel& model() const { return *model_; }
  [[nodiscard]] const RunnerParams& params() const { return params_; }

 private:
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

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/balance/support_polygon.hpp>
#include <hexagait/executor/check_params.hpp>
#include <hexagait/script/action_runner.hpp>

namespace hexagait {
namespace {

RunnerParams completed(RunnerParams params, const RobotModel& model) {
  RobotParams all = none_derived();
  all.tolerance = params.tolerance;
  all.script = params.sequencer.planner.script;
  all = hexagait::completed(all, model);
  params.executor = hexagait::completed(params.executor, model);
  params.tolerance = all.tolerance;
  params.sequencer.planner.script = all.script;
  return params;
}

RunnerParams checked_without_reflexes(RunnerParams params, const RobotModel& model) {
  Violations violations("action runner");
  if (model.legs[0].has_two_joints())
    violations.add("robot", "is " + model.name +
                                ", whose legs have two joints: its feet can't go where an action "
                                "puts them; it can walk and be steered");
  check_controller(violations, params.control_dt, params.late_limit, params.executor);
  violations.throw_if_any();
  params.executor.swing.reflexes = false;
  return params;
}

}  // namespace

ActionRunner::ActionRunner(const RobotModel& model, const RunnerParams& params)
    : model_(&model),
      params_(checked_without_reflexes(completed(params, model), model)),
      estimator_(model, params_.sensors, params_.tolerance),
      sequencer_(model, params_.sequencer),
      executor_(model, params_.executor) {
  watch_.stop(Fault::not_started);
  record_.fault = watch_.fault();
  record_.desired.targets = executor_.targets();
}

void ActionRunner::start(const Measurement& measurement, RestsOn rests_on) {
  StateEstimator estimator(*model_, params_.sensors, params_.tolerance);
  // May throw, so before anything changes.
  const RobotState state = estimator.start(measurement, rests_on);
  sequencer_.reset();
  watch_ = {};
  estimator_ = estimator;
  record_ = {};
  record_.measurement = measurement;
  record_.state = state;
  executor_.reset(state, rests_on);
  report();
}

const ActionRecord& ActionRunner::tick(PlantStatus status,
                                       const Measurement& measurement) noexcept {
  const double dt = params_.control_dt;
  if (watch_.accepts(status, measurement, *model_, dt, params_.late_limit)) {
    record_.measurement = measurement;
    estimator_.update(record_.state, measurement, executor_, watch_.elapsed());
    executor_.sense(record_.state, dt);
    sequencer_.update(executor_, record_.state, frames_, dt);
    executor_.advance(record_.state, dt);
    if (executor_.failed()) watch_.stop(Fault::bad_command);
  } else {
    stand_by(dt);
  }
  if (watch_.fault() != Fault::none) sequencer_.give_up();
  if (watch_.fault() == Fault::not_started) return wait_for_start(measurement);
  report();
  return record_;
}

// A tick without a measurement: plans are paused as by pause(), everything else coasts.
void ActionRunner::stand_by(double dt) noexcept {
  if (!watch_.silent()) return executor_.hold();
  sequencer_.coast(executor_, dt);
  executor_.coast(record_.state, dt);
}

const ActionRecord& ActionRunner::wait_for_start(const Measurement& measurement) noexcept {
  record_.fault = watch_.fault();
  record_.desired.targets = executor_.targets();
  if (valid(measurement, *model_)) record_.desired.targets.q = measurement.q;
  return record_;
}

void ActionRunner::report() noexcept {
  record_.fault = watch_.fault();
  record_.holding = watch_.holding();
  record_.feedback = sequencer_.feedback();
  record_.result = sequencer_.result();
  record_.legs = executor_.legs();
  record_.contact_forces = executor_.contact_forces();

  DesiredState& desired = record_.desired;
  const Pose& X_OB = record_.state.X_OB;
  desired.support = executor_.support();
  desired.targets = executor_.targets();
  desired.normal_O = LegArray<Vector3>(model_->num_legs());
  for (LegId i = 0; i < model_->num_legs(); ++i) desired.normal_O[i] = executor_.legs()[i].normal_O;
  desired.base_follows = executor_.base_follows();
  desired.X_OB = desired.base_follows ? executor_.base_planned().X_AB : X_OB;
  desired.V_B = executor_.base().twist();
  desired.force_O = {0.0, 0.0, model_->mass * params_.executor.gravity};
  record_.margin = stability_margin(support_polygon(record_.state.p_OF, desired.support),
                                    (X_OB * model_->p_BM).head<2>());
}

}  // namespace hexagait

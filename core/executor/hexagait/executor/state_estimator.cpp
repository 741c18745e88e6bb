// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/executor/state_estimator.hpp>
#include <hexagait/model/leg_pair.hpp>
#include <hexagait/plant/plant_watch.hpp>
#include <hexagait/text/invalid_input.hpp>

namespace hexagait {
namespace {

// A leg that is gone is found within 6 times the time of a lift (argos, 36 walks), a second one after three times as much.
constexpr double kFound = 8.0, kFoundNext = 24.0;

// Contact without a sensor: at the expected height of the ground.
bool planned_contact(const LegLane& lane, const Pose& X_OB) {
  switch (lane.phase) {
    case LegPhase::support:
    case LegPhase::unload:
    case LegPhase::search:
      return true;
    case LegPhase::descend:
      return (X_OB * lane.p_BF).z() <= lane.step.p_OT.z();
    default:
      return false;
  }
}

// Legs in the air that do not follow their set points. One that is held gives way (give_way() of LegLane), to less than
// blocked_error.
LegSet held_in_air(const Executor& executor) {
  constexpr double kHeld = 0.5;  // of blocked_error
  LegSet held;
  for (LegId i = 0; i < executor.legs().size(); ++i)
    held.set(i, !executor.legs()[i].on_ground() &&
                    executor.tracking_error(i) > kHeld * executor.params().swing.blocked_error);
  return held;
}

}  // namespace

RobotState StateEstimator::start(const Measurement& measurement, RestsOn rests_on) {
  const int n = model_->num_legs();
  if (!valid(measurement, *model_))
    throw InvalidInput("start: the measurement must have a finite position for every joint of " +
                       model_->name);
  RobotState state;
  state.time = measurement.time;
  state.q = LegArray<LegJoints>(n);
  state.contact = LegArray<bool>(n, rests_on == RestsOn::feet);
  state.trig = LegArray<LegTrig>(n);
  state.p_BF = LegArray<Vector3>(n);
  for (LegId i = 0; i < n; ++i) {
    state.q[i] = own_joints(model_->legs[i], measurement.q[i]);
    state.trig[i] = leg_trig(model_->legs[i], state.q[i]);
    state.p_BF[i] = foot_position(model_->legs[i], state.trig[i]);
  }
  odometry_.reset(state, rests_on);
  since_imu_ = 0.0;
  gravity_ = {};
  felt_while_held_ = FeltWhileHeld(n);
  if (has_imu(measurement)) {
    tilt_.reset(*measurement.imu);
    odometry_.level(state, tilt_.up_B(), LegArray<double>(n, 1.0));
  }
  return state;
}

void StateEstimator::update(RobotState& state, const Measurement& measurement,
                            const Executor& executor, double dt) noexcept {
  state.time = measurement.time;
  state.inclination = measurement.inclination;
  for (LegId i = 0; i < model_->num_legs(); ++i) {
    state.q[i] = sensors_.joint_feedback ? own_joints(model_->legs[i], measurement.q[i])
                                         : executor.targets().q[i];
    state.contact[i] = sensors_.foot_contacts ? measurement.contact[i]
                                              : planned_contact(executor.legs()[i], state.X_OB);
  }
  forward_kinematics(*model_, state.q, state.trig, state.p_BF);
  const LegArray<double> footing = executor.footing();
  odometry_.update(state, footing, dt);
  since_imu_ += dt;
  if (!has_imu(measurement)) return feel_gravity(state, executor, footing, dt);
  tilt_.update(*measurement.imu, since_imu_);
  since_imu_ = 0.0;
  odometry_.level(state, tilt_.up_B(), footing);
}

void StateEstimator::feel_gravity(RobotState& state, const Executor& executor,
                                  const LegArray<double>& footing, double dt) noexcept {
  if (!sensors_.joint_feedback || !executor.held_by_set_points()) return;
  LegSet stand, feel;
  for (LegId i = 0; i < model_->num_legs(); ++i) {
    const LegLane& lane = executor.legs()[i];
    stand.set(i, lane.phase == LegPhase::support && lane.believed);
    feel.set(i, lane.phase == LegPhase::support && state.contact[i]);
  }
  const Vector3 felt = gravity_.update(*model_, state, executor.targets(), executor.lost(),
                                       feel.size(), dt, odometry_.tolerance());
  const double found =
      (executor.lost().empty() ? kFound : kFoundNext) * executor.params().swing.lift_time;
  const Vector3 change =
      felt_while_held_.update(felt, held_in_air(executor), stand, executor.lost(), dt, found);
  if (change.isZero()) return;
  const Vector3 up_B = state.X_OB.R.row(2);
  odometry_.level(state, (up_B + change).normalized(), footing);
}

}  // namespace hexagait

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/executor/executor.hpp>
#include <hexagait/model/leg_pair.hpp>

/// The executor's last two stages, joint positions and efforts, and the discrete displacements, which
/// are lines of joint positions.
namespace hexagait {
namespace {

// A set point in the air that is out of reach, or too fast for the joints, goes no farther than the foot
// can; else it would run away from it, and take as long to come back. If it is braking it goes on to: from no
// acceleration it would begin anew each tick, and the shorter the period the less it would brake.
void take_back(LegLane& lane, const Vector3& p_BF, const Pose& X_OB, double dt) {
  lane.v_O += X_OB.R * (p_BF - lane.p_BF) / dt;
  for (int k = 0; k < 3; ++k)
    if (lane.a_O[k] * lane.v_O[k] > 0.0) lane.a_O[k] = 0.0;
  lane.p_BF = p_BF;
}

bool is_zero(const LegJoints& effort) { return effort.cwiseAbs().maxCoeff() < 1e-12; }

}  // namespace

// Does the plan of this leg specify joints, so that the foot follows from them?
bool Executor::led_by_joints(LegId leg) const noexcept {
  const LegPhase phase = legs_[leg].phase;
  return plans_[leg].kind == LegPlan::Kind::joints &&
         (phase == LegPhase::follow || phase == LegPhase::hold);
}

bool Executor::is_discrete() const noexcept {
  return params_.base.displacement_period > 0.0 && !base_follows_ &&
         params_.controller == WholeBodyController::kinematic;
}

// The base's velocity for a whole displacement, and where the joints of the standing legs are at its
// end. If one of them is too slow, all are slower, the base too: they arrive together.
void Executor::begin_displacement(const RobotState& state, double dt) noexcept {
  displacement_.ticks = displacement_ticks(params_.base.displacement_period, dt);
  const double time = displacement_.ticks * dt;
  take_base_on(state, time);
  const auto join_all = [&] {
    double share = 0.0;
    displacement_.legs = displacement_.reachable = {};
    for (LegId i = 0; i < legs_.size(); ++i) {
      if (!legs_[i].on_ground()) continue;
      join_displacement(i, state, time);
      share = std::max(share,
                       speed_share(model_->legs[i], targets_.q[i], displacement_.q_end[i], time));
    }
    return share;
  };
  constexpr int kTries = 4;  // joints and base are nearly proportional
  double share = join_all();
  for (int k = 0; k < kTries && share > 1.0; ++k) {
    scale(base_, 1.0 / share);
    share = join_all();
  }
}

void Executor::join_displacement(LegId leg, const RobotState& state, double time) noexcept {
  const Vector3 roll_arm = model_->foot_radius * state.X_OB.R.row(2).transpose();
  const LegSolution end = joints_after(model_->legs[leg], legs_[leg].p_BF, targets_.q[leg],
                                       trig_[leg], base_.twist(), time, roll_arm);
  displacement_.legs.insert(leg);
  displacement_.reachable.set(leg, end.reachable);
  displacement_.q_end[leg] = end.q;
}

// A leg that has just landed joins in: its set point has been carried on in this tick.
LegSolution Executor::on_its_line(LegId leg, const RobotState& state, double dt) noexcept {
  const int ticks = displacement_.ticks;
  if (!displacement_.legs.contains(leg)) join_displacement(leg, state, (ticks - 1) * dt);
  const LegJoints q = targets_.q[leg] + (displacement_.q_end[leg] - targets_.q[leg]) / ticks;
  return {q, leg_trig(model_->legs[leg], q), displacement_.reachable.contains(leg)};
}

// Joint values for the leg's set point or plan, before the velocity limit.
LegSolution Executor::wanted_joints(LegId leg, const RobotState& state) noexcept {
  const LegModel& model = model_->legs[leg];
  const LegLane& lane = legs_[leg];
  const LegPlan& plan = plans_[leg];
  if (!led_by_joints(leg)) return inverse_kinematics(model, lane.p_BF, targets_.q[leg], trig_[leg]);
  if (lane.phase == LegPhase::hold) return {targets_.q[leg], trig_[leg], true};
  const bool driven = plan.mode == ControlMode::effort;  // its position is free
  const LegJoints asked = driven ? state.q[leg] : plan.joints.at(lane.time).q;
  LegJoints q = asked;
  for (int k = 0; k < model.num_joints(); ++k)
    q[k] = std::clamp(q[k], model.limits[k].lower, model.limits[k].upper);
  return {q, leg_trig(model, q), driven || within_limits(model, asked)};
}

void Executor::set_joints(const RobotState& state, double dt) noexcept {
  LegId i = 0;
  for (; i + 1 < legs_.size(); i += 2) {
    if (pair_goes_on(i, dt)) continue;
    set_joints(i, state, dt);
    set_joints(i + 1, state, dt);
  }
  for (; i < legs_.size(); ++i) set_joints(i, state, dt);
  displacement_.ticks = std::max(0, displacement_.ticks - 1);
}

// Both legs at once, where they just go on: to where they can reach, at a speed that their joints
// allow. Nothing has changed where they do not.
bool Executor::pair_goes_on(LegId first, double dt) noexcept {
  if (displacement_.ticks > 0 || params_.base.displacement_period > 0.0) return false;
  const LegId second = first + 1;
  const LegModel &a = model_->legs[first], &b = model_->legs[second];
  if (a.kind != LegKind::yaw_pitch_pitch || b.kind != LegKind::yaw_pitch_pitch) return false;
  if (led_by_joints(first) || led_by_joints(second)) return false;
  const LegPair pair(a, b);
  LegPair::Angles to;
  const LegPair::Angles near{three_lanes(targets_.q[first], targets_.q[second]),
                             three_lanes(trig_[first].c, trig_[second].c),
                             three_lanes(trig_[first].s, trig_[second].s)};
  if (!pair.go_on(lanes(legs_[first].p_BF, legs_[second].p_BF), near, to)) return false;

  const LaneVector change{to.q.x - near.q.x, to.q.y - near.q.y, to.q.z - near.q.z};
  const auto slow = [&](int k, Lanes turn) {
    return magnitude(turn) <=
           pair.of([k](const LegModel& leg) { return leg.limits[k].velocity; }) * dt;
  };
  if (!all(slow(0, change.x) & slow(1, change.y) & slow(2, change.z))) return false;
  const LaneVector speed{change.x / dt, change.y / dt, change.z / dt};
  const auto take = [&](LegId i, int lane) {
    reachable_[i] = true;
    put(change, lane, last_change_[i]);
    put(to.q, lane, targets_.q[i]);
    put(speed, lane, targets_.qd[i]);
    put(to.c, lane, trig_[i].c);
    put(to.s, lane, trig_[i].s);
    targets_.mode[i] = legs_[i].phase == LegPhase::follow ? plans_[i].mode : ControlMode::position;
  };
  take(first, 0);
  take(second, 1);
  return true;
}

void Executor::set_joints(LegId i, const RobotState& state, double dt) noexcept {
  const LegModel& leg = model_->legs[i];
  if (!legs_[i].on_ground()) displacement_.legs.erase(i);
  const bool stands = displacement_.ticks > 0 && legs_[i].on_ground();
  LegSolution wanted = stands ? on_its_line(i, state, dt) : wanted_joints(i, state);
  reachable_[i] = wanted.reachable;
  const bool planned = legs_[i].phase == LegPhase::follow || led_by_joints(i);
  if (!wanted.reachable && !legs_[i].on_ground() && !planned)
    take_back(legs_[i], foot_position(leg, wanted.trig), state.X_OB, dt);

  // Limit the change to what the servos can do in one tick.
  LegJoints change = wanted.q - targets_.q[i];
  bool limited = false;  // or not a number
  for (int k = 0; k < leg.num_joints(); ++k)
    limited = limited || !(std::abs(change[k]) <= leg.limits[k].velocity * dt);
  if (limited && change.hasNaN()) {
    failed_ = true;
    return;
  }
  if (limited) {
    // In a step all joints slow down together, and the foot stays on its way. A set point that lets go of
    // what blocks its foot jumps, and is not held back.
    const LegLane& lane = legs_[i];
    const bool swings = lane.phase == LegPhase::lift || lane.phase == LegPhase::transfer ||
                        (lane.phase == LegPhase::descend && !lane.regains);
    const bool steps = swings && !leg.has_two_joints();
    double share = 1.0;
    for (int k = 0; k < leg.num_joints(); ++k) {
      const double most = leg.limits[k].velocity * dt;
      if (std::abs(change[k]) > most) share = std::min(share, most / std::abs(change[k]));
      if (!steps) change[k] = std::clamp(change[k], -most, most);
    }
    if (steps) change *= share;
    wanted.q = targets_.q[i] + change;
    wanted.trig = leg_trig(leg, wanted.q);
    if (steps) take_back(legs_[i], foot_position(leg, wanted.trig), state.X_OB, dt);
  }
  last_change_[i] = change;
  targets_.q[i] = wanted.q;
  targets_.qd[i] = change / dt;
  trig_[i] = wanted.trig;
  if (led_by_joints(i)) {
    const Vector3 p_BF = foot_position(leg, trig_[i]);
    legs_[i].v_O = state.X_OB.R * (p_BF - legs_[i].p_BF) / dt;
    legs_[i].p_BF = p_BF;
  }
  // A foot that slides to the side is where it is.
  if (leg.has_two_joints() && legs_[i].on_ground()) legs_[i].p_BF = foot_position(leg, trig_[i]);
  targets_.mode[i] = legs_[i].phase == LegPhase::follow ? plans_[i].mode : ControlMode::position;
}

void Executor::set_efforts(const RobotState& state, double dt) noexcept {
  const int n = legs_.size();
  WholeBodyInput input{.q = targets_.q,
                       .trig = trig_,
                       .p_BF = LegArray<Vector3>(n),
                       .load = LegArray<double>(n),
                       .R_OB = state.X_OB.R,
                       .p_BM = p_BM(),
                       .normal_B = {},
                       .error = base_error_};
  const bool virtual_model = params_.controller == WholeBodyController::virtual_model;
  if (virtual_model) input.normal_B = LegArray<Vector3>(n);
  for (LegId i = 0; i < n; ++i) {
    input.p_BF[i] = legs_[i].p_BF;
    input.load[i] = legs_[i].load;
    if (virtual_model) input.normal_B[i] = state.X_OB.R.transpose() * legs_[i].normal_O;
  }
  JointEfforts efforts =
      joint_efforts(params_.controller, *model_, input, params_.gravity, params_.virtual_model);
  contact_forces_ = efforts.status;
  const bool solved = efforts.status == QpStatus::solved;
  if (!solved)
    efforts = joint_efforts(WholeBodyController::kinematic, *model_, input, params_.gravity,
                            params_.virtual_model);

  for (LegId i = 0; i < n; ++i) {
    // The efforts of a plan in effort mode replace these; standing legs belong to the controller.
    if (virtual_model) {
      if (targets_.mode[i] == ControlMode::effort) efforts.effort[i].setZero();
      if (legs_[i].on_ground() && solved) targets_.mode[i] = ControlMode::effort;
    }
    const bool planned = legs_[i].phase == LegPhase::follow || adds_effort_.contains(i);
    if (planned) add_planned_efforts(i, efforts.effort[i], state, dt);
    set_effort(i, efforts.effort[i]);
  }
}

// Efforts that a plan adds are ramped.
void Executor::add_planned_efforts(LegId leg, LegJoints& effort, const RobotState& state,
                                   double dt) noexcept {
  const LegJoints wish = planned_effort(leg, state);
  LegJoints& planned = planned_effort_[leg];
  if (is_zero(wish) && is_zero(planned)) return;
  for (int k = 0; k < model_->legs[leg].num_joints(); ++k) {
    const double limit = model_->legs[leg].limits[k].effort,
                 most = limit * dt / params_.swing.effort_time;
    const double change = std::clamp(wish[k], -limit, limit) - planned[k];
    planned[k] += std::clamp(change, -most, most);
  }
  adds_effort_.set(leg, !is_zero(planned));
  effort += planned;
}

// Within the joints' limits; the last ones if one is not a number.
void Executor::set_effort(LegId leg, const LegJoints& effort) noexcept {
  if (effort.hasNaN()) {
    failed_ = true;
    return;
  }
  const JointArray<JointLimits>& limits = model_->legs[leg].limits;
  LegJoints& target = targets_.effort[leg];
  for (int k = 0; k < limits.size(); ++k) {
    const double most = limits[k].effort;
    target[k] = std::min(std::max(effort[k], -most), most);
  }
}

LegJoints Executor::planned_effort(LegId leg, const RobotState& state) const noexcept {
  const LegPlan& plan = plans_[leg];
  if (legs_[leg].phase != LegPhase::follow) return LegJoints::Zero();
  if (plan.kind == LegPlan::Kind::joints) return plan.joints.effort_at(legs_[leg].time);
  if (plan.force_O.isZero()) return LegJoints::Zero();
  return foot_effort(model_->legs[leg], trig_[leg], state.X_OB.R.transpose() * plan.force_O);
}

}  // namespace hexagait

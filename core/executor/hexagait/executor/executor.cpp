// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/executor/executor.hpp>
#include <hexagait/executor/tick_motion.hpp>
#include <limits>

namespace hexagait {
namespace {

// A plan that ends faster than this expects another one to follow [m/s], [rad/s].
constexpr double kMoving = 1e-6;

// A descent is long from this share of SwingParams::search_time on.
constexpr double kLongDescent = 0.5;

}  // namespace

ExecutorParams completed(ExecutorParams params, const RobotModel& model) {
  RobotParams all = none_derived();
  all.swing = params.swing;
  all.base = params.base;
  all.spring = {params.virtual_model.frequency, params.virtual_model.turn_frequency};
  all = hexagait::completed(all, model);
  params.swing = all.swing;
  params.base = all.base;
  params.virtual_model.frequency = all.spring.frequency;
  params.virtual_model.turn_frequency = all.spring.turn_frequency;
  return params;
}

Executor::Executor(const RobotModel& model, const ExecutorParams& params)
    : model_(&model),
      params_(completed(params, model)),
      stance_(nominal_stance(model)),
      legs_(model.num_legs()),
      trig_(model.num_legs()),
      last_change_(model.num_legs(), LegJoints::Zero()),
      reachable_(model.num_legs(), true),
      lag_(model.num_legs(), params_.swing.lag_speed),
      footholds_(model.num_legs()),
      off_(model.num_legs(), Vector3::Zero()),
      plans_(model.num_legs()),
      planned_effort_(model.num_legs(), LegJoints::Zero()) {
  const LegArray<LegJoints> zero(model.num_legs(), LegJoints::Zero());
  displacement_.q_end = zero;
  targets_ = {zero, zero, zero, LegArray<ControlMode>(model.num_legs(), ControlMode::position)};
}

void Executor::reset(const RobotState& state, RestsOn rests_on) {
  const int foot_knots = foot_knots_, joint_knots = joint_knots_, base_knots = base_knots_;
  const Stance stance = stance_;
  const LegSet lost = lost_;
  *this = Executor(*model_, params_);
  stance_ = stance;
  reserve(foot_knots, joint_knots, base_knots);
  for (LegId i = 0; i < legs_.size(); ++i) {
    if (rests_on == RestsOn::belly) {
      legs_[i].phase = LegPhase::hold;
      legs_[i].load = 0.0;
    }
    legs_[i].p_BF = state.p_BF[i];
    legs_[i].with_contact = params_.swing.touch_time;  // it has stood
    lag_.restart(i, state.p_BF[i]);
    trig_[i] = state.trig[i];
  }
  for (LegId i = 0; i < legs_.size(); ++i)
    if (lost.contains(i)) lose(i);
  footholds_.watch(state.slide_O, {}, params_.swing.slide_time, params_.swing);
  targets_.q = state.q;
  X_OD_ = state.X_OB;
}

void Executor::command(const FootstepCommand& step, const RobotState& state) noexcept {
  if (lost_.contains(step.leg)) return;
  hexagait::command(legs_[step.leg], step, state.X_OB);
}

void Executor::reserve(int foot_knots, int joint_knots, int base_knots) {
  foot_knots_ = std::max(foot_knots_, foot_knots);
  joint_knots_ = std::max(joint_knots_, joint_knots);
  base_knots_ = std::max(base_knots_, base_knots);
  for (LegPlan& plan : plans_) {
    plan.foot.reserve(foot_knots_);
    plan.joints.reserve(joint_knots_);
  }
  base_plan_.curve.reserve(base_knots_);
}

void Executor::command(LegId leg, const LegPlan& plan, const RobotState& state,
                       double begin) noexcept {
  if (lost_.contains(leg)) return;
  plans_[leg] = plan;
  // A leg that was driven by effort starts from where it is.
  if (targets_.mode[leg] == ControlMode::effort) legs_[leg].p_BF = state.p_BF[leg];
  hexagait::command(legs_[leg], plans_[leg], state.X_OB);
  if (legs_[leg].phase != LegPhase::follow) return;
  legs_[leg].time = begin;
  legs_[leg].p_plan = plan.foot.at(begin).p;
}

void Executor::command(const BasePlan& plan, double begin) noexcept {
  base_plan_ = plan;
  base_time_ = begin;
  base_planned_ = base_plan_.curve.at(begin);
  base_follows_ = true;
}

void Executor::interrupt_base() noexcept {
  base_follows_ = false;
  base_command_ = {};
}

void Executor::sense(const RobotState& state, double dt) noexcept {
  for (LegId i = 0; i < legs_.size(); ++i)
    hexagait::sense(legs_[i], state.contact[i], dt, params_.swing);
  LegSet stand;
  for (LegId i = 0; i < legs_.size(); ++i)
    stand.set(i, legs_[i].phase == LegPhase::support && legs_[i].believed &&
                     !model_->legs[i].has_two_joints());
  footholds_.watch(state.slide_O, stand, dt, params_.swing);
  sensed_ = true;
}

const JointTargets& Executor::advance(const RobotState& state, double dt) noexcept {
  if (!sensed_) sense(state, dt);
  sensed_ = false;
  failed_ = failed_ || !(0.0 < dt && dt < std::numeric_limits<double>::infinity());
  if (!failed_) move(state, dt);
  if (failed_) hold();
  return targets_;
}

void Executor::move(const RobotState& state, double dt) noexcept {
  move_base(state, dt);          // twist of the base
  update_base_error(state, dt);  // its error from the plan, for the virtual model
  note_tracking(state, dt);      // errors of the feet, before their set points move on
  carry_with_ground(state, dt);  // set points of the feet, as the base moves over the ground
  even_out_loads(state, dt);     // set points of the feet that stand
  move_legs(state, dt);          // motion of the feet over the ground
  set_joints(state, dt);
  set_efforts(state, dt);
}

void Executor::move_base(const RobotState& state, double dt) noexcept {
  if (!is_discrete()) {
    displacement_.ticks = 0;
    return base_follows_ ? follow_base(state, dt) : take_base_on(state, dt);
  }
  if (displacement_.ticks == 0) begin_displacement(state, dt);
}

// The base's velocity for the next dt.
void Executor::take_base_on(const RobotState& state, double dt) noexcept {
  base_goal_ = base_command_.adaptation
                   ? base_command_.adaptation(base_command_, pose_adaptation_input(state))
                   : BaseGoal{};
  const BaseLane before = base_;
  hexagait::advance(base_, base_command_, base_goal_, dt, params_.base);
  if (!drags_a_foot() && !runs_from_a_foot()) return;
  base_ = before;
  brake(base_, dt, params_.base);
}

// Would the base take a standing foot farther away whose leg is at its end already?
bool Executor::drags_a_foot() const noexcept {
  const Twist V = base_.twist();
  for (LegId i = 0; i < legs_.size(); ++i) {
    if (legs_[i].phase != LegPhase::support || reachable_[i]) continue;
    const Vector3 from_hip = legs_[i].p_BF - model_->legs[i].X_BH.p;
    if (from_hip.dot(V.v + V.w.cross(legs_[i].p_BF)) < 0.0) return true;
  }
  return false;
}

// (executor 4). The feet of legs of two joints slide as the body tilts, and friction may keep it from following its
// command. A foot in the air is carried by that command all the same, and may never come down.
bool Executor::runs_from_a_foot() const noexcept {
  if (!model_->legs[0].has_two_joints()) return false;
  for (const LegLane& lane : legs_)
    if (lane.phase == LegPhase::descend && lane.time > kLongDescent * params_.swing.search_time)
      return true;
  return false;
}

// The twist of the plan, plus a correction of the error that odometry sees.
void Executor::follow_base(const RobotState& state, double dt) noexcept {
  const double begin = base_time_, end = base_plan_.curve.duration();
  base_time_ = std::min(begin + rate_ * dt, end);
  const BaseState now = base_planned_;
  base_planned_ = base_plan_.curve.at(base_time_);
  const double share = (base_time_ - begin) / dt;

  // A plan that ended in motion, with no other to follow it: brake.
  if (begin >= end && (now.V_B.v.norm() > kMoving || now.V_B.w.norm() > kMoving)) {
    interrupt_base();
    return move_base(state, dt);
  }

  const Matrix3 R_BD = state.X_OB.R.transpose() * now.X_AB.R;
  const BaseParams& p = params_.base;
  const double rate = decay_share(p.correction_rate * dt) / dt;
  Vector3 v = rate * (state.X_OB.R.transpose() * (now.X_AB.p - state.X_OB.p));
  Vector3 w = rate * rotation_vector(R_BD);
  if (v.norm() > p.correction_speed) v *= p.correction_speed / v.norm();
  if (w.norm() > p.correction_turn) w *= p.correction_turn / w.norm();
  // The trapezoidal rule. If the plan ends within this tick, the rest of the tick has its last
  // twist.
  const Twist& last = base_planned_.V_B;
  const double rest = rate_ - 0.5 * share;
  v += R_BD * (0.5 * share * now.V_B.v + rest * last.v);
  w += R_BD * (0.5 * share * now.V_B.w + rest * last.w);
  base_ = {{v.head<2>(), w.z()}, v.z(), w.x(), w.y()};
}

void Executor::update_base_error(const RobotState& state, double dt) noexcept {
  if (params_.controller != WholeBodyController::virtual_model) return;
  Twist V_D = base_.twist();
  if (base_follows_) {
    X_OD_ = base_planned_.X_AB;
    V_D = {rate_ * base_planned_.V_B.v, rate_ * base_planned_.V_B.w};
  } else {
    X_OD_.p += X_OD_.R * (V_D.v * dt);
    X_OD_.R = orthonormalised(X_OD_.R * rotation(V_D.w * dt));
  }
  base_error_ = base_error(state.X_OB, state.V_B, X_OD_, V_D);
}

// Feet on the line of a discrete displacement are meant to be beside their set points, and so are
// those of legs of two joints.
void Executor::note_tracking(const RobotState& state, double dt) noexcept {
  for (LegId i = 0; i < legs_.size(); ++i) {
    const LegModel& leg = model_->legs[i];
    const bool on_line = displacement_.ticks > 0 && displacement_.legs.contains(i);
    const bool beside = on_line || leg.has_two_joints();
    const Vector3 p_BF = beside ? foot_position(leg, trig_[i]) : legs_[i].p_BF;
    lag_.watch(i, state.p_BF[i], p_BF, !legs_[i].on_ground(), dt);
    off_[i] = state.p_BF[i] - p_BF;
  }
}

// As advance(), without what decides. A discrete displacement ends: the base brakes smoothly.
const JointTargets& Executor::coast(const RobotState& state, double dt) noexcept {
  if (!failed_) go_on(state, dt);
  if (failed_) hold();
  return targets_;
}

void Executor::go_on(const RobotState& state, double dt) noexcept {
  displacement_.ticks = 0;
  if (base_follows_)
    follow_base(state, dt);
  else
    brake(base_, dt, params_.base);
  for (LegId i = 0; i < legs_.size(); ++i) lag_.go_on(i, legs_[i].p_BF, dt);
  carry_with_ground(state, dt);
  for (LegId i = 0; i < legs_.size(); ++i) {
    if (legs_[i].phase == LegPhase::follow)
      follow(legs_[i], plans_[i], {.contact = !legs_[i].cleared}, state.X_OB, dt, rate_,
             params_.swing);
    else
      hexagait::coast(legs_[i], state.X_OB, dt, params_.swing);
  }
  set_joints(state, dt);
  set_efforts(state, dt);
}

void Executor::hold() noexcept {
  base_ = {};
  displacement_.ticks = 0;
  base_command_ = {};
  for (LegLane& lane : legs_) {
    lane.v_O.setZero();
    lane.a_O.setZero();
  }
  for (LegJoints& qd : targets_.qd) qd.setZero();
  // Constant efforts would not hold the robot: servo all joints.
  for (LegId i = 0; i < legs_.size(); ++i) targets_.mode[i] = ControlMode::position;
  for (LegJoints& change : last_change_) change.setZero();  // no foot rolls
}

LegSet Executor::unsure() const noexcept {
  LegSet unsure;
  for (LegId i = 0; i < legs_.size(); ++i) {
    const LegLane& lane = legs_[i];
    const bool touches =
        lane.without_contact <= 0.0 && elapsed(lane.with_contact, params_.swing.touch_time);
    unsure.set(i, lane.supports(params_.swing) && (!touches || giving_way().contains(i)));
  }
  return unsure;
}

LegArray<double> Executor::footing() const noexcept {
  LegArray<double> footing(legs_.size());
  for (LegId i = 0; i < legs_.size(); ++i) {
    const LegLane& lane = legs_[i];
    footing[i] = lane.on_ground() && lane.believed && lane.without_contact <= 0.0 ? lane.load : 0.0;
  }
  return footing;
}

PoseAdaptationInput Executor::pose_adaptation_input(const RobotState& state) const noexcept {
  const int n = legs_.size();
  PoseAdaptationInput input{
      LegArray<Vector3>(n), LegArray<Vector3>(n), LegArray<Vector3>(n), support(), lost_, {}};
  const Pose X_BO = state.X_OB.inverse();
  for (LegId i = 0; i < n; ++i) {
    input.p_BF[i] = lost_.contains(i) ? stance_.p_BC[i] : legs_[i].p_BF;
    input.p_BC[i] = stance_.p_BC[i];
    input.footprint_BF[i] = X_BO * state.print_O[i];
    input.blocked.set(i, legs_[i].retreats > 0 && !legs_[i].on_ground() && !lost_.contains(i));
    // A foot below its last footprint still has no ground: lower the body towards it.
    const double deeper = input.footprint_BF[i].z() - legs_[i].p_BF.z();
    if (legs_[i].phase == LegPhase::descend && deeper > 0.0)
      input.footprint_BF[i].z() -= base_command_.lowering * deeper;
  }
  return input;
}

// (executor 1), accurate to second order in the motion of one tick, and the rolling of spherical
// feet (odometry 2), which moves the centre of a standing foot while its contact point stands.
void Executor::carry_with_ground(const RobotState& state, double dt) noexcept {
  const Twist V = base_.twist();
  const Vector3 turn = V.w * dt;
  const Vector3 roll_arm = model_->foot_radius * state.X_OB.R.row(2).transpose();
  const bool by_effort = params_.controller == WholeBodyController::virtual_model &&
                         contact_forces_ == QpStatus::solved;
  for (LegId i = 0; i < legs_.size(); ++i) {
    if (!legs_[i].with_ground()) continue;
    Vector3& p = legs_[i].p_BF;
    // The set point of a foot driven by effort is its measured position.
    if (by_effort && legs_[i].on_ground()) p = state.p_BF[i];
    const Vector3 shift = -(V.v * dt + turn.cross(p));
    p += shift - 0.5 * turn.cross(shift);
    if (legs_[i].on_ground())
      p += (turn + tibia_turn(model_->legs[i], trig_[i], last_change_[i])).cross(roll_arm);
  }
}

}  // namespace hexagait

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/core/executor.hpp>
#include <hexagait/core/load_sharing.hpp>
#include <limits>

namespace hexagait {

Executor::Executor(const RobotModel& model, const ExecutorParams& params)
    : model_(&model),
      params_(params),
      legs_(model.num_legs()),
      trig_(model.num_legs()),
      last_change_(model.num_legs(), LegJoints::Zero()),
      reachable_(model.num_legs(), true) {
  const LegArray<LegJoints> zero(model.num_legs(), LegJoints::Zero());
  targets_ = {zero, zero, zero};
}

void Executor::reset(const RobotState& state) {
  *this = Executor(*model_, params_);
  for (LegId i = 0; i < legs_.size(); ++i) {
    legs_[i].p_BF = state.p_BF[i];
    trig_[i] = state.trig[i];
  }
  targets_.q = state.q;
}

void Executor::command(const Footstep& step, const RobotState& state) noexcept {
  hexagait::command(legs_[step.leg], step, state.X_OB);
}

const JointTargets& Executor::advance(const RobotState& state, double dt) noexcept {
  // The base: where should it go, and how fast can it?
  base_goal_ = base_command_.adaptation
                   ? base_command_.adaptation(base_command_, pose_adaptation_input(state))
                   : BaseGoal{};
  hexagait::advance(base_, base_command_, base_goal_, dt, params_.base);
  carry_with_ground(state, dt);

  // The legs: what each does over the ground.
  for (LegId i = 0; i < legs_.size(); ++i) {
    const LegSensed sensed{state.contact[i], (state.p_BF[i] - legs_[i].p_BF).norm(), reachable_[i]};
    hexagait::advance(legs_[i], sensed, state.X_OB, dt, params_.swing);
  }

  set_joints(dt);
  set_efforts(state);
  return targets_;
}

void Executor::hold() noexcept {
  base_ = {};
  base_command_ = {};
  for (LegLane& lane : legs_) {
    lane.v_O.setZero();
    lane.a_O.setZero();
  }
  for (LegJoints& qd : targets_.qd) qd.setZero();
  for (LegJoints& change : last_change_) change.setZero();  // nothing rolls on
}

LegSet Executor::support() const noexcept {
  LegSet support;
  for (LegId i = 0; i < legs_.size(); ++i) support.set(i, legs_[i].supports(params_.swing));
  return support;
}

LegArray<double> Executor::footing() const noexcept {
  LegArray<double> footing(legs_.size());
  for (LegId i = 0; i < legs_.size(); ++i) {
    const LegLane& lane = legs_[i];
    footing[i] = lane.on_ground() && lane.without_contact <= 0.0 ? lane.load : 0.0;
  }
  return footing;
}

PoseAdaptationInput Executor::pose_adaptation_input(const RobotState& state) const noexcept {
  const int n = legs_.size();
  PoseAdaptationInput input{LegArray<Vector3>(n), LegArray<Vector3>(n), LegArray<Vector3>(n),
                            support()};
  const Pose X_BO = state.X_OB.inverse();
  for (LegId i = 0; i < n; ++i) {
    input.p_BF[i] = legs_[i].p_BF;
    input.p_BC[i] = model_->legs[i].p_BC;
    input.footprint_BF[i] = X_BO * state.print_O[i];
    // A foot that finds no ground where it was expected: let the body come down to it.
    if (legs_[i].phase == LegPhase::descend)
      input.footprint_BF[i].z() = std::min(input.footprint_BF[i].z(), legs_[i].p_BF.z());
  }
  return input;
}

// (executor 1), exact to second order in one tick's motion; and the rolling of spherical feet
// (odometry 2), by which the centre of a standing foot moves though its contact does not.
void Executor::carry_with_ground(const RobotState& state, double dt) noexcept {
  const Twist V = base_.twist();
  const Vector3 turn = V.w * dt;
  const Vector3 roll_arm = model_->foot_radius * state.X_OB.R.row(2).transpose();
  for (LegId i = 0; i < legs_.size(); ++i) {
    Vector3& p = legs_[i].p_BF;
    const Vector3 shift = -(V.v * dt + turn.cross(p));
    p += shift - 0.5 * turn.cross(shift);
    if (legs_[i].on_ground())
      p += (turn + tibia_turn(model_->legs[i], trig_[i], last_change_[i])).cross(roll_arm);
  }
}

void Executor::set_joints(double dt) noexcept {
  for (LegId i = 0; i < legs_.size(); ++i) {
    const LegSolution solution = inverse_kinematics(model_->legs[i], legs_[i].p_BF);
    last_change_[i] = solution.q - targets_.q[i];
    targets_.q[i] = solution.q;
    targets_.qd[i] = last_change_[i] / dt;
    trig_[i] = solution.trig;
    reachable_[i] = solution.reachable;
  }
}

// Each standing foot presses down with its share of the weight: τ = Jᵀ (−F up).
void Executor::set_efforts(const RobotState& state) noexcept {
  const Vector3 up_B = state.X_OB.R.row(2);
  LegArray<Vector3> p_F(legs_.size());
  LegArray<double> share(legs_.size());
  for (LegId i = 0; i < legs_.size(); ++i) {
    p_F[i] = legs_[i].p_BF;
    share[i] = legs_[i].load;
  }
  const LegArray<double> force =
      shared_load(p_F, model_->p_BM, share, model_->mass * params_.gravity);
  for (LegId i = 0; i < legs_.size(); ++i) {
    targets_.effort[i].setZero();
    if (force[i] > 0.0)
      targets_.effort[i] =
          foot_jacobian(model_->legs[i], trig_[i]).transpose() * (-force[i] * up_B);
  }
}

}  // namespace hexagait

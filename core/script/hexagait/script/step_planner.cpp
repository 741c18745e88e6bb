// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <bit>
#include <cmath>
#include <hexagait/balance/support_polygon.hpp>
#include <hexagait/executor/tick_motion.hpp>
#include <hexagait/script/step_planner.hpp>

namespace hexagait {
namespace {

// A base that is turned by more than this from its plan starts from its estimated pose instead [rad].
constexpr double kNearTurn = 0.03;

// Legs that the commands of a step lift.
LegSet lifted_by(const action::Step& step) {
  LegSet legs;
  for (const action::LegCommand& command : step.legs) {
    const auto* mode = std::get_if<action::LegMode>(&command.motion);
    if (!mode || !mode->support_leg) legs.insert(leg_motion(command).leg);
  }
  return legs;
}

// Legs without which a BaseAuto of `step` must stand: those that it lifts, or else the next step.
LegSet lifted_from(const action::Step& step, const action::Step* next) {
  const LegSet lifted = lifted_by(step);
  return lifted.empty() && next ? lifted_by(*next) : lifted;
}

LegSet ignored_by(const action::Step& step) {
  LegSet legs;
  for (const action::LegCommand& command : step.legs)
    if (leg_motion(command).ignore_for_pose_adaptation) legs.insert(leg_motion(command).leg);
  return legs;
}

LegId first_of(LegSet legs) { return legs.empty() ? -1 : std::countr_zero(legs.bits()); }

// Start of a base motion: the end of the last plan, unless something has moved the base away.
BaseState start_of_base(const StepStart& start, double near_plan) {
  BaseState from{start.state.X_OB, start.executor.base().twist()};
  if (!start.executor.base_follows()) return from;
  const BaseState& planned = start.executor.base_planned();
  const Pose& X_OD = planned.X_AB;
  const bool near = (X_OD.p - from.X_AB.p).norm() < near_plan &&
                    rotation_vector(X_OD.R.transpose() * from.X_AB.R).norm() < kNearTurn;
  return near ? planned : from;
}

double mean_height(const StanceProblem& problem) {
  double sum = 0.0;
  for (LegId i = 0; i < problem.p_OF.size(); ++i)
    if (problem.reach.contains(i)) sum += problem.p_OF[i].z();
  return problem.reach.empty() ? 0.0 : sum / problem.reach.size();
}

// Have the problems, of the same feet, the same answer, wherever the base is?
bool is_same(const StanceProblem& a, const StanceProblem& b) {
  return a.reach == b.reach && a.support == b.support && a.height == b.height &&
         a.margin == b.margin;
}

// Duration of a BaseTarget or BaseAuto from one pose to another, by its rates [s].
template <class Command>
double duration_of(const Command& command, const Pose& from, const Pose& to, double minimum) {
  return base_duration(from, to, command.average_linear_velocity, command.average_angular_velocity,
                       minimum);
}

// Harmonic mean of two velocities, per axis; 0 if they oppose each other.
Vector3 passing(const Vector3& before, const Vector3& after) {
  Vector3 v = Vector3::Zero();
  for (int k = 0; k < 3; ++k)
    if (before[k] * after[k] > 0.0) v[k] = 2.0 * before[k] * after[k] / (before[k] + after[k]);
  return v;
}

}  // namespace

PlannerParams completed(PlannerParams params, const RobotModel& model) {
  RobotParams all = none_derived();
  all.script = params.script;
  params.script = completed(all, model).script;
  return params;
}

StepPlanner::StepPlanner(const RobotModel& model, const PlannerParams& params)
    : params_(completed(params, model)) {
  plan_.legs = LegArray<LegPlan>(model.num_legs());
}

StepPlanner& StepPlanner::operator=(const StepPlanner& other) {
  if (this == &other) return *this;
  params_ = other.params_;
  plan_ = other.plan_;
  foot_knots_.reserve(other.foot_knots_.capacity());
  base_knots_.reserve(other.base_knots_.capacity());
  height_ = other.height_;
  return *this;
}

void StepPlanner::reserve(const action::Action& action, Executor& executor) {
  std::size_t foot = 0, joints = 0, base = 0;
  for (const action::Step& step : action.steps) {
    for (const action::LegCommand& command : step.legs) {
      if (const auto* t = std::get_if<action::EndEffectorTrajectory>(&command.motion))
        foot = std::max(foot, t->knots.size());
      if (const auto* t = std::get_if<action::JointTrajectory>(&command.motion))
        joints = std::max(joints, t->knots.size());
    }
    if (!step.base) continue;
    if (const auto* t = std::get_if<action::BaseTrajectory>(&step.base->motion))
      base = std::max(base, t->knots.size());
  }
  foot_knots_.reserve(foot);
  base_knots_.reserve(base + 1);
  for (LegPlan& plan : plan_.legs) {
    plan.foot.reserve(static_cast<int>(foot));
    plan.joints.reserve(static_cast<int>(joints));
  }
  plan_.base.curve.reserve(static_cast<int>(base) + 1);
  executor.reserve(static_cast<int>(foot), static_cast<int>(joints), static_cast<int>(base) + 1);
}

const StepPlan& StepPlanner::plan(const action::Step& step, const action::Step* next,
                                  const StepStart& start) noexcept {
  plan_.moving = plan_.commanded = LegSet();
  plan_.cause = Cause::none;
  plan_.leg = -1;
  plan_.moves_base = step.base.has_value();
  plan_.duration = step.wait.duration;
  for (const action::CustomCommand& custom : step.custom)
    plan_.duration = std::max(plan_.duration, custom.duration);

  base_knots_.clear();
  plan_legs(step, start);
  refuse_to_tip(step, start);
  if (plan_.moves_base) plan_base(step, next, start);
  for (LegId i = 0; i < plan_.legs.size(); ++i)
    if (plan_.moving.contains(i)) plan_.duration = std::max(plan_.duration, time_of(i, start));
  keep_places(start);
  refuse_what_is_not_finite();
  return plan_;
}

// What commands made in C++ and poses of frames may lead to.
void StepPlanner::refuse_what_is_not_finite() noexcept {
  const auto refuse = [this](LegId leg) {
    plan_.cause = Cause::not_finite;
    plan_.leg = leg;
  };
  const auto endless = [](const BaseKnot& knot) { return !std::isfinite(knot.time); };
  if (!std::isfinite(plan_.duration) || std::ranges::any_of(base_knots_, endless)) refuse(-1);
  if (plan_.moves_base && !plan_.base.curve.in_range()) refuse(-1);
  for (LegId i = plan_.legs.size() - 1; i >= 0; --i)
    if (plan_.moving.contains(i) && !plan_.legs[i].in_range()) refuse(i);
}

// A foot whose motion in odom has ended stays there until the step ends, whatever the base does.
// Only feet without a command move with the base ([FG16] IV-A).
void StepPlanner::keep_places(const StepStart& start) noexcept {
  for (LegId i = 0; i < plan_.legs.size(); ++i) {
    LegPlan& plan = plan_.legs[i];
    if (plan_.moving.contains(i) && !plan.with_body() && !plan.lands)
      plan.duration += plan_.duration - time_of(i, start);
  }
}

void StepPlanner::plan_legs(const action::Step& step, const StepStart& start) noexcept {
  for (const action::LegCommand& command : step.legs) {
    const LegId leg = leg_motion(command).leg;
    LegPlan& plan = plan_.legs[leg];
    plan_leg(plan, command, start, params_, foot_knots_);
    plan_.moving.insert(leg);

    // A standing leg with the command to stand needs no plan.
    const bool stands = start.executor.legs()[leg].on_ground();
    const bool stays = plan.kind == LegPlan::Kind::keep && plan.lands && stands;
    if (!stays) plan_.commanded.insert(leg);
  }
}

// Duration of a leg's motion, load transfer included [s].
double StepPlanner::time_of(LegId leg, const StepStart& start) const noexcept {
  const bool unloads = plan_.commanded.contains(leg) && start.executor.legs()[leg].on_ground();
  return plan_.legs[leg].duration + (unloads ? start.executor.params().swing.unload_time : 0.0);
}

// Static stability on the remaining legs. If none remain, the body rests on something else.
void StepPlanner::refuse_to_tip(const action::Step& step, const StepStart& start) noexcept {
  const LegSet lifted = lifted_by(step);
  const LegSet support = without(start.executor.support(), lifted);
  if ((lifted & start.executor.support()).empty() || support.empty()) return;
  LegArray<Vector3> p_OF(start.model.num_legs());
  for (LegId i = 0; i < p_OF.size(); ++i)
    p_OF[i] = start.state.X_OB * start.executor.legs()[i].p_BF;
  const Vector3 p_OM = start.state.X_OB * start.model.p_BM;
  const double margin = stability_margin(support_polygon(p_OF, support), p_OM.head<2>());
  if (margin >= params_.min_margin) return;
  plan_.cause = Cause::unstable;
  plan_.leg = first_of(lifted);
}

void StepPlanner::plan_base(const action::Step& step, const action::Step* next,
                            const StepStart& start) noexcept {
  const BaseState from = start_of_base(start, params_.script.near_plan);
  bool ignores_legs = false;
  if (const auto* t = std::get_if<action::BaseTrajectory>(&step.base->motion)) {
    const Pose X_OA = start.step_frames.in_odom(t->frame, start.frames, start.state);
    for (const BaseKnot& knot : t->knots) base_knots_.push_back({knot.time, X_OA * knot.X_AB});
  } else {
    const BaseGoalPose goal = base_goal(step, next, start, from.X_AB);
    ignores_legs = goal.ignores_legs;
    base_knots_.push_back({goal.duration, goal.X_OB});
  }

  // The base and rate-based leg motions wait for each other: they end together.
  double& time = base_knots_.back().time;
  const bool rates = !std::holds_alternative<action::BaseTrajectory>(step.base->motion);
  if (!ignores_legs) {
    double longest = time;
    for (const action::LegCommand& command : step.legs)
      longest = std::max(longest, time_of(leg_motion(command).leg, start));
    if (rates) time = longest;
    for (const action::LegCommand& command : step.legs) {
      const LegId leg = leg_motion(command).leg;
      const double before = time_of(leg, start) - plan_.legs[leg].duration;
      if (rate_based(command)) stretch(plan_.legs[leg], command, longest - before, start, params_);
    }
  }
  plan_.base.curve.plan(from, base_knots_, end_twist(step, next, start, from.X_AB));
  plan_.duration = std::max(plan_.duration, time);
}

// Goal pose and duration of a BaseTarget or BaseAuto.
StepPlanner::BaseGoalPose StepPlanner::base_goal(const action::Step& step, const action::Step* next,
                                                 const StepStart& start,
                                                 const Pose& from) noexcept {
  BaseGoalPose goal;
  if (const auto* target = std::get_if<action::BaseTarget>(&step.base->motion)) {
    goal.X_OB = start.step_frames.in_odom(target->frame, start.frames, start.state) * target->X_AB;
    goal.ignores_legs = target->ignore_timing_of_leg_motion;
    goal.duration = duration_of(*target, from, goal.X_OB, params_.script.base_target_time);
    return goal;
  }
  const auto& automatic = *std::get_if<action::BaseAuto>(&step.base->motion);
  goal.X_OB = best_stance(automatic, step, next, start);
  goal.ignores_legs = automatic.ignore_timing_of_leg_motion;
  goal.duration = duration_of(automatic, from, goal.X_OB, params_.script.base_auto_time);
  return goal;
}

// The targets of moving legs, the footholds of the others, and where the base is. Legs that hang in
// the air move with the body.
StanceProblem StepPlanner::feet_at_the_end(const StepStart& start) const noexcept {
  StanceProblem problem;
  problem.X_OB = start.state.X_OB;
  problem.p_OF = LegArray<Vector3>(start.model.num_legs());
  for (LegId i = 0; i < problem.p_OF.size(); ++i)
    problem.p_OF[i] = plan_.moving.contains(i) ? end_in_odom(plan_.legs[i], i, start)
                                               : start.state.X_OB * start.executor.legs()[i].p_BF;
  return problem;
}

// What the command asks of the base over these feet.
void StepPlanner::set_stance(StanceProblem& problem, const action::BaseAuto& command, LegSet lifted,
                             LegSet ignored, const StepStart& start) const noexcept {
  problem.margin = command.support_margin;
  problem.support = without(start.executor.support(), lifted);
  for (LegId i = 0; i < problem.p_OF.size(); ++i) {
    const bool has_place = plan_.moving.contains(i) || start.executor.legs()[i].on_ground();
    problem.reach.set(i, has_place && !ignored.contains(i));
  }
  const double present = start.state.X_OB.p.z() - mean_height(problem);
  problem.height = command.height.value_or(height_.value_or(present));
}

Pose StepPlanner::best_stance(const action::BaseAuto& command, const action::Step& step,
                              const action::Step* next, const StepStart& start) noexcept {
  StanceProblem problem = feet_at_the_end(start);
  set_stance(problem, command, lifted_from(step, next), ignored_by(step), start);
  plan_.stance = params_.stance(start.model, problem);
  const double height = plan_.stance.X_OB.p.z() - mean_height(problem);
  const bool too_high = problem.height > height + params_.script.height_lost;
  if (plan_.stance.reachable() && std::isfinite(problem.height))
    height_ = too_high ? height : problem.height;
  if (!plan_.stance.reachable() && plan_.cause == Cause::none) {
    plan_.cause = Cause::out_of_reach;
    plan_.leg = first_of(plan_.stance.out_of_reach);
  }
  return plan_.stance.X_OB;
}

// Twist at the end of the base's motion: not 0 if the next step moves the base on, unless a leg
// lands in this step, which may be late, or anything else lasts longer.
Twist StepPlanner::end_twist(const action::Step& step, const action::Step* next,
                             const StepStart& start, const Pose& from) const noexcept {
  if (!next || !next->base) return {};
  const BaseKnot& end = base_knots_.back();
  double longest = plan_.duration;
  for (const action::LegCommand& command : step.legs) {
    if (!leg_motion(command).ignore_contact) return {};
    longest = std::max(longest, time_of(leg_motion(command).leg, start));
  }
  if (longest > end.time + kTimeTolerance) return {};
  const std::size_t n = base_knots_.size();
  const BaseKnot before = n > 1 ? base_knots_[n - 2] : BaseKnot{0.0, from};
  const BaseKnot after = first_goal(*next, step, end, start);
  if (!(end.time > before.time) || !(after.time > 0.0)) return {};

  const Matrix3 R_EO = end.X_AB.R.transpose();
  const double time = end.time - before.time;
  return {passing(R_EO * (end.X_AB.p - before.X_AB.p) / time,
                  R_EO * (after.X_AB.p - end.X_AB.p) / after.time),
          passing(rotation_vector(before.X_AB.R.transpose() * end.X_AB.R) / time,
                  rotation_vector(R_EO * after.X_AB.R) / after.time)};
}

// The first pose of the base in a step and its time, as far as they are known in advance. The base
// stays if the step before asks for the same stance.
BaseKnot StepPlanner::first_goal(const action::Step& step, const action::Step& before,
                                 const BaseKnot& from, const StepStart& start) const noexcept {
  // Poses in the body frame are relative to where the body will be then.
  const auto in_odom = [&from, &start](FrameId frame) {
    const Placement place = start.step_frames.place(frame, start.frames, start.state);
    return place.in_body ? from.X_AB * place.X_PA : place.X_PA;
  };
  if (const auto* t = std::get_if<action::BaseTrajectory>(&step.base->motion)) {
    const BaseKnot& knot = t->knots.front();
    return {knot.time, in_odom(t->frame) * knot.X_AB};
  }
  if (const auto* target = std::get_if<action::BaseTarget>(&step.base->motion)) {
    const Pose X_OB = in_odom(target->frame) * target->X_AB;
    return {duration_of(*target, from.X_AB, X_OB, params_.script.base_target_time), X_OB};
  }
  const auto& automatic = *std::get_if<action::BaseAuto>(&step.base->motion);
  StanceProblem problem = feet_at_the_end(start);
  set_stance(problem, automatic, lifted_by(step), ignored_by(step), start);
  bool stays = false;
  if (const auto* now = std::get_if<action::BaseAuto>(&before.base->motion)) {
    StanceProblem same_feet = problem;
    set_stance(same_feet, *now, lifted_from(before, &step), ignored_by(before), start);
    stays = is_same(problem, same_feet);
  }
  problem.X_OB = from.X_AB;
  const Pose X_OB = stays ? from.X_AB : params_.stance(start.model, problem).X_OB;
  return {duration_of(automatic, from.X_AB, X_OB, params_.script.base_auto_time), X_OB};
}

}  // namespace hexagait

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/executor/tick_motion.hpp>
#include <hexagait/script/fill_in.hpp>
#include <hexagait/script/sequencer.hpp>
#include <utility>

namespace hexagait {
namespace {

// A slower base counts as at rest [m/s], [rad/s].
constexpr double kAtRest = 1e-6;

// A stop ends at the latest after this many search times.
constexpr double kStopPatience = 3.0;

int steps_of(const action::Action& action) { return static_cast<int>(action.steps.size()); }

// Does the leg stand with confirmed contact, or hold in the air as commanded?
bool at_rest(const LegLane& lane, const SwingParams& params) {
  return lane.phase == LegPhase::hold || lane.supports(params);
}

bool at_rest(const BaseLane& base) {
  const Twist V = base.twist();
  return V.v.norm() < kAtRest && V.w.norm() < kAtRest;
}

}  // namespace

Sequencer::Sequencer(const RobotModel& model, const SequencerParams& params)
    : model_(&model),
      params_{completed(params.planner, model)},
      planner_(model, params_.planner),
      beyond_(model.num_legs(), 0.0) {}

void Sequencer::reset() {
  Sequencer fresh(*model_, params_);
  fresh.handle_custom(handler_, context_);
  *this = std::move(fresh);
}

void Sequencer::submit(action::Action action, Preemption preemption, Executor& executor) {
  fill_in(action.steps, params_.planner.script);
  planner_.reserve(action, executor);
  next_action_ = std::move(action);
  waiting_ = true;
  if (active_ && preemption != Preemption::wait) stop(preemption);
}

void Sequencer::replace(std::vector<action::Step> steps, Executor& executor) {
  if (!active_) return;
  fill_in(steps, params_.planner.script);
  action::Action rest{action_.id, action_.source, {}, std::move(steps)};
  planner_.reserve(rest, executor);
  action_.steps.resize(static_cast<std::size_t>(step_));
  std::move(rest.steps.begin(), rest.steps.end(), std::back_inserter(action_.steps));
}

void Sequencer::stop(Preemption when) noexcept {
  if (!active_ || stopping_) return;
  if (when == Preemption::end_of_step) stops_after_step_ = true;
  if (when != Preemption::at_once) return;
  stopping_ = true;
  ending_ = {number_, Outcome::preempted, Cause::none, step_, -1};
}

void Sequencer::fail(Cause cause, LegId leg) noexcept {
  if (!active_ || (stopping_ && ending_.outcome == Outcome::failed)) return;
  stopping_ = true;
  ending_ = {number_, Outcome::failed, cause, step_, leg};
}

void Sequencer::give_up() noexcept {
  fail(Cause::plant);
  if (active_) end_action();
  waiting_ = false;
  feedback_ = {};
  feedback_.description = "Stopped by a fault";
}

void Sequencer::update(Executor& executor, const RobotState& state, const Frames& frames,
                       double dt) noexcept {
  const StepStart start{*model_, executor, state, frames, step_frames_};
  if (!active_ && waiting_) begin_action(executor, state, frames);
  if (active_ && !stopping_) advance_step(executor, start, dt);
  if (stopping_) advance_stop(executor, dt);
  set_rate(executor, dt);
  report(executor);
}

void Sequencer::begin_action(const Executor& executor, const RobotState& state,
                             const Frames& frames) noexcept {
  std::swap(action_, next_action_);
  waiting_ = false;
  active_ = true;
  ++number_;
  step_ = 0;
  elapsed_ = regain_time_ = 0.0;
  std::fill(beyond_.begin(), beyond_.end(), 0.0);
  stops_after_step_ = false;
  step_frames_.start(action_, frames, state);
  given_up_ = LegSet();
  for (LegId i = 0; i < beyond_.size(); ++i) given_up_.set(i, executor.legs()[i].exhausted);
}

// The next step, or null after the last.
void Sequencer::begin_step(Executor& executor, const StepStart& start, double carry) noexcept {
  if (step_ == steps_of(action_)) {
    ending_ = {number_, Outcome::succeeded, Cause::none, step_, -1};
    return end_action();
  }
  const auto index = static_cast<std::size_t>(step_++);
  const action::Step& step = action_.steps[index];
  const action::Step* next = index + 1 < action_.steps.size() ? &action_.steps[index + 1] : nullptr;
  elapsed_ = carry;
  regain_time_ = 0.0;
  std::fill(beyond_.begin(), beyond_.end(), 0.0);

  const StepPlan& plan = planner_.plan(step, next, start);
  const bool refused = params_.planner.refuses || plan.cause == Cause::not_finite;
  if (plan.cause != Cause::none && refused) return fail(plan.cause, plan.leg);
  for (LegId i = 0; i < beyond_.size(); ++i) {
    if (!plan.commanded.contains(i)) continue;
    given_up_.erase(i);
    executor.command(i, plan.legs[i], start.state, carry);
  }
  if (plan.moves_base) executor.command(plan.base, carry);
  for (const action::CustomCommand& custom : step.custom)
    if (handler_) handler_(custom, context_);
}

void Sequencer::advance_step(Executor& executor, const StepStart& start, double dt) noexcept {
  if (step_ > 0) elapsed_ += rate_ * dt;
  watch(executor, dt);
  if (stopping_ || paused_ || uncertain_ || !step_done(executor)) return;

  // The next step starts with the time by which this one has overrun.
  const double over = step_ > 0 ? elapsed_ - planner_.last().duration : 0.0;
  if (!stops_after_step_ || step_ == steps_of(action_))
    return begin_step(executor, start, over < dt ? std::max(0.0, over) : 0.0);
  stopping_ = true;
  ending_ = {number_, Outcome::preempted, Cause::none, step_, -1};
}

// Detects feet that do not find the ground, lose it, or cannot reach their targets.
void Sequencer::watch(const Executor& executor, double dt) noexcept {
  regaining_ = uncertain_ = false;
  LegId doubtful = -1;  // should stand, and does not yet
  for (LegId i = 0; i < beyond_.size(); ++i) {
    const LegLane& lane = executor.legs()[i];
    if (lane.exhausted && !given_up_.contains(i))
      return fail(lane.lost ? Cause::lost_contact : Cause::no_contact, i);
    regaining_ = regaining_ || (lane.lost && lane.phase == LegPhase::search);
    const bool loads = lane.phase == LegPhase::support && !lane.supports(executor.params().swing);
    if (loads || lane.phase == LegPhase::search) doubtful = i;
    uncertain_ = uncertain_ || regaining_ || loads;

    const bool moves = lane.phase == LegPhase::follow || lane.on_ground();
    beyond_[i] = moves && !executor.reachable(i) ? beyond_[i] + dt : 0.0;
    if (beyond_[i] > params_.planner.script.reach_time && params_.planner.refuses)
      return fail(Cause::out_of_reach, i);
  }
  if (regaining_ || doubtful >= 0) regain_time_ += dt;
  if (regain_time_ > params_.planner.script.regain_limit) fail(Cause::lost_contact, doubtful);
}

bool Sequencer::step_done(const Executor& executor) const noexcept {
  if (step_ == 0) return true;
  const StepPlan& plan = planner_.last();
  if (elapsed_ < plan.duration - kTimeTolerance) return false;
  for (LegId i = 0; i < beyond_.size(); ++i)
    if (plan.moving.contains(i) && !at_rest(executor.legs()[i], executor.params().swing))
      return false;
  return !plan.moves_base || executor.base_time() >= plan.base.curve.duration() - kTimeTolerance;
}

void Sequencer::advance_stop(Executor& executor, double dt) noexcept {
  if (stop_time_ < 0.0) {
    stop_time_ = 0.0;
    for (LegId i = 0; i < beyond_.size(); ++i) executor.interrupt(i, executor.plans()[i].lands);
    executor.interrupt_base();
    return;
  }
  stop_time_ += dt;
  const SwingParams& swing = executor.params().swing;
  bool settled = at_rest(executor.base());
  for (const LegLane& lane : executor.legs()) settled = settled && at_rest(lane, swing);
  if (settled || stop_time_ > kStopPatience * swing.search_time) end_action();
}

void Sequencer::end_action() noexcept {
  result_ = ending_;
  active_ = stopping_ = regaining_ = uncertain_ = false;
  stop_time_ = -1.0;
  step_ = 0;
}

// A pause ramps the rate of all plans' time to 0.
void Sequencer::set_rate(Executor& executor, double dt) noexcept {
  ramp_rate(executor, dt, paused_ || regaining_ ? 0.0 : 1.0);
}

void Sequencer::ramp_rate(Executor& executor, double dt, double wish) noexcept {
  const double most = dt / params_.planner.script.pause_time;
  rate_ += std::clamp(wish - rate_, -most, most);
  executor.set_rate(rate_);
}

void Sequencer::coast(Executor& executor, double dt) noexcept {
  ramp_rate(executor, dt, 0.0);
  if (active_ && !stopping_) elapsed_ += rate_ * dt;
}

void Sequencer::report(const Executor& executor) noexcept {
  feedback_.action = number_;
  feedback_.step = step_;
  feedback_.steps = active_ ? steps_of(action_) : 0;
  feedback_.queue = feedback_.steps - step_;
  feedback_.status = !active_     ? ActionStatus::idle
                     : stopping_  ? ActionStatus::stopping
                     : regaining_ ? ActionStatus::regaining
                     : paused_    ? ActionStatus::paused
                                  : ActionStatus::executing;
  feedback_.description = description(executor);
  const bool in_step = step_ > 0;
  const double duration = planner_.last().duration;
  feedback_.duration = in_step ? duration : 0.0;
  feedback_.phase = !in_step ? 0.0 : duration > 0.0 ? std::min(1.0, elapsed_ / duration) : 1.0;
  feedback_.moving = in_step ? planner_.last().moving : LegSet();
}

const char* Sequencer::description(const Executor& executor) const noexcept {
  switch (feedback_.status) {
    case ActionStatus::idle:
      return "Idle";
    case ActionStatus::stopping:
      return "Coming to a stable stance";
    case ActionStatus::regaining:
      return "Regaining contact";
    case ActionStatus::paused:
      return "Paused";
    case ActionStatus::executing:
      break;
  }
  const char* text = "Executing step";
  for (const LegLane& lane : executor.legs()) {
    if (lane.phase == LegPhase::search) return "Searching for ground";
    if (lane.phase == LegPhase::unload) text = "Preparing for step";
  }
  return text;
}

}  // namespace hexagait

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/script/step_planner.hpp>

namespace hexagait {

/// When a new action replaces the present one.
enum class Preemption : std::uint8_t {
  at_once,      ///< as soon as feet in the air have been lowered to the ground
  end_of_step,  ///< after the present step
  wait,         ///< after the present action
};

/// Called when a step with a custom command starts. Must not throw, nor block in a real-time
/// program.
using CustomHandler = void (*)(const action::CustomCommand& command, void* context);

struct SequencerParams {
  PlannerParams planner;
};

/// Executes the steps of scripted actions ([FG16] II-A): the motions of a step start together, and
/// the next step starts when all have ended. Contacts change the course of a step ([FG16] III-B):
///
///   contact early     the foot stands, if it should; otherwise it continues as planned
///   contact late      the step waits while the foot moves on against the surface normal
///   no contact        the action fails: no_contact
///   support lost      everything waits while the foot searches; if in vain, lost_contact
///
/// No step begins while paused, nor while a leg that stands has lost the ground or has contact that
/// is not confirmed yet.
///
/// An action that fails or is preempted stops: feet in the air are lowered to the ground, the base
/// comes to rest, and then there is a result. Every action ends with a result.
///
/// Drives an Executor that it does not own. A value, like the executor. The robot model must
/// outlive it.
class Sequencer {
 public:
  Sequencer(const RobotModel& model, const SequencerParams& params);
  Sequencer(const RobotModel&&, const SequencerParams&) = delete;

  /// Drops all actions; keeps the handler.
  void reset();

  /// Accepts an action and starts it when `preemption` allows. Drops an action accepted earlier
  /// that has not started. Allocates: call it between ticks.
  void submit(action::Action action, Preemption preemption, Executor& executor);

  /// Replaces the steps after the present one (receding horizon). Allocates.
  void replace(std::vector<action::Step> steps, Executor& executor);

  /// Ends the present action as preempted.
  void stop(Preemption when) noexcept;
  /// Ends the present action as failed.
  void fail(Cause cause, LegId leg = -1) noexcept;

  /// Ends everything at once, without lowering feet: the robot can no longer be moved.
  void give_up() noexcept;

  void pause() noexcept { paused_ = true; }
  void resume() noexcept { paused_ = false; }

  void handle_custom(CustomHandler handler, void* context) noexcept {
    handler_ = handler;
    context_ = context;
  }

  /// Ends and starts steps. To be called before each Executor::advance().
  void update(Executor& executor, const RobotState& state, const Frames& frames,
              double dt) noexcept;

  /// A tick without a measurement: the plans slow down, as in a pause.
  void coast(Executor& executor, double dt) noexcept;

  [[nodiscard]] const ActionFeedback& feedback() const { return feedback_; }
  /// Result of the last action that ended.
  [[nodiscard]] const ActionResult& result() const { return result_; }
  [[nodiscard]] const StepPlan& plan() const { return planner_.last(); }
  [[nodiscard]] const action::Action& action() const { return action_; }
  /// No action is being executed or waits to be.
  [[nodiscard]] bool idle() const { return feedback_.status == ActionStatus::idle && !waiting_; }

 private:
  void begin_action(const Executor& executor, const RobotState& state,
                    const Frames& frames) noexcept;
  void begin_step(Executor& executor, const StepStart& start, double carry) noexcept;
  void advance_step(Executor& executor, const StepStart& start, double dt) noexcept;
  void advance_stop(Executor& executor, double dt) noexcept;
  void watch(const Executor& executor, double dt) noexcept;
  void set_rate(Executor& executor, double dt) noexcept;
  void ramp_rate(Executor& executor, double dt, double wish) noexcept;
  void end_action() noexcept;
  void report(const Executor& executor) noexcept;
  [[nodiscard]] bool step_done(const Executor& executor) const noexcept;
  [[nodiscard]] const char* description(const Executor& executor) const noexcept;

  const RobotModel* model_;
  SequencerParams params_;
  StepPlanner planner_;
  StepFrames step_frames_;
  CustomHandler handler_ = nullptr;
  void* context_ = nullptr;

  // Actions.
  action::Action action_, next_action_;
  bool active_ = false;   ///< action_ is being executed
  bool waiting_ = false;  ///< next_action_ will follow
  bool stops_after_step_ = false;
  bool paused_ = false;

  // Progress.
  std::uint64_t number_ = 0;  ///< number of action_
  int step_ = 0;              ///< present step, from 1; 0: none yet
  double elapsed_ = 0.0;      ///< time in the step, at the rate of its plans [s]
  double rate_ = 1.0;         ///< rate of that time
  LegSet given_up_;           ///< feet that failed to find ground before this action
  bool regaining_ = false;
  bool uncertain_ = false;    ///< a standing leg has no contact, or none that is confirmed
  double regain_time_ = 0.0;  ///< spent regaining contact in this step [s]
  LegArray<double> beyond_;   ///< time for which each foot has been out of reach [s]

  // End.
  bool stopping_ = false;
  double stop_time_ = -1.0;  ///< since the stop began [s]; < 0: it has not
  ActionResult ending_;

  ActionFeedback feedback_;
  ActionResult result_;
};

}  // namespace hexagait

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/script/step_planner.hpp>

namespace hexagait {

/// When a new action may take the place of the one under way.
enum class Preemption : std::uint8_t {
  at_once,      ///< feet in the air that are to stand come down first
  end_of_step,  ///< after the step under way
  wait,         ///< after the whole action
};

/// Called when a step with a custom command starts. Must not throw, and in a real-time program not
/// take long.
using CustomHandler = void (*)(const action::CustomCommand& command, void* context);

struct SequencerParams {
  PlannerParams planner;
  double pause_time = 0.2;  ///< in which everything comes to rest, and gets under way again [s]
  /// A foot whose set point is beyond its leg's reach for longer than this fails the action [s].
  double reach_time = 0.2;
  /// Time that a step may spend regaining contact, in all [s]. Ends also what flickers for ever.
  double regain_limit = 5.0;
};

/// The barriers of scripted actions ([FG16] II-A): the motions of a step start together, and the
/// next step starts when all have ended; what feet feel on the way changes the course of things
/// ([FG16] III-B):
///
///   contact early       the foot stands, if it is to; else it goes on as planned
///   contact late        the step waits, the foot goes on along the normal
///   no contact at all   the action fails: no_contact
///   support lost        everything waits while the foot searches; in vain: lost_contact
///
/// An action that fails or is preempted stops: feet in the air that are to stand come down, the
/// base comes to rest, and then there is a result. Every action ends with one.
///
/// Drives an Executor that it does not own; a value like it.
class Sequencer {
 public:
  Sequencer(const RobotModel& model, const SequencerParams& params);

  /// Forgets all actions; the handler stays.
  void reset();

  /// Accepts an action, to be carried out when `preemption` allows. One that was accepted before
  /// and has not begun is dropped. Allocates: call it between ticks.
  void submit(action::Action action, Preemption preemption, Executor& executor);

  /// Replaces the steps after the one under way (receding horizon). Allocates.
  void replace(std::vector<action::Step> steps, Executor& executor);

  /// Ends the action under way.
  void stop(Preemption when) noexcept;
  /// Ends it as failed.
  void fail(Cause cause, LegId leg = -1) noexcept;

  /// Ends everything at once, without coming to a stance: the robot can't be moved any more.
  void give_up() noexcept;

  void pause() noexcept { paused_ = true; }
  void resume() noexcept { paused_ = false; }

  void handle_custom(CustomHandler handler, void* context) noexcept {
    handler_ = handler;
    context_ = context;
  }

  /// Before each Executor::advance(): steps end and start.
  void update(Executor& executor, const RobotState& state, const Frames& frames,
              double dt) noexcept;

  [[nodiscard]] const ActionFeedback& feedback() const { return feedback_; }
  /// Of the action that ended last.
  [[nodiscard]] const ActionResult& result() const { return result_; }
  [[nodiscard]] const StepPlan& plan() const { return planner_.last(); }
  [[nodiscard]] const action::Action& action() const { return action_; }
  /// Nothing to do, and nothing to come.
  [[nodiscard]] bool idle() const { return feedback_.status == ActionStatus::idle && !waiting_; }

 private:
  void begin_action(const Executor& executor, const RobotState& state,
                    const Frames& frames) noexcept;
  void begin_step(Executor& executor, const StepStart& start, double carry) noexcept;
  void advance_step(Executor& executor, const StepStart& start, double dt) noexcept;
  void advance_stop(Executor& executor, double dt) noexcept;
  void watch(const Executor& executor, double dt) noexcept;
  void set_rate(Executor& executor, double dt) noexcept;
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

  // What is to be done.
  action::Action action_, next_action_;
  bool active_ = false;   ///< action_ is under way
  bool waiting_ = false;  ///< next_action_ is to come
  bool stops_after_step_ = false;
  bool paused_ = false;

  // How far it is.
  std::uint64_t number_ = 0;  ///< of action_
  int step_ = 0;              ///< under way, from 1; 0: none
  double elapsed_ = 0.0;      ///< in the step, in the time of its plans [s]
  double rate_ = 1.0;         ///< of that time
  LegSet given_up_;           ///< feet that had found no ground before this action
  bool regaining_ = false;
  double regain_time_ = 0.0;  ///< spent regaining contact in this step [s]
  LegArray<double> beyond_;   ///< for how long each foot has been out of reach [s]

  // How it ends.
  bool stopping_ = false;
  double stop_time_ = -1.0;  ///< since the stop began [s]; < 0: not yet
  ActionResult ending_;

  ActionFeedback feedback_;
  ActionResult result_;
};

}  // namespace hexagait

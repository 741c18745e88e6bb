// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/viewer/session/session.hpp>

// Scripted actions of a session: checked in a thread of their own, performed in that of the walk.
namespace hexagait::viewer {
namespace {

using NewsState = ActionNews::State;

// Of those that the server lists: a name that an action gives names no file.
walk::RobotOfName robots_of(const SessionOptions& options) {
  return [&options](const std::string& name) {
    if (std::ranges::find(options.robots, name) == options.robots.end())
      throw InvalidInput(fmt::format(
          "it is written for the robot '{}', which is none of those that can be chosen", name));
    return name == options.robot.name ? options.robot : options.load(name).model;
  };
}

NewsState state_of(ActionProgress::State state) {
  switch (state) {
    case ActionProgress::State::none:
      break;
    case ActionProgress::State::halting:
    case ActionProgress::State::running:
      return NewsState::running;
    case ActionProgress::State::done:
      return NewsState::done;
    case ActionProgress::State::stopped:
      return NewsState::stopped;
    case ActionProgress::State::failed:
      return NewsState::failed;
  }
  return NewsState::stopped;
}

std::string why(const ActionProgress& progress, const RobotModel& robot) {
  if (progress.leg < 0) return progress.why;
  return fmt::format("{}: {}", robot.legs[progress.leg].name, progress.why);
}

}  // namespace

void Session::obey(const Perform& perform) {
  if (rival_ != nullptr) throw InvalidInput("two robots race; end the race before an action");
  if (check_.valid()) throw InvalidInput("another action is being checked; ask again after it");
  if (walk_->performs()) throw InvalidInput("an action goes on already; stop it first");
  ActionCheck check{options_.robot, walk_->runner_params(), robots_of(began_)};
  action_dropped_ = false;
  check_ = std::async(std::launch::async, [this, perform, check = std::move(check)] {
    const std::string yaml = perform.yaml.empty() ? began_.load_action(perform.name) : perform.yaml;
    return check_action(yaml, check, action_dropped_);
  });
  action_ = {.name = perform.name, .state = NewsState::checking};
  silent_ = false;
  tell_action();
}

// Has the check ended, or another step of the action begun?
void Session::watch_action() {
  follow_progress();
  if (!check_.valid() || check_.wait_for(Clock::duration::zero()) != std::future_status::ready)
    return;
  try {
    begin_action(check_.get());
  } catch (const std::exception& error) {
    end_action(NewsState::failed, error.what());
  }
}

void Session::begin_action(CheckedAction checked) {
  if (action_dropped_) return;  // and told
  action_.findings = std::move(checked.findings);
  if (!checked.action) return end_action(NewsState::refused, checked.why);
  walk_->perform(std::move(*checked.action));
  take_off_path();
  command_.heading = command_.heading.stopped();
  follow_progress();
}

// Of an action that goes on, or went on until this tick.
void Session::follow_progress() {
  if (action_.state != NewsState::running && !walk_->performs()) return;
  const ActionProgress& progress = walk_->progress();
  const NewsState state = state_of(progress.state);
  if (state == action_.state && progress.step == action_.step) return;
  action_.step = progress.step;
  action_.steps = progress.steps;
  end_action(state, why(progress, options_.robot));
}

// By who steers, or as nobody does.
void Session::stop_action() {
  if (check_.valid()) drop_action("");
  if (walk_ != nullptr) walk_->stop_action();
}

// The robot that was to perform it is gone, or is to do something else before it has begun.
void Session::drop_action(const char* why) {
  if (check_.valid()) action_dropped_ = true;
  if (action_.state == NewsState::running || action_.state == NewsState::checking)
    end_action(NewsState::stopped, why);
}

void Session::end_action(NewsState state, std::string why) {
  action_.state = state;
  action_.why = std::move(why);
  tell_action();
}

void Session::tell_action() {
  post(Mail::action, action_json(action_));
  changed_ = true;
}

}  // namespace hexagait::viewer

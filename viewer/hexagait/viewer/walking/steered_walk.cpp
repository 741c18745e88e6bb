// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/math/planar.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/viewer/walking/steered_walk.hpp>
#include <hexagait/walk/actions/action_check.hpp>

namespace hexagait::viewer {
namespace {

RunnerParams params_of(const recording::Simulation& simulation) {
  RunnerParams params = walk::runner_params(simulation.params);
  params.control_dt = simulation.control_dt;
  params.sensors = simulation.sensors;
  return params;
}

}  // namespace

SteeredWalk::SteeredWalk(const RobotModel& robot, const recording::Simulation& simulation)
    : robot_(robot),
      walker_(robot_, recording::walker_params(simulation)),
      runner_params_(params_of(simulation)),
      frames_(robot_, simulation.control_dt),
      path_(PlanarPose()) {}

void SteeredWalk::take_over() {
  walker_.start(measurement_);
  performance_ = nullptr;
  begin_odometry();
  path_ = walk::ReferencePath(place());
  followed_ = heading_control::Heading::stop();
}

void SteeredWalk::exchange(const heading_control::HeadingCommand& command) {
  write(walker_.tick(status_, measurement_, command).targets);
  listen();
}

void SteeredWalk::tick(const heading_control::HeadingCommand& command) {
  if (performance_ != nullptr) return tick_action();
  heading_control::HeadingCommand told = command;
  if (followed_path_ && followed_path_->steers()) {
    told = followed_path_->steer(walker_, truth());
    told.speed_limit = std::min(told.speed_limit, command.speed_limit);
  }
  exchange(told);
  if (!(told.heading == followed_)) path_.follow(followed_ = told.heading);
  observe();
  judge();
}

// By the path that it follows, or by the curve of its commands, which is told of each place: the next curve begins
// at the last one.
void SteeredWalk::judge() {
  lateral_ = path_.deviation(place()).lateral;
  if (followed_path_) lateral_ = followed_path_->observe(walker_, truth());
}

void SteeredWalk::perform(action::Action action) {
  if (performance_ != nullptr) throw InvalidInput("an action goes on already; stop it first");
  if (fault() != Fault::none || fell())
    throw InvalidInput("the robot is stopped: it can't perform an action");
  if (!walker_.lost_legs().empty())
    throw InvalidInput("the robot has lost a leg: an action needs all of them");
  performance_ = std::make_unique<Performance>(robot_, runner_params_, std::move(action));
  progress_ = performance_->progress();
}

void SteeredWalk::stop_action() noexcept {
  if (performance_ != nullptr) performance_->stop();
}

// The walker brings the robot to a stand; then the runner has it, until the action is over.
void SteeredWalk::tick_action() {
  if (acts()) {
    write(performance_->tick(status_, measurement_, truth().X_WB).desired.targets);
    listen();
  } else {
    exchange({walker_.record().heading.stopped(), std::numeric_limits<double>::infinity()});
    performance_->wait_for_stand(walker_, status_, measurement_);
    if (acts()) begin_odometry();
  }
  lateral_ = 0.0;
  observe();
  end_action();
}

// The walker takes over where the robot stands. A robot that a fault holds stays held until go_on().
void SteeredWalk::end_action() {
  progress_ = performance_->progress();
  if (progress_.goes_on() || fault() != Fault::none) return;
  if (acts()) {
    if (status_ != PlantStatus::fresh || !valid(measurement_, robot_)) return;
    take_over();
  }
  performance_ = nullptr;
}

void SteeredWalk::emergency_stop() {
  walker_.emergency_stop();
  if (performance_ == nullptr) return;
  performance_->emergency_stop(measurement_);
  progress_ = performance_->progress();
}

void SteeredWalk::go_on() {
  if (fault() == Fault::none) return;
  if (fell()) throw InvalidInput(robot_.name + " has fallen: it must begin again");
  take_over();
}

void SteeredWalk::follow(path_following::PathTask task, const PlanarPose& X_WP) {
  followed_path_ = std::make_unique<FollowedPath>(std::move(task), X_WP);
}

heading_control::HeadingCommand SteeredWalk::command_of(
    const PlanarTwist& twist, const heading_control::Heading& last) const {
  return heading_control::from_twist(twist, nominal_stance(robot_), last);
}

PoseFrame SteeredWalk::frame() const {
  PoseFrame f = frames_.frame(acts() ? as_walk(performance_->record()) : walker_.record());
  if (fell()) f.flags |= PoseFrame::fell;
  f.flags |= gait_flags(walker_.params().stepper.stepping);
  if (followed_path_ && followed_path_->steers()) f.flags |= PoseFrame::follows;
  f.lateral = lateral_;
  return f;
}

}  // namespace hexagait::viewer

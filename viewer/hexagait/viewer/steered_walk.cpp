// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/math/planar.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/viewer/steered_walk.hpp>

namespace hexagait::viewer {

SteeredWalk::SteeredWalk(const RobotModel& robot, const recording::Simulation& simulation)
    : robot_(robot),
      walker_(robot_, recording::walker_params(simulation)),
      frames_(robot_, simulation.control_dt),
      path_(PlanarPose()) {}

void SteeredWalk::take_over() {
  walker_.start(measurement_);
  begin_odometry();
  path_ = walk::ReferencePath(place());
  followed_ = heading_control::Heading::stop();
}

void SteeredWalk::exchange(const heading_control::HeadingCommand& command) {
  write(walker_.tick(status_, measurement_, command).targets);
  listen();
}

void SteeredWalk::tick(const heading_control::HeadingCommand& command) {
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

void SteeredWalk::emergency_stop() { walker_.emergency_stop(); }

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
  PoseFrame f = frames_.frame(walker_.record());
  if (fell()) f.flags |= PoseFrame::fell;
  f.flags |= gait_flags(walker_.params().stepper.stepping);
  if (followed_path_ && followed_path_->steers()) f.flags |= PoseFrame::follows;
  f.lateral = lateral_;
  return f;
}

}  // namespace hexagait::viewer

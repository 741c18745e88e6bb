// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <hexagait/viewer/session/session.hpp>
#include <hexagait/viewer/walking/breakage.hpp>

// What each command does; in the simulation's thread. What is refused throws and has changed nothing.
namespace hexagait::viewer {
namespace {

constexpr double kScramble = 0.9;  // of the workspaces' radius

bool is_same_way(const Follow& a, const Follow& b) {
  return a.points_W == b.points_W && a.closed == b.closed && a.name == b.name;
}

}  // namespace

void Session::obey(const Drive& drive) {
  stop_action();
  command_ = {drive.heading, drive.limit};
  take_off_path();
  silent_ = false;
  changed_ = true;
}

void Session::obey(const DriveTwist& drive) {
  stop_action();
  command_ = walk_->command_of(drive.twist, command_.heading);
  take_off_path();
  silent_ = false;
  changed_ = true;
}

void Session::obey(Stop) {
  stop_action();
  take_off_path();
  command_.heading = command_.heading.stopped();
  changed_ = true;
}

// The path that the robot is on goes on, at another speed or after a silence; it does not begin anew.
void Session::obey(const Follow& follow) {
  const bool is_on = walk_->path() != nullptr && !walk_->path()->arrived();
  if (!is_on || !is_same_way(follow, followed_)) {
    const bool drawn = follow.name.empty();
    const path_following::PathTask task =
        drawn ? drawn_path(follow.points_W, follow.closed, options_.robot, walk_->step(),
                           walk_->place())
              : options_.load_path(follow.name, options_.robot, walk_->step());
    const PlanarPose X_WP = drawn ? PlanarPose() : walk_->place();
    each([&](SteeredWalk& walk) { walk.follow(task, X_WP); });
    followed_ = follow;
    tell_setup();
  }
  stop_action();
  each([](SteeredWalk& walk) { walk.path()->go_on(); });
  command_ = {command_.heading.stopped(), follow.limit};
  silent_ = false;
  changed_ = true;
}

// Who steers leaves the path.
void Session::take_off_path() {
  if (walk_->path() == nullptr) return;
  each([](SteeredWalk& walk) { walk.leave_path(); });
  tell_setup();
}

void Session::obey(const Pause& pause) {
  paused_ = pause.on;
  steps_ = 0;
  changed_ = true;
}

void Session::obey(const SingleStep& step) {
  paused_ = true;
  steps_ += step.ticks;
}

void Session::obey(const SpeedFactor& speed) {
  options_.speed_factor = speed.factor;
  due_ = Clock::now();
}

// The legs stand somewhere else from one tick to the next: the robot is put down anew where it is.
void Session::obey(Scramble) {
  double radius = options_.robot.legs[0].workspace_radius;
  for (const LegModel& leg : options_.robot.legs) radius = std::min(radius, leg.workspace_radius);
  begin({walk_->place(), kScramble * radius, ++draws_});
}

void Session::obey(const Push& push) {
  each_simulated([&](SimulatedWalk& walk) { walk.push(push.angle); });
}

void Session::obey(const ChangeGait& change) {
  walk_->set_gait(change.stepper);
  options_.simulation.gait.stepper = change.stepper;
  changed_ = true;
}

// Both begin side by side in one place: neither feels the other.
void Session::obey(const Race& race) {
  if (!race.rival && !race_) return;
  race_ = race.rival;
  begin({.X_WB = walk_->place()});
}

void Session::obey(const Break& fault) {
  recording::PlantSetup& plant = options_.simulation.plant;
  const walk::PartFault part = admitted(fault.fault, plant.parts, options_.robot);
  if (part.kind != walk::PartFaultKind::load)
    each_simulated([&](SimulatedWalk& walk) { walk.add(part); });
  if (part.kind == walk::PartFaultKind::push) return;  // it passes
  plant.parts.push_back(part);
  if (part.kind == walk::PartFaultKind::load)
    begin({.X_WB = walk_->place()});
  else
    tell_setup();
}

void Session::obey(Mend) {
  if (options_.simulation.plant.parts.empty()) return;
  options_.simulation.plant.parts.clear();
  begin({.X_WB = walk_->place()});
}

void Session::obey(const ChangePlant& change) {
  recording::PlantSetup& plant = options_.simulation.plant;
  std::vector<walk::PartFault> parts = std::move(plant.parts);
  plant = change.preset->setup;
  plant.name = change.preset->name;
  plant.parts = std::move(parts);
  recording::complete(options_.simulation, options_.robot);
  begin({.X_WB = walk_->place()});
}

void Session::obey(Reset) {
  options_ = began_;
  race_ = std::nullopt;
  command_ = {options_.heading, kNoLimit};
  paused_ = silent_ = false;
  begin({});
}

void Session::obey(const Restart& restart) {
  SessionOptions next = options_;
  if (restart.robot) {
    const bool own = *restart.robot == began_.robot.name;
    LoadedRobot robot =
        own ? LoadedRobot{began_.robot, began_.simulation.params} : options_.load(*restart.robot);
    next.robot = std::move(robot.model);
    next.simulation.params = robot.params;
    next.simulation.plant.parts.clear();  // they are of the other one's legs
    next.simulation.physics_dt = next.simulation.plant.world.contact_threshold = kDerived;
    recording::complete(next.simulation, next.robot);
  }
  if (restart.terrain) next.simulation.terrain = *restart.terrain;
  if (restart.seed) next.simulation.seed = *restart.seed;
  options_ = std::move(next);
  command_ = {began_.heading, kNoLimit};
  silent_ = false;
  begin({});
}

void Session::obey(EmergencyStop) {
  obey(Stop{});
  hold_still();
  silent_ = false;
  tell_setup();
}

// Of an emergency stop that lasts, also over a new scene.
void Session::hold_still() {
  {
    const std::lock_guard lock(mutex_);
    if (!stopped_by_) return;
  }
  each([](SteeredWalk& walk) { walk.emergency_stop(); });
}

// Of any fault after which the robot can be taken over where it stands. It stands until it is steered.
void Session::obey(ReleaseEmergencyStop) {
  each([](SteeredWalk& walk) { walk.go_on(); });
  command_.heading = command_.heading.stopped();
  silent_ = false;
  {
    const std::lock_guard lock(mutex_);
    if (!stop_due_) stopped_by_.reset();  // unless it was pressed again just now
  }
  tell_setup();
}

}  // namespace hexagait::viewer

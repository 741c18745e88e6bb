// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/viewer/walking/live_walk.hpp>

namespace hexagait::viewer {
namespace {

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

Pose in_space(const PlanarPose& X) {
  return {rotation_z(X.angle), {X.shift.x(), X.shift.y(), 0.0}};
}

}  // namespace

LiveWalk::LiveWalk(const RobotModel& robot, const recording::Simulation& simulation,
                   PipePlant& plant, double patience)
    : SteeredWalk(robot, simulation),
      plant_(plant),
      ground_(sim3d::parse_terrain("flat"), 0),
      no_efforts_(robot.num_legs(), LegJoints::Zero()) {
  const auto begin = Clock::now();
  do listen();
  while (status() == PlantStatus::late && seconds_since(begin) < patience);
  if (status() == PlantStatus::closed) throw InvalidInput("the robot " + plant_.problem());
  if (status() == PlantStatus::late)
    throw InvalidInput(fmt::format("the robot has sent no state for {:.3g} s", patience));
  gap_ = 0.0;
  seen_.feet = LegArray<FootTruth>(robot.num_legs());
  take_over();
  frames().start(seen_, measurement().q);
}

LiveWalk::~LiveWalk() {
  emergency_stop();
  write(targets());
}

PlantStatus LiveWalk::read(Measurement& measurement) {
  const PlantStatus status = plant_.read(measurement);
  const bool was_late = std::exchange(late_, status == PlantStatus::late);
  if (status != PlantStatus::fresh) return status;
  if (was_late) gap_ = std::max(gap_, seconds_since(last_state_));
  last_state_ = Clock::now();
  return status;
}

void LiveWalk::write(const JointTargets& targets) {
  plant_.set_stopped(fault() != Fault::none);
  plant_.write(targets);
}

// Where the robot was last seen it is seen again.
void LiveWalk::begin_odometry() {
  X_WO_ = in_plane(seen_.X_WB) * in_plane(state().X_OB).inverse();
  see();
}

void LiveWalk::observe() {
  see();
  frames().observe(seen_, measurement().q, no_efforts_);
}

void LiveWalk::see() {
  seen_.time = measurement().time;
  seen_.X_WB = in_space(X_WO_) * state().X_OB;
  if (!valid(measurement(), robot())) return;
  for (LegId i = 0; i < robot().num_legs(); ++i) {
    seen_.feet[i].p_WF = seen_.X_WB * foot_position(robot().legs[i], measurement().q[i]);
    seen_.feet[i].in_contact = state().contact[i];
  }
}

}  // namespace hexagait::viewer

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/math/planar.hpp>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/viewer/breakage.hpp>
#include <hexagait/viewer/steered_walk.hpp>
#include <hexagait/walk/referee.hpp>
#include <hexagait/walk/trial.hpp>

namespace hexagait::viewer {
namespace {

constexpr double kSettle = 0.3;      // time to come to rest on the feet [s]
constexpr double kPushSpeed = 0.85;  // of √(g h)
constexpr double kPushTime = 1.1;    // of √(h / g)

sim3d::WorldParams world_params_at(const recording::Simulation& simulation,
                                   const PlanarPose& start) {
  sim3d::WorldParams params = recording::world_params(simulation);
  params.start = start;
  return params;
}

bool lies(const Pose& X_WB) { return X_WB.R(2, 2) < portable::cos(walk::kFallTilt); }

}  // namespace

LegArray<LegJoints> posture_on(const sim3d::Terrain& terrain, const RobotModel& robot,
                               const WalkStart& start) {
  LegArray<LegJoints> q = walk::random_posture(robot, start.spread, start.draw);
  LegArray<Vector3> p_BF(robot.num_legs());
  LegArray<double> ground(robot.num_legs());
  double mean = 0.0;
  for (LegId i = 0; i < robot.num_legs(); ++i) {
    p_BF[i] = foot_position(robot.legs[i], q[i]);
    const Vector2 p_W = start.X_WB * Vector2(p_BF[i].head<2>());
    ground[i] = terrain.height_at(p_W.x(), p_W.y());
    mean += ground[i] / robot.num_legs();
  }
  for (LegId i = 0; i < robot.num_legs(); ++i) {
    p_BF[i].z() += ground[i] - mean;
    q[i] = inverse_kinematics(robot.legs[i], p_BF[i], q[i]).q;
  }
  return q;
}

SteeredWalk::SteeredWalk(const RobotModel& robot, const recording::Simulation& simulation,
                         const WalkStart& start)
    : robot_(robot),
      simulation_(simulation),
      world_(with_loads(robot_, simulation.plant.parts), simulation.terrain,
             world_params_at(simulation, start.X_WB),
             posture_on(sim3d::Terrain(simulation.terrain, simulation.seed), robot_, start)),
      broken_(world_, resolved(simulation.plant.parts, robot_), recording::body_of(world_),
              simulation.control_dt, kSettle, simulation.seed),
      plant_(broken_, robot_, simulation.plant.faults, simulation.control_dt, simulation.seed),
      walker_(robot_, recording::walker_params(simulation)),
      falling_speed_(falling_speed(robot_)),
      frames_(robot_, simulation.control_dt),
      path_(start.X_WB) {
  settle();
}

void SteeredWalk::settle() {
  status_ = plant_.read(measurement_);
  walker_.start(measurement_);
  const auto stop = heading_control::Heading::stop();
  for (double t = 0.0; t < kSettle; t += control_dt()) {
    plant_.write(walker_.tick(status_, measurement_, stop).targets);
    status_ = plant_.read(measurement_);
  }
  walker_.start(measurement_);
  frames_.start(world_.truth(), measurement_.q);
  path_ = walk::ReferencePath(place());
}

void SteeredWalk::tick(const heading_control::HeadingCommand& command) {
  heading_control::HeadingCommand told = command;
  if (followed_path_ && followed_path_->steers()) {
    told = followed_path_->steer(walker_, world_.truth());
    told.speed_limit = std::min(told.speed_limit, command.speed_limit);
  }
  const footstep_gen::TickRecord& record = walker_.tick(status_, measurement_, told);
  plant_.write(record.targets);
  status_ = plant_.read(measurement_);
  if (!(told.heading == followed_)) path_.follow(followed_ = told.heading);
  observe();
}

void SteeredWalk::follow(path_following::PathTask task, const PlanarPose& X_WP) {
  followed_path_ = std::make_unique<FollowedPath>(std::move(task), X_WP);
}

// By the path that it follows, or by the curve of its commands, which is told of each place: the next curve begins
// at the last one.
void SteeredWalk::judge() {
  lateral_ = path_.deviation(place()).lateral;
  if (followed_path_) lateral_ = followed_path_->observe(walker_, world_.truth());
}

void SteeredWalk::observe() {
  const GroundTruth& truth = world_.truth();
  frames_.observe(truth, measurement_.q, world_.efforts());
  judge();
  if (!fell_ && (truth.base_touches_ground || lies(truth.X_WB) || !truth.finite)) {
    fell_ = true;
    walker_.emergency_stop();
  }
}

void SteeredWalk::push(double angle) {
  const double time = kPushTime * falling_speed_ / kStandardGravity;
  const double impulse = kPushSpeed * falling_speed_ * robot_.mass;
  const Vector2 along = impulse / time * unit_vector(angle + place().angle);
  world_.push({along.x(), along.y(), 0.0}, time);
}

void SteeredWalk::set_gait(const gait_state::StepperParams& stepper) {
  walker_.set_stepping(stepper);
  simulation_.gait.stepper = stepper;
}

PlanarPose SteeredWalk::place() const { return in_plane(world_.truth().X_WB); }

heading_control::HeadingCommand SteeredWalk::command_of(
    const PlanarTwist& twist, const heading_control::Heading& last) const {
  return heading_control::from_twist(twist, nominal_stance(robot_), last);
}

PoseFrame SteeredWalk::frame() const {
  PoseFrame f = frames_.frame(walker_.record());
  if (fell_) f.flags |= PoseFrame::fell;
  f.flags |= gait_flags(walker_.params().stepper.stepping);
  if (followed_path_ && followed_path_->steers()) f.flags |= PoseFrame::follows;
  f.lateral = lateral_;
  return f;
}

}  // namespace hexagait::viewer

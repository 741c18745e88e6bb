// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/math/planar.hpp>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/viewer/walking/breakage.hpp>
#include <hexagait/viewer/walking/simulated_walk.hpp>
#include <hexagait/walk/referee/referee.hpp>
#include <hexagait/walk/trial.hpp>
#include <limits>

namespace hexagait::viewer {
namespace {

constexpr double kSettle = 0.3;  // time to come to rest on the feet [s]
constexpr double kEndless = std::numeric_limits<double>::infinity();
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

SimulatedWalk::SimulatedWalk(const RobotModel& robot, const recording::Simulation& simulation,
                             const WalkStart& start)
    : SteeredWalk(robot, simulation),
      world_(with_loads(this->robot(), simulation.plant.parts), simulation.terrain,
             world_params_at(simulation, start.X_WB),
             posture_on(sim3d::Terrain(simulation.terrain, simulation.seed), this->robot(), start)),
      broken_(world_, resolved(simulation.plant.parts, this->robot()), recording::body_of(world_),
              simulation.control_dt, kSettle, simulation.seed),
      plant_(broken_, this->robot(), simulation.plant.faults, simulation.control_dt,
             simulation.seed),
      falling_speed_(falling_speed(this->robot())) {
  settle();
}

void SimulatedWalk::settle() {
  listen();
  take_over();
  for (double t = 0.0; t < kSettle; t += control_dt())
    exchange({heading_control::Heading::stop(), kEndless});
  take_over();
  frames().start(world_.truth(), measurement().q);
}

void SimulatedWalk::observe() {
  const GroundTruth& truth = world_.truth();
  frames().observe(truth, measurement().q, world_.efforts());
  sits_ = truth.base_touches_ground && (sits_ || performs());
  const bool hit = truth.base_touches_ground && !sits_;
  if (!fell_ && (hit || lies(truth.X_WB) || !truth.finite)) {
    fell_ = true;
    emergency_stop();
  }
}

void SimulatedWalk::push(double angle) {
  const double time = kPushTime * falling_speed_ / kStandardGravity;
  const double impulse = kPushSpeed * falling_speed_ * robot().mass;
  const Vector2 along = impulse / time * unit_vector(angle + place().angle);
  world_.push({along.x(), along.y(), 0.0}, time);
}

}  // namespace hexagait::viewer

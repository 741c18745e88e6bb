// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <hexagait/recording/simulation.hpp>

namespace hexagait::recording {

double physics_step_for(double control_dt, double usual) {
  return control_dt / std::ceil(control_dt / usual - 1e-9);
}

sim3d::WorldParams world_params(const Simulation& simulation) {
  sim3d::WorldParams params = simulation.plant.world;
  params.physics_dt = simulation.physics_dt;
  params.control_dt = simulation.control_dt;
  params.seed = simulation.seed;
  return params;
}

footstep_gen::WalkerParams walker_params(const Simulation& simulation) {
  footstep_gen::WalkerParams params;
  params.control_dt = simulation.control_dt;
  params.sensors = simulation.sensors;
  params.gait.adjustment = simulation.gait.adjustment;
  params.stepper = simulation.gait.stepper;
  return params;
}

walk::Summary simulate(const RobotModel& robot, const Simulation& simulation,
                       const walk::Observer& observer, const std::atomic<bool>* stop) {
  sim3d::World world(robot, simulation.terrain, world_params(simulation),
                     walk::random_posture(robot, simulation.random_posture, simulation.seed));
  walk::FaultyPlant plant(world, robot, simulation.plant.faults, simulation.control_dt,
                          simulation.seed);
  footstep_gen::Walker walker(robot, walker_params(simulation));

  const auto watch = [&](const auto& record, const auto& truth, const auto& referee) {
    if (observer) observer(record, truth, referee);
    if (stop != nullptr && stop->load()) walker.emergency_stop();
  };
  return walk::run_trial(walker, plant, world.truth(), simulation.trial, watch);
}

}  // namespace hexagait::recording

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/recording/simulation.hpp>

namespace hexagait::recording {

walk::Summary simulate(const RobotModel& robot, const Simulation& simulation,
                       const walk::Observer& observer, const std::atomic<bool>* stop) {
  sim3d::WorldParams world_params;
  world_params.physics_dt = simulation.physics_dt;
  world_params.control_dt = simulation.control_dt;
  world_params.seed = simulation.seed;
  sim3d::World world(robot, simulation.terrain, world_params,
                     walk::random_posture(robot, simulation.random_posture, simulation.seed));

  footstep_gen::WalkerParams walker_params;
  walker_params.control_dt = simulation.control_dt;
  walker_params.sensors = simulation.sensors;
  walker_params.gait.adjustment = simulation.gait.adjustment;
  walker_params.stepper = simulation.gait.stepper;
  footstep_gen::Walker walker(robot, walker_params);

  const auto watch = [&](const auto& record, const auto& truth, const auto& referee) {
    if (observer) observer(record, truth, referee);
    if (stop != nullptr && stop->load()) walker.emergency_stop();
  };
  return walk::run_trial(walker, world, world.truth(), simulation.trial, watch);
}

}  // namespace hexagait::recording

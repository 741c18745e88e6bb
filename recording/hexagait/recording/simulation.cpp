// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <hexagait/recording/simulation.hpp>

namespace hexagait::recording {

sim3d::WorldParams world_params(const PlantSetup& setup, const PlantParams& robot) {
  sim3d::WorldParams params = setup.world;
  static_cast<PlantParams&>(params) = robot;
  if (!is_derived(setup.world.contact_threshold))
    params.contact_threshold = setup.world.contact_threshold;
  return params;
}

sim3d::WorldParams world_params(const Simulation& simulation) {
  sim3d::WorldParams params = world_params(simulation.plant, simulation.params.plant);
  params.physics_dt = simulation.physics_dt;
  params.control_dt = simulation.control_dt;
  params.seed = simulation.seed;
  return params;
}

void complete(Simulation& simulation, const RobotModel& robot) {
  const sim3d::WorldParams world = completed(world_params(simulation), robot);
  simulation.physics_dt = world.physics_dt;
  simulation.plant.world.contact_threshold = world.contact_threshold;
}

footstep_gen::WalkerParams walker_params(const Simulation& simulation) {
  footstep_gen::WalkerParams params;
  params.control_dt = simulation.control_dt;
  params.late_limit = simulation.late_limit;
  params.sensors = simulation.gait.open_loop ? SensorMask{false, false, false} : simulation.sensors;
  params.gait.adjustment = simulation.gait.adjustment;
  params.gait.tie_tolerance = simulation.params.tolerance.tie;
  params.stepper = simulation.gait.stepper;
  params.step = simulation.params.step;
  params.executor.swing = simulation.params.swing;
  params.executor.base = simulation.params.base;
  params.tolerance = simulation.params.tolerance;
  return params;
}

walk::BodyAccess body_of(sim3d::World& world) {
  return {[&](LegId leg) { world.cut(leg); },
          [&](LegId leg, int joint, double share) { world.weaken(leg, joint, share); },
          [&](const Vector2& force_B, double seconds) {
            const Vector3 force_W = world.truth().X_WB.R * Vector3(force_B.x(), force_B.y(), 0.0);
            world.push({force_W.x(), force_W.y(), 0.0}, seconds);
          }};
}

walk::Summary simulate(const RobotModel& robot, const Simulation& simulation,
                       const walk::Observer& observer, const std::atomic<bool>* stop) {
  if (!observer) return simulate_in_world(robot, simulation, {}, stop);
  return simulate_in_world(
      robot, simulation,
      [&](const auto& record, const auto& truth, const auto& referee, const sim3d::World&) {
        observer(record, truth, referee);
      },
      stop);
}

walk::Summary simulate_in_world(const RobotModel& robot, const Simulation& simulation,
                                const WorldObserver& observer, const std::atomic<bool>* stop) {
  const std::vector<walk::PartFault> faults = resolved(simulation.plant.parts, robot);
  sim3d::World world(with_loads(robot, faults), simulation.terrain, world_params(simulation),
                     walk::random_posture(robot, simulation.random_posture, simulation.seed));
  walk::PartFaultPlant broken(world, faults, body_of(world), simulation.control_dt,
                              simulation.trial.settle, simulation.seed);
  walk::FaultyPlant plant(broken, robot, simulation.plant.faults, simulation.control_dt,
                          simulation.seed);
  footstep_gen::Walker walker(robot, walker_params(simulation));

  const auto watch = [&](const auto& record, const auto& truth, const auto& referee) {
    if (observer) observer(record, truth, referee, world);
    if (stop != nullptr && stop->load()) walker.emergency_stop();
  };
  walk::TrialOptions trial = simulation.trial;
  trial.referee = simulation.params.referee;
  return walk::run_trial(walker, plant, world.truth(), trial, watch);
}

}  // namespace hexagait::recording

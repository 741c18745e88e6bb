// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <hexagait/gait_state/gait_choice.hpp>
#include <hexagait/recording/plant_setup.hpp>
#include <hexagait/walk/trial.hpp>
#include <string>

namespace hexagait::recording {

/// A walk of a robot in the simulator, as a value: everything that decides how it goes.
struct Simulation {
  sim3d::TerrainSpec terrain;
  std::uint64_t seed = 1;        ///< of terrain, random posture, and all that is drawn of the plant
  double physics_dt = kDerived;  ///< physics step [s]
  double control_dt = 0.002;     ///< control period, a whole number of physics steps [s]
  RobotParams params;            ///< what is kDerived follows from the robot's model
  PlantSetup plant;              ///< what is not ideal about the robot, its sensors and the ground
  SensorMask sensors;
  double late_limit = footstep_gen::WalkerParams{}.late_limit;  ///< see WalkerParams [s]
  gait_state::GaitChoice gait;  ///< until the schedule says otherwise
  double random_posture = 0.0;  ///< feet start displaced by up to this [m]
  walk::TrialOptions trial;
};

/// Sets what is kDerived of steps of time and plant, for reports.
void complete(Simulation& simulation, const RobotModel& robot);

/// The world of a robot with these drives and feet, and with the imperfections of the setup.
[[nodiscard]] sim3d::WorldParams world_params(const PlantSetup& setup, const PlantParams& robot);

/// The world and the controller of a simulation.
[[nodiscard]] sim3d::WorldParams world_params(const Simulation& simulation);
[[nodiscard]] footstep_gen::WalkerParams walker_params(const Simulation& simulation);

/// What faults do to the body of a robot in a world, which must outlive it. Pushes are level.
[[nodiscard]] walk::BodyAccess body_of(sim3d::World& world);

/// Called after every tick, with the world as well.
using WorldObserver = std::function<void(const footstep_gen::TickRecord&, const GroundTruth&,
                                         const walk::Referee&, const sim3d::World&)>;

/// Walks it.
/// @param observer  called after every tick
/// @param stop      once true, the walker makes an emergency stop and the walk ends
/// @throws InvalidInput  if no world can be made from these parameters, or the schedule is empty
[[nodiscard]] walk::Summary simulate(const RobotModel& robot, const Simulation& simulation,
                                     const walk::Observer& observer = {},
                                     const std::atomic<bool>* stop = nullptr);
[[nodiscard]] walk::Summary simulate_in_world(const RobotModel& robot, const Simulation& simulation,
                                              const WorldObserver& observer,
                                              const std::atomic<bool>* stop = nullptr);

}  // namespace hexagait::recording

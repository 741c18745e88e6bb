// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/footstep_gen/tick_record.hpp>
#include <hexagait/gait_state/gait_choice.hpp>
#include <hexagait/sim2d/genghis_controller.hpp>
#include <hexagait/sim2d/genghis_world.hpp>
#include <hexagait/sim2d/terrain2d.hpp>
#include <limits>

namespace hexagait::sim2d {

/// A walk of Genghis in the side view, as a value: everything that decides how it goes.
struct GenghisTrial {
  TerrainSpec2d terrain;
  gait_state::GaitChoice gait;
  std::uint64_t seed = 1;                                     ///< of terrain and posture
  double seconds = 40.0;                                      ///< how long, at most [s]
  double distance = std::numeric_limits<double>::infinity();  ///< how far, at most [m]
  double random_posture = 0.0;  ///< feet start displaced fore or aft by up to this [m]
  bool backward = false;
  double physics_dt = 0.0025;  ///< [s]
  double control_dt = 0.005;   ///< a whole number of physics steps [s]
  GenghisParams controller;    ///< its gait, direction and period are those above
};

/// @throws InvalidInput  listing every number of a trial that is out of range
void check(const GenghisTrial& trial, const GenghisModel& model);

/// The world and the controller of a trial, at rest on its feet and before the first tick.
/// @throws InvalidInput  if no world can be made from the trial
[[nodiscard]] GenghisWorld settled_world(const GenghisTrial& trial, const GenghisModel& model);
[[nodiscard]] GenghisController controller(const GenghisTrial& trial, const GenghisModel& model);

/// Genghis as a robot in space, for referee, recording and figures: names, hips, workspaces, body.
/// Its joints are swing [rad] and lift [m]; it can't be walked by the walker of robots in space.
[[nodiscard]] RobotModel robot_in_space(const GenghisModel& model);

/// The record of a tick in the words of the walker of robots in space, as far as Genghis has them.
/// It has no odometry: X_OB of the state is NaN.
/// @param record  is overwritten; the same one every time
void record_in_space(const GenghisModel& model, const GenghisParams& params,
                     const GenghisRecord& genghis, footstep_gen::TickRecord& record);

}  // namespace hexagait::sim2d

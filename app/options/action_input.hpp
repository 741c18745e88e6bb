// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/action/action.hpp>
#include <hexagait/script/preview.hpp>
#include <hexagait/sim3d/terrain.hpp>
#include <hexagait/walk/start_posture.hpp>
#include <string>
#include <vector>

#include "options/plant_options.hpp"
#include "options/robot_options.hpp"

namespace hexagait::app {

/// `hexagait run` or `check` as it was typed. An empty text is an option that was not given.
struct ActionArguments {
  std::string action;  ///< file, or name of an action that comes with hexagait
  std::string robot = "argos", start = "standing", terrain = "flat", seed = "1";
  std::string controller = "kinematic";  ///< of `run`
  RobotOverrides overrides;
  std::vector<std::string> set;  ///< NAME=VALUE, of a placeholder or of a parameter of the robot
  std::string params;            ///< a file of parameters
  PlantArguments plant;          ///< of `run`
  bool json = false, quiet = false;
  bool preview = false, force = false;
  std::string preview_plot, plot, record, html;
};

/// What was typed, read.
struct ActionInput {
  std::string file;
  RobotModel robot;
  action::Action action;
  walk::StartPosture start;
  sim3d::TerrainSpec terrain;
  std::uint64_t seed = 1;
  recording::PlantSetup plant;
  WholeBodyController controller = WholeBodyController::kinematic;
  RobotParams params;  ///< of the robot, complete
};

/// Everything that the options name is there and makes sense.
/// @throws InvalidInput  naming what is wrong, with the word that was probably meant
[[nodiscard]] ActionInput action_input(const ActionArguments& arguments);

/// Plays it ahead from its start: what is planned, which is the same with any controller.
[[nodiscard]] Preview preview(const ActionInput& input,
                              const std::function<void(const ActionRecord&)>& observe = {});

}  // namespace hexagait::app

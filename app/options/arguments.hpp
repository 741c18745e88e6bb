// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <hexagait/recording/simulation.hpp>
#include <hexagait/sim2d/genghis.hpp>
#include <string>
#include <vector>

#include "options/plant_options.hpp"
#include "options/robot_options.hpp"

namespace hexagait::app {

/// `hexagait walk` as it was typed. An empty text is an option that was not given.
struct WalkArguments {
  std::string robot = "argos";
  RobotOverrides overrides;
  std::vector<std::string> set;  ///< NAME=VALUE
  std::string params, speed;
  std::string radius, crab, spin, commands, random_commands;
  std::string path, facing, localise, look_ahead, laps;
  std::string gait, duty_factor;
  std::string terrain = "flat";
  std::string seed = "1", distance;
  std::string seconds;  ///< if not given 40, along a path as long as that may take
  std::string random_posture, physics_step, control_period;
  bool no_contacts = false, no_joint_feedback = false;
  PlantArguments plant;
  bool json = false, quiet = false, teleop = false;
  std::string plot, trace, movie, record, html;
};

/// What was typed, as a simulation.
/// @throws InvalidInput  naming the first option that is wrong, its value, and what would be right
[[nodiscard]] recording::Simulation simulation(const WalkArguments& arguments,
                                               const RobotModel& robot);

/// The parameters that were given, those of later sources first: `set`, the file `params`, the file
/// beside the robot's; the others are kDerived.
/// @throws InvalidInput  naming what is wrong
[[nodiscard]] RobotParams given_params(const std::string& robot, const std::string& params,
                                       const std::vector<std::string>& set);

/// The robot of the side view, which has no file.
inline constexpr const char* kGenghis = "genghis2d";

/// What was typed, as a walk of Genghis in the side view.
/// @throws InvalidInput  naming the first option that is wrong or makes no sense there
[[nodiscard]] sim2d::GenghisTrial genghis_trial(const WalkArguments& arguments);

/// At which a robot walks straight on over flat ground, or nearly so [m/s].
[[nodiscard]] double usual_speed(const RobotScale& scale);

/// What --seconds says [s]. @throws InvalidInput
[[nodiscard]] double time_limit(const std::string& text);

/// What --late-limit says [s]. @throws InvalidInput
[[nodiscard]] double late_limit(const std::string& text);

/// A whole number of 0 or more. @throws InvalidInput
[[nodiscard]] std::uint64_t seed(const std::string& text);

/// Where robots or actions lie: in ../share/hexagait beside the command, else in the folder that the
/// environment variable HEXAGAIT_DATA names.
[[nodiscard]] std::filesystem::path shared_directory(const std::string& name);

/// The names of what comes with hexagait, in order: the files of a suffix in a folder.
[[nodiscard]] std::vector<std::string> known_names(const char* folder, const char* suffix);

/// The file of something: a path, or a name that comes with hexagait; else a file of that name in the
/// working directory.
/// @param what  begins the message
/// @param more  a name that is known besides, or empty
/// @throws InvalidInput  if there is none, with the one that was probably meant
[[nodiscard]] std::string shared_file(const char* what, const std::string& name, const char* folder,
                                      const char* suffix, const std::string& more = "");

/// The file of a robot: a path to a URDF, or the name of a robot that comes with hexagait.
/// @throws InvalidInput  if there is none, with the names that there are
[[nodiscard]] std::string robot_file(const std::string& robot);

}  // namespace hexagait::app

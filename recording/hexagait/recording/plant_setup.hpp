// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <hexagait/sim3d/world.hpp>
#include <hexagait/walk/faults/faults.hpp>
#include <hexagait/walk/faults/part_faults.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hexagait::recording {

/// How a simulated robot differs from an ideal one, in the world, and between it and the
/// controller. As text, for command lines and sweep files, a preset and what differs from it:
///
///     ideal    real    joint_noise:2mrad    real+friction:0.4+servo:position_only    dead:LF@5s
struct PlantSetup {
  std::string name = "ideal";  ///< as it was written
  sim3d::WorldParams world;    ///< of which only sim3d::imperfections() count
  walk::PlantFaults faults;
  std::vector<walk::PartFault> parts;  ///< faults of single legs, joints and sensors, loads, pushes

  [[nodiscard]] bool is_ideal() const;  ///< each number and switch is as by default
};

/// A number of a PlantSetup.
struct PlantNumber {
  const char* name;
  PlantUnit unit;
  double least, greatest;
  const char* meaning;
  double sim3d::WorldParams::*of_world;  ///< null if it is a fault's
  double walk::PlantFaults::*of_faults;  ///< null if it is the world's

  /// 0 if it is kDerived: then it is the robot's.
  [[nodiscard]] double of(const PlantSetup& setup) const {
    const double value = of_world != nullptr ? setup.world.*of_world : setup.faults.*of_faults;
    return is_derived(value) ? 0.0 : value;
  }
};
[[nodiscard]] const std::vector<PlantNumber>& plant_numbers();

/// Its name in JSON and tables, with its unit: "joint_noise_rad".
[[nodiscard]] std::string name_with_unit(const PlantNumber& number);

/// What may be written for it: "an angle from 0 to 0.2 rad, such as 0.5mrad".
[[nodiscard]] std::string expected(const PlantNumber& number);

/// A part of a PlantSetup that is one of two words.
struct PlantSwitch {
  const char* name;
  const char* words[2];                ///< for false and for true
  const char* meaning;                 ///< a line of --help
  bool sim3d::WorldParams::*of_world;  ///< null if it is a fault's
  bool walk::PlantFaults::*of_faults;  ///< null if it is the world's

  [[nodiscard]] bool of(const PlantSetup& setup) const {
    return of_world != nullptr ? setup.world.*of_world : setup.faults.*of_faults;
  }
};
[[nodiscard]] std::span<const PlantSwitch> plant_switches();

/// A plant with a name.
struct PlantPreset {
  std::string_view name, meaning;
  PlantSetup setup;
};
[[nodiscard]] const std::vector<PlantPreset>& plant_presets();

/// What is wrong with one value, or empty: then the setup has it.
/// @param key     name of a number or a switch
/// @param spoken  how the message calls it: "--joint-noise"
[[nodiscard]] std::string set(PlantSetup& setup, std::string_view key, const std::string& value,
                              const std::string& spoken);

/// Adds faults of parts to a setup and its name. @throws InvalidInput  with all that are none
void add_faults(PlantSetup& setup, std::span<const std::string> faults);

/// Reads what is above. @throws InvalidInput  with everything that is wrong, a line each
[[nodiscard]] PlantSetup parse_plant(const std::string& text);

}  // namespace hexagait::recording

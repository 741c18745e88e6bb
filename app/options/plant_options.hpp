// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <hexagait/recording/plant_setup.hpp>
#include <map>
#include <string>

namespace hexagait::app {

/// What was typed of the plant: --plant, and an option per number of it, by name. An empty text is
/// an option that was not given.
struct PlantArguments {
  std::string plant = "ideal";
  std::vector<std::string> faults = {};  ///< of single parts
  std::map<std::string, std::string> values = {};

  [[nodiscard]] bool given() const;  ///< anything that is not the ideal plant
};

/// Adds the options, and where what is typed goes.
void add_plant(CLI::App& command, PlantArguments& arguments);

/// What was typed, as a plant: options override what --plant says.
/// @throws InvalidInput  listing all options that are wrong, their values, and what would be right
[[nodiscard]] recording::PlantSetup plant(const PlantArguments& arguments);

}  // namespace hexagait::app

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include "options/arguments.hpp"
#include "options/page_options.hpp"

namespace hexagait::app {

/// `hexagait steer` as it was typed.
struct SteerArguments {
  WalkArguments walk;  ///< of which steer has only some options
  PageAddress address;
  std::string speed = "1";
  std::string live;                  ///< command line of a live robot's program
  std::string late_limit = "100ms";  ///< longest time without a state of a live robot
  bool headless = false;
};

/// Adds `hexagait steer`, and where what is typed goes.
void add_steer(CLI::App& app, SteerArguments& arguments);

/// `hexagait steer`: serves the page until Ctrl-C. @throws InvalidInput
int steer_command(const SteerArguments& arguments);

}  // namespace hexagait::app

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include "arguments.hpp"

namespace hexagait::app {

/// `hexagait steer` as it was typed.
struct SteerArguments {
  WalkArguments walk;  ///< of which steer has only some options
  std::string port = "8460", bind = "127.0.0.1", speed = "1";
  bool headless = false;
};

/// Adds `hexagait steer`, and where what is typed goes.
void add_steer(CLI::App& app, SteerArguments& arguments);

/// `hexagait steer`: serves the page until Ctrl-C. @throws InvalidInput
int steer_command(const SteerArguments& arguments);

}  // namespace hexagait::app

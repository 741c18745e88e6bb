// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include "options/action_input.hpp"

namespace hexagait::app {

/// Adds `run` and `check` with their options.
void add_run(CLI::App& app, ActionArguments& arguments);
void add_check(CLI::App& app, ActionArguments& arguments);

}  // namespace hexagait::app

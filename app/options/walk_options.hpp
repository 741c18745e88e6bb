// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include "options/arguments.hpp"

namespace hexagait::app {

/// Adds `hexagait walk`, and where what is typed goes.
void add_walk(CLI::App& app, WalkArguments& arguments);

}  // namespace hexagait::app

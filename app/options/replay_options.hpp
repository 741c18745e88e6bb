// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include "options/page_options.hpp"

namespace hexagait::app {

/// `hexagait replay` as it was typed.
struct ReplayArguments {
  std::string file, html;
  PageAddress address;
  bool json = false, quiet = false;
};

/// Adds `hexagait replay`, and where what is typed goes.
void add_replay(CLI::App& app, ReplayArguments& arguments);

/// `hexagait replay`: serves the page until Ctrl-C, or writes it. @throws InvalidInput
int replay_command(const ReplayArguments& arguments);

/// Adds --record and --html of a command that simulates.
void add_replay_files(CLI::App& command, std::string& record, std::string& html);

}  // namespace hexagait::app

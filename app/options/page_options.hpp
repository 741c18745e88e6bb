// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

namespace hexagait::app {

/// Where a page is served, as it was typed.
struct PageAddress {
  std::string port = "8460", bind = "127.0.0.1";
};

/// Adds --port and --bind.
void add_page_address(CLI::App& command, PageAddress& address);

}  // namespace hexagait::app

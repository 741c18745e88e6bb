// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include "options/page_options.hpp"

namespace hexagait::app {

void add_page_address(CLI::App& command, PageAddress& address) {
  command.add_option("--port", address.port, "Of the page; 0: any that is free")
      ->type_name("N")
      ->capture_default_str();
  command
      .add_option("--bind", address.bind,
                  "Address to listen on; any but a loopback one needs a token")
      ->type_name("ADDRESS")
      ->capture_default_str();
}

}  // namespace hexagait::app

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <hexagait/load/load_action.hpp>
#include <hexagait/text/invalid_input.hpp>

// An action is refused for a robot that lacks its legs, by a message that names one.
int main(int, char** argv) {
  try {
    (void)hexagait::action::load_action(std::string(argv[2]) + "/push_up.yaml", {});
  } catch (const hexagait::InvalidInput& error) {
    std::printf("actions: %.40s…\n", error.what());
    return 0;
  }
  return 1;
}

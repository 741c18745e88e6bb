// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/text/invalid_input.hpp>

#include "steer_options.hpp"

namespace hexagait::app {

int steer_command(const SteerArguments& /*arguments*/) {
  throw InvalidInput(
      "steer: this hexagait was built without libwebsockets; install it (Debian: apt-get install "
      "libwebsockets-dev nodejs npm), configure with -DHEXAGAIT_VIEWER=ON and build again, or take "
      "./run steer, which does that");
}

}  // namespace hexagait::app

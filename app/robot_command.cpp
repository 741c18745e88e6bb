// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/recording/json.hpp>

#include "commands.hpp"
#include "output.hpp"
#include "words.hpp"

namespace hexagait::app {

int robot_command(const RobotArguments& arguments) {
  // The table says itself what is not the file's.
  const RobotModel model = load_robot(arguments.robot, arguments.overrides, true);
  print_out(arguments.json ? recording::to_json(model) + "\n" : in_words(model));
  return kOk;
}

}  // namespace hexagait::app

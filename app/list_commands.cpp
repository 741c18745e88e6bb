// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <hexagait/urdf/urdf.hpp>

#include "commands.hpp"
#include "words.hpp"

namespace hexagait::app {

int robot_command(const std::string& robot, bool json) {
  const RobotModel model = load_urdf(robot_file(robot));
  fmt::print("{}", json ? recording::to_json(model) + "\n" : in_words(model));
  return kOk;
}

int terrains_command() {
  for (const sim3d::TerrainDescription& terrain : sim3d::known_terrains())
    fmt::print("{:<10} {}\n", terrain.syntax, terrain.meaning);
  fmt::print("\nIn the side view (--robot {}):\n", kGenghis);
  for (const sim2d::TerrainDescription2d& terrain : sim2d::known_terrains2d())
    fmt::print("{:<10} {}\n", terrain.syntax, terrain.meaning);
  return kOk;
}

}  // namespace hexagait::app

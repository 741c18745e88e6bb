// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <hexagait/text/invalid_input.hpp>
#include <vector>

#include "arguments.hpp"

namespace hexagait::app {
namespace {

namespace fs = std::filesystem;

std::string known_robots() {
  std::vector<std::string> names;
  std::error_code error;
  for (const fs::directory_entry& file : fs::directory_iterator(shared_directory("robots"), error))
    if (file.path().extension() == ".urdf") names.push_back(file.path().stem());
  std::ranges::sort(names);
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

fs::path shared_directory(const std::string& name) {
  std::error_code error;
  const fs::path command = fs::read_symlink("/proc/self/exe", error);
  return command.parent_path().parent_path() / "share/hexagait" / name;
}

std::string robot_file(const std::string& robot) {
  const bool is_path = robot.find('/') != std::string::npos || robot.ends_with(".urdf");
  const fs::path file = is_path ? fs::path(robot) : shared_directory("robots") / (robot + ".urdf");
  std::error_code error;
  if (fs::is_regular_file(file, error)) return file;
  if (fs::exists(file, error))
    throw InvalidInput(fmt::format("--robot is '{}', which is not a file", robot));
  throw InvalidInput(
      fmt::format("--robot is '{}', which does not exist; give the path of a URDF file, or one of "
                  "the robots that come with hexagait: {}; {} walks in a side view, without a file",
                  robot, known_robots(), kGenghis));
}

}  // namespace hexagait::app

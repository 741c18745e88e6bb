// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/nearest_word.hpp>
#include <optional>

#include "options/arguments.hpp"

namespace hexagait::app {
namespace {

namespace fs = std::filesystem;

// A file of this path, or one of this name that comes with hexagait; empty if there is none.
std::optional<fs::path> find(const std::string& name, const char* folder, const char* suffix) {
  const bool is_path = name.find('/') != std::string::npos || fs::path(name).extension() == suffix;
  std::error_code ignored;
  const fs::path known = shared_directory(folder) / (name + suffix);
  if (!is_path && fs::is_regular_file(known, ignored)) return known;
  if (fs::is_regular_file(name, ignored)) return name;
  return {};
}

}  // namespace

fs::path shared_directory(const std::string& name) {
  std::error_code error;
  const fs::path command = fs::read_symlink("/proc/self/exe", error);
  const fs::path beside = command.parent_path().parent_path() / "share/hexagait" / name;
  if (!error && fs::is_directory(beside, error)) return beside;
  const char* const data = std::getenv("HEXAGAIT_DATA");
  return data != nullptr ? fs::path(data) / name : beside;
}

std::vector<std::string> known_names(const char* folder, const char* suffix) {
  std::vector<std::string> names;
  std::error_code error;
  for (const fs::directory_entry& file : fs::directory_iterator(shared_directory(folder), error))
    if (file.path().extension() == suffix) names.push_back(file.path().stem());
  std::ranges::sort(names);
  return names;
}

std::string shared_file(const char* what, const std::string& name, const char* folder,
                        const char* suffix, const std::string& more) {
  if (const std::optional<fs::path> file = find(name, folder, suffix)) return *file;
  std::error_code ignored;
  if (fs::exists(name, ignored))
    throw InvalidInput(fmt::format("{} is '{}', which is not a file", what, name));
  if (!name.ends_with(suffix) && fs::is_regular_file(name + suffix, ignored))
    throw InvalidInput(fmt::format("{} is '{}', which does not exist; did you mean '{}{}'?", what,
                                   name, name, suffix));
  std::vector<std::string> known = known_names(folder, suffix);
  if (known.empty())
    throw InvalidInput(
        fmt::format("{} is '{}', which does not exist; the {} that come with hexagait are not in "
                    "{} either; set "
                    "HEXAGAIT_DATA to the folder that holds {}/",
                    what, name, folder, shared_directory(folder).string(), folder));
  if (!more.empty()) known.push_back(more);
  throw InvalidInput(fmt::format(
      "{} is '{}', which does not exist{}; give the path of a {} file, or one of the {} that come "
      "with hexagait: {}",
      what, name, did_you_mean(fs::path(name).stem().string(), known),
      folder == std::string_view("robots") ? "URDF" : "YAML", folder, fmt::join(known, ", ")));
}

std::string robot_file(const std::string& robot) {
  return shared_file("--robot", robot, "robots", ".urdf", kGenghis);
}

}  // namespace hexagait::app

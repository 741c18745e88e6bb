// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include "action_input.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <hexagait/load/load_action.hpp>
#include <hexagait/load/load_step_goal.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/nearest_word.hpp>
#include <hexagait/text/text_file.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <hexagait/yaml/yaml_tree.hpp>

#include "arguments.hpp"

namespace hexagait::app {
namespace {

namespace fs = std::filesystem;

/// " (did you mean 'nod'?)", or nothing if no word is near.
std::string hint(const std::string& word, const std::vector<std::string>& known) {
  const std::optional<std::string> meant = nearest_word(word, known);
  return meant ? fmt::format(" (did you mean '{}'?)", *meant) : "";
}

std::string action_file(const std::string& action) {
  const bool is_path = action.find('/') != std::string::npos || action.ends_with(".yaml") ||
                       action.ends_with(".yml");
  const fs::path file =
      is_path ? fs::path(action) : shared_directory("actions") / (action + ".yaml");
  std::error_code error;
  if (fs::is_regular_file(file, error)) return file;
  if (fs::exists(file, error)) throw InvalidInput(fmt::format("action '{}' is not a file", action));
  const std::vector<std::string> known = known_actions();
  throw InvalidInput(fmt::format(
      "action '{}' does not exist{}; give the path of a YAML file, or one of the actions that come "
      "with hexagait: {}",
      action, hint(fs::path(action).stem().string(), known), fmt::join(known, ", ")));
}

std::map<std::string, std::string> placeholders(const std::vector<std::string>& set) {
  std::map<std::string, std::string> values;
  for (const std::string& text : set) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
      throw InvalidInput(fmt::format("--set is '{}'; it must be NAME=VALUE", text));
    values[text.substr(0, equals)] = text.substr(equals + 1);
  }
  return values;
}

// Goals of 2015 number their steps; actions have no such key.
bool is_step_goal(const std::string& text) {
  return text.find("step_number:") != std::string::npos;
}

action::Action load(const std::string& file, const RobotModel& robot,
                    const std::vector<std::string>& set) {
  const std::string text = read_text(file, kMaxYamlText);
  action::ActionVocabulary vocabulary;
  vocabulary.placeholders = placeholders(set);
  if (!is_step_goal(text)) return action::parse_action(text, file, robot, vocabulary);
  if (!set.empty())
    throw InvalidInput(
        fmt::format("--set is '{}', but {} is a step goal of 2015, which has no "
                    "placeholders",
                    set.front(), file));
  return action::parse_step_goal(text, file, robot).action;
}

walk::StartKind start_kind(const std::string& start) {
  if (start == "standing") return walk::StartKind::standing;
  if (start == "sitting") return walk::StartKind::sitting;
  if (start == "lying") return walk::StartKind::lying;
  throw InvalidInput(fmt::format("--start is '{}'; it must be standing, sitting or lying", start));
}

WholeBodyController controller(const std::string& name) {
  std::vector<std::string> words;
  for (const auto known : {WholeBodyController::kinematic, WholeBodyController::virtual_model}) {
    if (name == to_string(known)) return known;
    words.emplace_back(to_string(known));
  }
  throw InvalidInput(fmt::format("--controller is '{}'{}; it must be {}", name, hint(name, words),
                                 fmt::join(words, " or ")));
}

}  // namespace

std::vector<std::string> known_actions() {
  std::vector<std::string> names;
  std::error_code error;
  for (const fs::directory_entry& file : fs::directory_iterator(shared_directory("actions"), error))
    if (file.path().extension() == ".yaml") names.push_back(file.path().stem());
  std::ranges::sort(names);
  return names;
}

ActionInput action_input(const ActionArguments& arguments) {
  ActionInput input;
  input.file = action_file(arguments.action);
  input.robot = load_urdf(robot_file(arguments.robot));
  input.seed = seed(arguments.seed);
  input.terrain = sim3d::parse_terrain(arguments.terrain);
  input.controller = controller(arguments.controller);
  input.start = walk::start_posture(input.robot, start_kind(arguments.start), input.seed);
  input.action = load(input.file, input.robot, arguments.set);
  return input;
}

Preview preview(const ActionInput& input, const std::function<void(const ActionRecord&)>& observe) {
  PreviewParams params;
  params.rests_on = input.start.rests_on;
  return hexagait::preview(input.robot, input.start.q, input.action, params, observe);
}

}  // namespace hexagait::app

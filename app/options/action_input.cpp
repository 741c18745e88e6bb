// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include "options/action_input.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/nearest_word.hpp>
#include <hexagait/text/text_file.hpp>
#include <hexagait/text/violations.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <hexagait/walk/actions/action_check.hpp>
#include <hexagait/yaml/placeholders.hpp>
#include <hexagait/yaml/yaml_tree.hpp>

#include "options/arguments.hpp"

namespace hexagait::app {
namespace {

// Parameters of robots have a dot in their names, placeholders have none.
bool is_parameter(const std::string& text) {
  const std::size_t dot = text.find('.');
  return dot != std::string::npos && dot < text.find('=');
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

// A value that nothing in the file asks for was meant for something else.
void check_placeholders(const std::string& text, const std::string& file,
                        const std::map<std::string, std::string>& set) {
  if (set.empty()) return;
  Violations violations(file);
  const std::vector<std::string> known = placeholder_names(parse_yaml(text, file, violations));
  for (const auto& [name, value] : set)
    if (std::ranges::find(known, name) == known.end())
      throw InvalidInput(
          fmt::format("--set is '{}={}', but {} has no placeholder '{}'{}; it has {}", name, value,
                      file, name, did_you_mean(name, known),
                      known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", "))));
}

action::Action load(const std::string& file, const RobotModel& robot,
                    const std::vector<std::string>& set) {
  const std::string text = read_text(file, kMaxYamlText);
  action::ActionVocabulary vocabulary;
  vocabulary.placeholders = placeholders(set);
  if (!walk::is_step_goal(text))
    check_placeholders(text, file, vocabulary.placeholders);
  else if (!set.empty())
    throw InvalidInput(
        fmt::format("--set is '{}', but {} is a step goal of 2015, which has no "
                    "placeholders",
                    set.front(), file));
  return walk::action_for(text, file, robot, vocabulary,
                          [](const std::string& name) { return load_urdf(robot_file(name)); });
}

walk::StartKind start_kind(const std::string& start) {
  if (start == "standing") return walk::StartKind::standing;
  if (start == "sitting") return walk::StartKind::sitting;
  if (start == "lying") return walk::StartKind::lying;
  const std::vector<std::string> words = {"standing", "sitting", "lying"};
  throw InvalidInput(fmt::format("--start is '{}'{}; it must be standing, sitting or lying", start,
                                 did_you_mean(start, words)));
}

WholeBodyController controller(const std::string& name) {
  std::vector<std::string> words;
  for (const auto known : {WholeBodyController::kinematic, WholeBodyController::virtual_model}) {
    if (name == to_string(known)) return known;
    words.emplace_back(to_string(known));
  }
  throw InvalidInput(fmt::format("--controller is '{}'{}; it must be {}", name,
                                 did_you_mean(name, words), fmt::join(words, " or ")));
}

}  // namespace

ActionInput action_input(const ActionArguments& arguments) {
  ActionInput input;
  input.file = shared_file("action", arguments.action, "actions", ".yaml");
  input.robot = load_robot(arguments.robot, arguments.overrides, arguments.quiet);
  input.seed = seed(arguments.seed);
  input.terrain = sim3d::parse_terrain(arguments.terrain);
  input.controller = controller(arguments.controller);
  input.plant = plant(arguments.plant);
  input.plant.parts = resolved(std::move(input.plant.parts), input.robot);
  if (input.plant.faults.positions_only && input.controller == WholeBodyController::virtual_model)
    throw InvalidInput(
        "--controller is virtual_model, which drives legs by efforts; --servo position-only takes "
        "none");
  input.start = walk::start_posture(input.robot, start_kind(arguments.start), input.seed);
  std::vector<std::string> placeholders, parameters;
  std::ranges::partition_copy(arguments.set, std::back_inserter(parameters),
                              std::back_inserter(placeholders), is_parameter);
  input.params =
      completed(given_params(arguments.robot, arguments.params, parameters), input.robot);
  input.action = load(input.file, input.robot, placeholders);
  return input;
}

Preview preview(const ActionInput& input, const std::function<void(const ActionRecord&)>& observe) {
  PreviewParams params;
  params.runner = walk::runner_params(input.params);
  params.rests_on = input.start.rests_on;
  return hexagait::preview(input.robot, input.start.q, input.action, params, observe);
}

}  // namespace hexagait::app

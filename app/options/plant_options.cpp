// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include "options/plant_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <hexagait/text/invalid_input.hpp>

#include "options/usage.hpp"

namespace hexagait::app {
namespace {

// "joint_noise" as an option.
std::string option(std::string name) {
  std::ranges::replace(name, '_', '-');
  return "--" + name;
}

const char* type_name(PlantUnit unit) {
  switch (unit) {
    case PlantUnit::number:
      return "MU";
    case PlantUnit::share:
      return "SHARE";
    case PlantUnit::angle:
      return "ANGLE";
    case PlantUnit::time:
      return "TIME";
    case PlantUnit::force:
      return "FORCE";
    case PlantUnit::torque:
      return "TORQUE";
    case PlantUnit::inertia:
      return "INERTIA";
    case PlantUnit::acceleration:
      return "ACCELERATION";
    case PlantUnit::angular_rate:
      return "RATE";
  }
  return "";
}

}  // namespace

bool PlantArguments::given() const {
  return plant != "ideal" || !faults.empty() ||
         std::ranges::any_of(values, [](const auto& value) { return !value.second.empty(); });
}

void add_plant(CLI::App& command, PlantArguments& a) {
  command
      .add_option("--plant", a.plant,
                  "What is not ideal: ideal, real, or one of them with changes, such as "
                  "real+friction:0.4; see hexagait list plants; the options below override it")
      ->type_name("PLANT")
      ->capture_default_str();
  command
      .add_option("--fault", a.faults,
                  "A fault of one leg, joint or sensor, a load or a push, such as dead:LF@5s: see "
                  "hexagait list faults; may be repeated")
      ->type_name("FAULT")
      ->allow_extra_args(false);
  for (const recording::PlantNumber& number : recording::plant_numbers())
    command
        .add_option(option(number.name), a.values[number.name],
                    fmt::format("{}; {}", number.meaning, recording::expected(number)))
        ->type_name(type_name(number.unit));
  for (const recording::PlantSwitch& one : recording::plant_switches())
    command.add_option(option(one.name), a.values[one.name], one.meaning)
        ->type_name(fmt::format("{}|{}", one.words[0], one.words[1]));
  group(command, "Imperfect robot, sensors and ground");
}

recording::PlantSetup plant(const PlantArguments& arguments) {
  std::vector<std::string> problems;
  recording::PlantSetup setup;
  try {
    setup = recording::parse_plant(arguments.plant);
  } catch (const InvalidInput& error) {
    problems.push_back(fmt::format("--plant: {}", error.what()));
  }
  for (const auto& [name, value] : arguments.values) {
    if (value.empty()) continue;
    const std::string problem = set(setup, name, value, option(name));
    if (!problem.empty()) problems.push_back(problem);
    setup.name = fmt::format("{}{}:{}", setup.name == "ideal" ? "" : setup.name + "+", name, value);
  }
  try {
    add_faults(setup, arguments.faults);
  } catch (const InvalidInput& error) {
    problems.push_back(fmt::format("--fault: {}", error.what()));
  }
  if (!problems.empty()) throw InvalidInput(fmt::format("{}", fmt::join(problems, "\n")));
  return setup;
}

}  // namespace hexagait::app

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/params/set_parameter.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/nearest_word.hpp>
#include <vector>

namespace hexagait {

Dimension dimension_of(const Parameter& parameter) {
  const std::string_view unit = parameter.unit;
  if (unit == "m") return Dimension::length;
  return unit == "s" ? Dimension::time : Dimension::number;
}

bool may_be_zero(const Parameter& parameter) {
  static constexpr std::string_view kOff[] = {"step.stability_margin", "swing.even_load_rate",
                                              "base.displacement_period",
                                              "tolerance.servo_stiffness"};
  return std::ranges::find(kOff, parameter.name) != std::end(kOff);
}

const Parameter& parameter_named(std::string_view name) {
  const auto all = parameters();
  const auto found = std::ranges::find(all, name, &Parameter::name);
  if (found != all.end()) return *found;
  std::vector<std::string> known;
  for (const Parameter& one : all) known.emplace_back(one.name);
  throw InvalidInput("there is no parameter '" + std::string(name) + "'" +
                     did_you_mean(name, known) + "; hexagait robot --params lists them");
}

void set_parameter(RobotParams& params, std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos)
    throw InvalidInput("'" + std::string(text) +
                       "' must be NAME=VALUE, such as step.height=0.04 or step.height=4cm");
  const Parameter& parameter = parameter_named(text.substr(0, equals));
  const auto [value, problem] = parse_quantity(text.substr(equals + 1), dimension_of(parameter));
  if (!problem.empty()) throw InvalidInput(std::string(parameter.name) + ": " + problem);
  const bool zero = may_be_zero(parameter);
  if (!(value > 0.0 || (zero && value == 0.0)))
    throw InvalidInput(std::string(parameter.name) + " is " + std::string(text.substr(equals + 1)) +
                       "; it must be " + (zero ? "0 or greater" : "greater than 0") + " [" +
                       parameter.unit + "]");
  parameter.in(params) = value;
}

}  // namespace hexagait

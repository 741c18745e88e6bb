// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <hexagait/params/params_for.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/nearest_word.hpp>
#include <hexagait/text/quantity.hpp>
#include <hexagait/text/split.hpp>
#include <hexagait/walk/faults/part_faults.hpp>
#include <optional>

/// Faults of parts as text.
namespace hexagait::walk {
namespace {

using Kind = PartFaultKind;

enum class Part : std::uint8_t { none, leg, joint };

// What a kind's fields are: a part, then a value.
struct Fields {
  Part part;
  const char* unit;  // a suffix of the value; of times and angles "s" and "rad"; null: no value
  double least, greatest;
  const char* expected;
};
Fields fields_of(Kind kind) {
  switch (kind) {
    case Kind::dead:
    case Kind::cut:
    case Kind::contact_on:
    case Kind::contact_off:
      return {Part::leg, nullptr, 0.0, 0.0, ""};
    case Kind::weak:
      return {Part::joint, "%", 0.0, 1.0, "a share from 0 to 1, such as 0.5 or 50%"};
    case Kind::contact_noise:
      return {Part::leg, "%", 0.0, 1.0, "a share from 0 to 1, such as 0.1 or 10%"};
    case Kind::contact_late:
      return {Part::leg, "s", 0.0, 1.0, "a time from 0 to 1 s, such as 50ms"};
    case Kind::noise:
    case Kind::bias:
      return {Part::joint, "rad", -0.2, 0.2, "an angle of up to 0.2 rad, such as 5mrad or 1deg"};
    case Kind::load:
      return {Part::none, "kg", 0.0, 1e4, "a mass from 0 to 10000 kg, such as 15kg"};
    case Kind::push:
      return {Part::none, "Ns", 0.0, 1e5, "an impulse from 0 to 100000 N s, such as 50Ns"};
  }
  return {Part::none, nullptr, 0.0, 0.0, ""};
}

[[noreturn]] void refuse(std::string_view text, const std::string& problem) {
  throw InvalidInput(fmt::format("fault '{}': {}", text, problem));
}

std::optional<double> value_in(std::string_view text, const Fields& fields) {
  const std::string_view unit = fields.unit;
  const Dimension dimension = unit == "s"     ? Dimension::time
                              : unit == "rad" ? Dimension::angle
                                              : Dimension::number;
  const bool suffixed = dimension == Dimension::number && text.ends_with(unit);
  if (suffixed) text.remove_suffix(unit.size());
  const auto [value, problem] = parse_quantity(text, dimension);
  if (!problem.empty()) return {};
  const double scaled = suffixed && unit == "%" ? value / 100.0 : value;
  if (!(fields.least <= scaled && scaled <= fields.greatest)) return {};
  return scaled;
}

const PartFaultWords& words_of(std::string_view name, std::string_view text) {
  for (const PartFaultWords& kind : part_fault_kinds()) {
    const std::string_view syntax = kind.syntax;
    if (name == syntax.substr(0, syntax.find(':'))) return kind;
  }
  refuse(text,
         fmt::format("there is no '{}'{}; there are {}", name,
                     did_you_mean(name, part_fault_names()), fmt::join(part_fault_names(), ", ")));
}

double start_in(std::string_view text, std::string_view whole) {
  const auto [value, problem] = parse_quantity(text, Dimension::time);
  if (!problem.empty()) refuse(whole, problem);
  if (value < 0.0)
    refuse(whole, fmt::format("'@{}' is before the walk; 0 s is its beginning", text));
  return value;
}

// A coordinate of a load, on the body.
double coordinate_in(std::string_view text, std::string_view whole) {
  constexpr double kFarthest = 100.0;  // [m]
  const auto [value, problem] = parse_quantity(text, Dimension::length);
  if (!problem.empty()) refuse(whole, problem);
  if (!(std::abs(value) <= kFarthest))
    refuse(whole, fmt::format("'{}' must be a length of up to 100 m, such as 10cm or -0.1", text));
  return value;
}

std::vector<std::string> names_of(const RobotModel& robot, Part part) {
  std::vector<std::string> names;
  for (const LegModel& leg : robot.legs) {
    if (part == Part::leg) names.emplace_back(short_leg_name(leg.name));
    if (part == Part::joint)
      for (const std::string& joint : leg.joint_names) names.push_back(joint);
  }
  return names;
}

bool find_part(PartFault& fault, const RobotModel& robot, Part part) {
  for (LegId i = 0; i < robot.num_legs(); ++i) {
    const LegModel& leg = robot.legs[i];
    if (part == Part::leg && (fault.part == leg.name || fault.part == short_leg_name(leg.name)))
      return fault.leg = i, true;
    for (int k = 0; part == Part::joint && k < leg.num_joints(); ++k)
      if (fault.part == leg.joint_names[k]) return fault.leg = i, fault.joint = k, true;
  }
  return false;
}

}  // namespace

std::span<const PartFaultWords> part_fault_kinds() {
  static constexpr PartFaultWords kAll[] = {
      {Kind::dead, "dead:LEG", "All motors of the leg are dead: it hangs, and drags"},
      {Kind::cut, "cut:LEG", "The leg is cut off; its joints read what they read last"},
      {Kind::weak, "weak:JOINT:SHARE",
       "The joint's servo has this share of its greatest effort left"},
      {Kind::contact_on, "contact_on:LEG", "The foot's contact sensor reads closed, always"},
      {Kind::contact_off, "contact_off:LEG", "The foot's contact sensor reads open, always"},
      {Kind::contact_late, "contact_late:LEG:TIME", "The foot's contact sensor is so late"},
      {Kind::contact_noise, "contact_noise:LEG:SHARE",
       "Probability, per control period, that the foot's contact sensor reads wrong"},
      {Kind::noise, "noise:JOINT:ANGLE", "Noise of the joint's sensor, standard deviation"},
      {Kind::bias, "bias:JOINT:ANGLE", "The joint's zero is off by this, for sensor and servo"},
      {Kind::load, "load:MASS:X:Y",
       "A load on the body that the controller does not know, X ahead and Y to the left of its "
       "origin"},
      {Kind::push, "push:IMPULSE:ANGLE",
       "A push at the base within 0.1 s, 0 forward, 90deg to the left"}};
  return kAll;
}

const std::vector<std::string>& part_fault_names() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> names;
    for (const PartFaultWords& kind : part_fault_kinds()) {
      const std::string syntax = kind.syntax;
      names.push_back(syntax.substr(0, syntax.find(':')));
    }
    return names;
  }();
  return all;
}

std::string example_values(PartFaultKind kind, const RobotModel& robot) {
  switch (kind) {
    case Kind::weak:
      return "50%";
    case Kind::contact_late:
      return "50ms";
    case Kind::contact_noise:
      return "10%";
    case Kind::noise:
      return "5mrad";
    case Kind::bias:
      return "2deg";
    case Kind::load:
      return fmt::format("{:.2g}kg:0:0", 0.3 * robot.mass);
    case Kind::push: {
      const RobotScale scale = scale_of(robot);
      const double speed = 0.25 * std::sqrt(scale.gravity * scale.hip_height);
      return fmt::format("{:.2g}Ns:90deg", speed * robot.mass);
    }
    default:
      return "";
  }
}

PartFault parse_part_fault(std::string_view text) {
  PartFault fault;
  fault.text = text;
  const std::size_t at = text.find('@');
  const auto parts = split(text.substr(0, at), ':');
  const PartFaultWords& words = words_of(parts[0], text);
  fault.kind = words.kind;
  if (parts.size() != split(words.syntax, ':').size())
    refuse(text, fmt::format("it must be {}, and may end in @TIME", words.syntax));
  const bool loaded = fault.kind == Kind::load;
  if (at != std::string_view::npos && loaded)
    refuse(text, "a load is there from the beginning; leave out the @");
  if (at != std::string_view::npos) fault.start = start_in(text.substr(at + 1), text);

  const Fields fields = fields_of(fault.kind);
  std::size_t next = 1;
  if (fields.part != Part::none) fault.part = parts[next++];
  if (fields.unit != nullptr) {
    const auto value = value_in(parts[next], fields);
    if (!value) refuse(text, fmt::format("'{}' must be {}", parts[next], fields.expected));
    fault.value = *value;
    ++next;
  }
  if (loaded)
    fault.place = {coordinate_in(parts[next], text), coordinate_in(parts[next + 1], text)};
  if (fault.kind == Kind::push) {
    const auto [value, problem] = parse_quantity(parts[next], Dimension::angle);
    if (!problem.empty()) refuse(text, problem);
    fault.direction = value;
    if (at == std::string_view::npos) fault.start = 0.0;
  }
  return fault;
}

std::vector<PartFault> resolved(std::vector<PartFault> faults, const RobotModel& robot) {
  std::vector<std::string> problems;
  for (PartFault& fault : faults) {
    const Part part = fields_of(fault.kind).part;
    if (part == Part::none || find_part(fault, robot, part)) continue;
    const std::vector<std::string> known = names_of(robot, part);
    problems.push_back(fmt::format("fault '{}': {} has no {} '{}'{}; it has {}", fault.text,
                                   robot.name, part == Part::leg ? "leg" : "joint", fault.part,
                                   did_you_mean(fault.part, known), fmt::join(known, ", ")));
  }
  if (!problems.empty()) throw InvalidInput(fmt::format("{}", fmt::join(problems, "\n")));
  return faults;
}

}  // namespace hexagait::walk

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include "options/robot_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/quantity.hpp>
#include <hexagait/text/split.hpp>
#include <map>

#include "options/arguments.hpp"
#include "options/usage.hpp"

namespace hexagait::app {
namespace {

constexpr double kRightAngle = 0.5 * std::numbers::pi;

[[noreturn]] void refuse(const char* option, const std::string& text, const std::string& right) {
  throw InvalidInput(fmt::format("{} is '{}'; {}", option, text, right));
}

// A positive quantity, if the option was given.
std::optional<double> positive(const char* option, const std::string& text, Dimension dimension,
                               const char* right) {
  if (text.empty()) return {};
  const Quantity quantity = parse_quantity(text, dimension);
  if (!quantity.problem.empty() || !(quantity.value >= kSmallestQuantity))
    refuse(option, text, fmt::format("it must be {}, and positive", right));
  return quantity.value;
}

std::optional<double> front(const std::string& text) {
  static const std::map<std::string, double> kAxes = {{"+x", 0.0},
                                                      {"x", 0.0},
                                                      {"+y", kRightAngle},
                                                      {"y", kRightAngle},
                                                      {"-x", 2.0 * kRightAngle},
                                                      {"-y", -kRightAngle}};
  if (text.empty()) return {};
  if (const auto axis = kAxes.find(text); axis != kAxes.end()) return axis->second;
  const Quantity angle = parse_quantity(text, Dimension::angle);
  if (!angle.problem.empty())
    refuse("--front", text, "it must be +x, -x, +y, -y, or an angle from x such as 30deg");
  return angle.value;
}

std::optional<Vector3> up(const std::string& text) {
  if (text.empty()) return {};
  const std::size_t axis = std::string_view("xyz").find(text.back());
  const bool signless = text.size() == 1;
  if (axis > 2 || text.size() > 2 || (!signless && text[0] != '+' && text[0] != '-'))
    refuse("--up", text, "it must be +x, -x, +y, -y, +z or -z");
  return Vector3(Vector3::Unit(static_cast<int>(axis)) * (text[0] == '-' ? -1.0 : 1.0));
}

double splay(const std::string& text) {
  if (text.empty()) return 0.0;
  const Quantity length = parse_quantity(text, Dimension::length);
  if (!length.problem.empty()) refuse("--splay", text, "it must be a length such as 3cm or -2cm");
  return length.value;
}

void add_foot(const std::string& text, std::map<std::string, Vector3>& feet) {
  const std::size_t equals = text.rfind('=');
  const char* right = "it must be LINK=X,Y,Z, the foot's centre in the frame of that link [m]";
  if (equals == std::string::npos) refuse("--foot", text, right);
  const std::vector<std::string_view> words = split(std::string_view(text).substr(equals + 1), ',');
  if (words.size() != 3) refuse("--foot", text, right);
  Vector3 place;
  for (int i = 0; i < 3; ++i) {
    const Quantity length = parse_quantity(words[static_cast<std::size_t>(i)], Dimension::length);
    if (!length.problem.empty()) refuse("--foot", text, right);
    place[i] = length.value;
  }
  feet[text.substr(0, equals)] = place;
}

bool is_alike(const Substitution& a, const Substitution& b, bool brief) {
  if (a.origin != b.origin || a.what != b.what || a.option != b.option) return false;
  return (brief && a.origin != Origin::left_out) || (a.found == b.found && a.used == b.used);
}

}  // namespace

void add_robot_overrides(CLI::App& command, RobotOverrides& o) {
  command
      .add_option("--front", o.front, "Where the front is in the file: +x, -x, +y, -y or an angle")
      ->type_name("DIRECTION");
  command.add_option("--up", o.up, "What is up in the file: +x, -x, +y, -y, +z or -z")
      ->type_name("AXIS");
  command.add_option("--legs", o.legs, "The first joints of all legs; what else moves is held")
      ->type_name("JOINT,JOINT,...");
  command.add_option("--foot", o.feet, "The centre of a foot in a link's frame; may be repeated")
      ->type_name("LINK=X,Y,Z")
      ->allow_extra_args(false);
  command.add_option("--foot-radius", o.foot_radius, "Radius of all feet")->type_name("LENGTH");
  command.add_option("--mass", o.mass, "Mass of the whole robot [kg]: all masses times one factor")
      ->type_name("KG");
  command.add_option("--density", o.density, "Where a mass is substituted; default 1000 kg/m^3")
      ->type_name("DENSITY");
  command.add_option("--joint-speed", o.joint_speed, "Where it is substituted [rad/s]")
      ->type_name("SPEED");
  command.add_option("--joint-effort", o.joint_effort, "Where it is substituted [N m]")
      ->type_name("TORQUE");
  command.add_option("--joint-range", o.joint_range, "Limits to both sides where there are none")
      ->type_name("ANGLE");
  command.add_option("--scale", o.scale, "Times all lengths of the file: 0.001 for millimetres")
      ->type_name("FACTOR");
  command
      .add_option("--body-height", o.body_height, "Height of the body's origin above the ground")
      ->type_name("LENGTH");
  command.add_option("--splay", o.splay, "By how much farther out the feet stand; may be negative")
      ->type_name("LENGTH");
  command.add_option("--package", o.packages, "Where package:// meshes are; may be repeated")
      ->type_name("DIR")
      ->allow_extra_args(false);
  group(command, "What overrules the recognition of the robot");
}

UrdfOptions urdf_options(const RobotOverrides& o) {
  UrdfOptions options;
  options.front = front(o.front);
  options.up = up(o.up);
  if (!o.legs.empty())
    for (const std::string_view leg : split(o.legs, ',')) options.legs.emplace_back(leg);
  for (const std::string& foot : o.feet) add_foot(foot, options.feet);
  options.foot_radius =
      positive("--foot-radius", o.foot_radius, Dimension::length, "a length such as 2cm");
  options.mass = positive("--mass", o.mass, Dimension::number, "a number of kilograms");
  options.density =
      positive("--density", o.density, Dimension::number, "a number of kg/m^3").value_or(1000.0);
  options.joint_speed =
      positive("--joint-speed", o.joint_speed, Dimension::angular_rate, "a number of rad/s");
  options.joint_effort =
      positive("--joint-effort", o.joint_effort, Dimension::number, "a number of N m");
  options.joint_range =
      positive("--joint-range", o.joint_range, Dimension::angle, "an angle such as 90deg");
  options.scale =
      positive("--scale", o.scale, Dimension::number, "a number such as 0.001").value_or(1.0);
  options.packages = o.packages;
  options.stance.height =
      positive("--body-height", o.body_height, Dimension::length, "a length such as 20cm");
  options.stance.splay = splay(o.splay);
  return options;
}

std::vector<std::string> in_words(const std::vector<Substitution>& substitutions, bool brief) {
  std::vector<std::string> lines;
  std::vector<bool> told(substitutions.size(), false);
  for (std::size_t i = 0; i < substitutions.size(); ++i) {
    const Substitution& s = substitutions[i];
    if (told[i] || (brief && s.origin == Origin::derived)) continue;
    int more = 0;
    for (std::size_t j = i + 1; j < substitutions.size(); ++j)
      if (!told[j] && is_alike(s, substitutions[j], brief)) told[j] = true, ++more;
    lines.push_back(fmt::format(
        "{}{}{}: {} {}: {}; {}{}", s.line > 0 ? fmt::format("line {}: ", s.line) : "", s.element,
        more > 0 ? fmt::format(" and {} more", more) : "", s.what, to_string(s.origin), s.found,
        s.used, s.option.empty() ? "" : fmt::format(" ({})", s.option)));
  }
  return lines;
}

RobotModel load_robot(const std::string& robot, const RobotOverrides& overrides, bool quiet) {
  const std::string file = robot_file(robot);
  RobotModel model = load_urdf(file, urdf_options(overrides));
  if (!quiet) tell_substitutions(file, model);
  return model;
}

void tell_substitutions(const std::string& robot, const RobotModel& model) {
  for (const std::string& line : in_words(model.substitutions, true))
    fmt::print(stderr, "hexagait: {}: {}\n", robot, line);
}

}  // namespace hexagait::app

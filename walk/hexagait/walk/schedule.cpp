// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <hexagait/params/params_for.hpp>
#include <hexagait/sim/random.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/quantity.hpp>
#include <hexagait/text/text_file.hpp>
#include <hexagait/walk/schedule.hpp>
#include <hexagait/yaml/yaml_reader.hpp>
#include <optional>

namespace hexagait::walk {
namespace {

using heading_control::Heading;
using heading_control::Turn;

constexpr std::string_view kCommandKeys[] = {"at", "radius", "crab", "spin", "stop", "duty_factor"};
constexpr YamlKeys kCommandMap = {"command", kCommandKeys};
constexpr NumberRule kTime = {NumberRule::Bound::not_negative, Dimension::time};
const std::vector<std::string> kSpins = {"ccw", "cw"};

// What `parse` makes of the text of a value; refused with what it says against it.
double read(YamlReader& yaml, const std::optional<YamlField>& field, double otherwise,
            double (*parse)(const std::string&)) {
  const std::optional<std::string> text = field ? yaml.text(*field) : std::nullopt;
  if (!text) return otherwise;
  try {
    return parse(*text);
  } catch (const InvalidInput& error) {
    yaml.refuse(field->mark, fmt::format("{}: {}", field->key, error.what()));
    return otherwise;
  }
}

Heading read_heading(YamlReader& yaml, const YamlFields& fields) {
  const auto spin = yaml.find(fields, "spin"), stop = yaml.find(fields, "stop"),
             radius = yaml.find(fields, "radius");
  if ((spin ? 1 : 0) + (stop ? 1 : 0) + (radius ? 1 : 0) > 1)
    yaml.refuse(fields.mark, "radius, spin and stop exclude each other");
  if (stop) {
    if (!yaml.flag_or(fields, "stop", true))
      yaml.refuse(*stop, "true; a command that does not stop says where to go instead");
    return Heading::stop();
  }
  if (spin) return Heading::spin(yaml.word(*spin, kSpins) == 1 ? Turn::cw : Turn::ccw);
  return Heading::arc(read(yaml, radius, std::numeric_limits<double>::infinity(), parse_radius),
                      read(yaml, yaml.find(fields, "crab"), 0.0, parse_angle));
}

std::optional<double> read_duty_factor(YamlReader& yaml, const YamlFields& fields) {
  const std::optional<YamlField> field = yaml.find(fields, "duty_factor");
  if (!field) return {};
  const YamlNode& node = yaml.node(field->node);
  const auto [value, problem] = parse_quantity(node.text, Dimension::number);
  if (node.is_scalar() && problem.empty() && 0.5 <= value && value < 1.0) return value;
  yaml.refuse(*field, "at least 0.5 (tripod) and less than 1");
  return {};
}

// A command of nothing but a duty factor keeps the heading of the one before.
TimedCommand read_command(YamlReader& yaml, const YamlField& item, const Schedule& before) {
  const YamlFields fields = yaml.fields(item, kCommandMap);
  if (!yaml.node(item.node).is_map()) return {};
  TimedCommand command;
  if (const auto at = yaml.require(fields, "at")) {
    const std::optional<double> time = yaml.number(*at, kTime);
    command.time = time.value_or(0.0);
    if (time && !before.empty() && *time <= before.back().time)
      yaml.refuse(at->mark, fmt::format("at: {} s is not later than the command before, at {} s",
                                        *time, before.back().time));
  }
  command.duty_factor = read_duty_factor(yaml, fields);
  const auto is_heading = [](const YamlField& f) {
    return f.key != "at" && f.key != "duty_factor";
  };
  if (!command.duty_factor || std::ranges::any_of(fields.fields, is_heading))
    command.heading = read_heading(yaml, fields);
  else
    command.heading = before.empty() ? Heading::straight(0.0) : before.back().heading;
  return command;
}

}  // namespace

const TimedCommand& command_at(const Schedule& schedule, double time) {
  const auto later =
      std::upper_bound(schedule.begin(), schedule.end(), time + 1e-9,
                       [](double t, const TimedCommand& command) { return t < command.time; });
  return later == schedule.begin() ? schedule.front() : *std::prev(later);
}

Schedule load_schedule(const std::string& path) {
  Violations violations(path);
  const YamlTree tree = parse_yaml(read_text(path, kMaxYamlText), path, violations);
  YamlReader yaml(tree, violations);
  const YamlNode& root = yaml.node(0);
  if (!root.is_list() || root.children.empty())
    yaml.stop(root.mark,
              fmt::format("is {}; it must be a list of commands such as - {{at: 0, radius: 1.5}}",
                          in_words(root)));
  Schedule schedule;
  for (const YamlField& item : yaml.list({"command", 0, root.mark}))
    schedule.push_back(read_command(yaml, item, schedule));
  violations.throw_if_any();
  return schedule;
}

Schedule random_schedule(std::uint64_t seed, double period, double seconds, double least_radius) {
  const double most = 1.0 / least_radius;
  RandomSequence random{.seed = seed, .stream = RandomStream::commands};
  Schedule schedule;
  for (int k = 0; k == 0 || k * period < seconds; ++k) {
    const double kind = random.u01();
    const double curvature = random.uniform(-most, most);
    const double crab = random.uniform(-std::numbers::pi, std::numbers::pi);
    Heading heading = Heading::arc(1.0 / curvature, crab);
    if (kind < 0.1) heading = Heading::straight(crab);
    if (kind > 0.9) heading = Heading::spin(curvature > 0.0 ? Turn::ccw : Turn::cw);
    schedule.push_back({k * period, heading});
  }
  return schedule;
}

double tightest_radius(const RobotModel& robot) { return 0.3 * scale_of(robot).size; }

double parse_angle(const std::string& text) {
  const auto [value, problem] = parse_quantity(text, Dimension::angle);
  if (!problem.empty()) throw InvalidInput(problem);
  return value;
}

double parse_radius(const std::string& text) {
  constexpr double kStraight = std::numeric_limits<double>::infinity();
  if (text == "inf" || text == "-inf") return text == "inf" ? kStraight : -kStraight;
  const auto [value, problem] = parse_quantity(text, Dimension::length);
  if (!problem.empty())
    throw InvalidInput(problem +
                       "; a radius is positive to turn left and negative to turn right, "
                       "or inf");
  if (value == 0.0)
    throw InvalidInput("a radius of 0 does not say which way to turn; ask for a spin, ccw or cw");
  return value;
}

}  // namespace hexagait::walk

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <hexagait/sim/random.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/walk/schedule.hpp>
#include <optional>

namespace hexagait::walk {
namespace {

using heading_control::Heading;
using heading_control::Turn;

constexpr std::string_view kKeys[] = {"at", "radius", "crab", "spin", "stop", "duty_factor"};

std::optional<double> number(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || std::isnan(value)) return {};
  return value;
}

// Collects what is wrong with a file, each finding with its line.
class Findings {
 public:
  explicit Findings(std::string path) : path_(std::move(path)) {}
  void add(const YAML::Mark& mark, const std::string& problem) {
    text_ += fmt::format("{}{}:{}: {}", text_.empty() ? "" : "\n", path_, mark.line + 1, problem);
  }
  void throw_if_any() const {
    if (!text_.empty()) throw InvalidInput(text_);
  }

 private:
  std::string path_, text_;
};

std::string scalar(const YAML::Node& node) {
  return node.IsScalar() ? node.Scalar() : "(no value)";
}

Heading read_heading(const YAML::Node& node) {
  if (node["stop"]) {
    if (scalar(node["stop"]) != "true")
      throw InvalidInput(
          fmt::format("stop is '{}'; only 'true' means something", scalar(node["stop"])));
    return Heading::stop();
  }
  if (node["spin"]) {
    const std::string spin = scalar(node["spin"]);
    if (spin != "ccw" && spin != "cw")
      throw InvalidInput(fmt::format("spin is '{}'; it must be 'ccw' or 'cw'", spin));
    return Heading::spin(spin == "ccw" ? Turn::ccw : Turn::cw);
  }
  const double crab = node["crab"] ? parse_angle(scalar(node["crab"])) : 0.0;
  const double radius = node["radius"] ? parse_radius(scalar(node["radius"]))
                                       : std::numeric_limits<double>::infinity();
  return Heading::arc(radius, crab);
}

std::optional<double> read_duty_factor(const YAML::Node& node) {
  if (!node["duty_factor"]) return {};
  const std::string text = scalar(node["duty_factor"]);
  const std::optional<double> value = number(text);
  if (!value || !(0.5 <= *value && *value < 1.0))
    throw InvalidInput(
        fmt::format("duty_factor is '{}'; it must be at least 0.5 (tripod) and less than 1", text));
  return value;
}

// A command of nothing but a duty factor keeps the heading of the one before.
TimedCommand read_command(const YAML::Node& node, const Heading& before) {
  if (!node.IsMap()) throw InvalidInput("a command must be a map such as {at: 0, radius: 1.5}");
  int kinds = 0, headings = 0;
  for (const auto& entry : node) {
    const std::string key = scalar(entry.first);
    if (std::find(std::begin(kKeys), std::end(kKeys), key) == std::end(kKeys))
      throw InvalidInput(
          fmt::format("unknown key '{}'; there are at, radius, crab, spin, stop and "
                      "duty_factor",
                      key));
    kinds += key == "spin" || key == "stop" || key == "radius";
    headings += key != "at" && key != "duty_factor";
  }
  if (kinds > 1) throw InvalidInput("radius, spin and stop exclude each other");
  if (!node["at"]) throw InvalidInput("'at', the time of the command in seconds, is missing");
  const std::string at = scalar(node["at"]);
  const std::optional<double> time = number(at);
  if (!time || !std::isfinite(*time) || *time < 0.0)
    throw InvalidInput(fmt::format("at is '{}'; it must be a time of 0 s or more", at));
  const std::optional<double> duty_factor = read_duty_factor(node);
  const bool keeps = duty_factor && headings == 0;
  return {*time, keeps ? before : read_heading(node), duty_factor};
}

}  // namespace

const TimedCommand& command_at(const Schedule& schedule, double time) {
  const auto later =
      std::upper_bound(schedule.begin(), schedule.end(), time + 1e-9,
                       [](double t, const TimedCommand& command) { return t < command.time; });
  return later == schedule.begin() ? schedule.front() : *std::prev(later);
}

Schedule load_schedule(const std::string& path) {
  YAML::Node root;
  try {
    root = YAML::LoadFile(path);
  } catch (const YAML::BadFile&) {
    throw InvalidInput(fmt::format("{}: can't be read; a YAML list of commands is expected", path));
  } catch (const YAML::ParserException& error) {
    throw InvalidInput(fmt::format("{}:{}: not YAML: {}", path, error.mark.line + 1, error.msg));
  }
  if (!root.IsSequence() || root.size() == 0)
    throw InvalidInput(
        fmt::format("{}: must be a list of commands such as - {{at: 0, radius: 1.5}}", path));

  Schedule schedule;
  Findings findings(path);
  for (const YAML::Node& node : root) {
    try {
      const Heading before = schedule.empty() ? Heading::straight(0.0) : schedule.back().heading;
      schedule.push_back(read_command(node, before));
      if (schedule.size() > 1 && schedule.back().time <= schedule[schedule.size() - 2].time)
        throw InvalidInput(
            fmt::format("at is {} s, not later than the command before", schedule.back().time));
    } catch (const std::exception& error) {
      findings.add(node.Mark(), error.what());
    }
  }
  findings.throw_if_any();
  return schedule;
}

Schedule random_schedule(std::uint64_t seed, double period, double seconds) {
  constexpr double kMaxCurvature = 1.0 / 0.3;
  RandomSequence random{.seed = seed, .stream = RandomStream::commands};
  Schedule schedule;
  for (int k = 0; k == 0 || k * period < seconds; ++k) {
    const double kind = random.u01();
    const double curvature = random.uniform(-kMaxCurvature, kMaxCurvature);
    const double crab = random.uniform(-std::numbers::pi, std::numbers::pi);
    Heading heading = Heading::arc(1.0 / curvature, crab);
    if (kind < 0.1) heading = Heading::straight(crab);
    if (kind > 0.9) heading = Heading::spin(curvature > 0.0 ? Turn::ccw : Turn::cw);
    schedule.push_back({k * period, heading});
  }
  return schedule;
}

double parse_angle(const std::string& text) {
  std::string_view digits = text;
  double unit = 1.0;
  if (digits.ends_with("deg")) {
    digits.remove_suffix(3);
    unit = std::numbers::pi / 180.0;
  } else if (digits.ends_with("rad")) {
    digits.remove_suffix(3);
  }
  const std::optional<double> value = number(digits);
  if (!value || !std::isfinite(*value))
    throw InvalidInput(
        fmt::format("'{}' is not an angle; write for example 0.5, 0.5rad or 30deg", text));
  return *value * unit;
}

double parse_radius(const std::string& text) {
  const std::optional<double> value = number(text);
  if (!value)
    throw InvalidInput(
        fmt::format("'{}' is not a radius; write metres, positive to turn left and negative to "
                    "turn right, or inf",
                    text));
  if (*value == 0.0)
    throw InvalidInput("a radius of 0 does not say which way to turn; ask for a spin, ccw or cw");
  return *value;
}

}  // namespace hexagait::walk

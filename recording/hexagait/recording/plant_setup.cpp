// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <hexagait/recording/plant_setup.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/nearest_word.hpp>
#include <hexagait/text/quantity.hpp>
#include <hexagait/text/split.hpp>
#include <numbers>
#include <optional>

namespace hexagait::recording {
namespace {

constexpr std::string_view kQuantisation = "joint_quantisation";

// The step of a sensor of so many bits a turn.
double step_of(int bits) { return std::ldexp(2.0 * std::numbers::pi, -bits); }

PlantSetup real_plant() {
  PlantSetup setup;
  setup.name = "real";
  setup.world.friction = 0.6;
  setup.world.mass_error = 0.1;
  setup.faults.joint_noise = 5e-4;
  setup.faults.joint_quantisation = step_of(12);
  setup.faults.contact_bounce = 0.004;
  setup.faults.sensing_delay = 0.002;
  setup.faults.command_delay = 0.004;
  setup.faults.acceleration_noise = 0.05;
  setup.faults.acceleration_bias = 0.1;
  setup.faults.rate_noise = 0.005;
  setup.faults.rate_bias = 0.01;
  return setup;
}

// How a unit is written, and in messages.
struct UnitWords {
  std::string_view suffix, in_json, kind, examples;
};
UnitWords words(PlantUnit unit) {
  switch (unit) {
    case PlantUnit::number:
      return {"", "", "a number", "such as 0.6"};
    case PlantUnit::share:
      return {"%", "", "a share", "such as 0.05 or 5%"};
    case PlantUnit::angle:
      return {"", "_rad", "an angle", "such as 0.5mrad or 0.03deg"};
    case PlantUnit::time:
      return {"", "_s", "a time", "such as 0.004 or 4ms"};
    case PlantUnit::force:
      return {"N", "_n", "a force", "such as 5 or 5N"};
    case PlantUnit::torque:
      return {"Nm", "_n_m", "a torque", "such as 2 or 2Nm"};
    case PlantUnit::inertia:
      return {"kgm2", "_kg_m2", "an inertia", "such as 0.1 or 0.1kgm2"};
    case PlantUnit::acceleration:
      return {"m/s2", "_m_s2", "an acceleration", "such as 0.05 or 0.05m/s2"};
    case PlantUnit::angular_rate:
      return {"", "_rad_s", "an angular rate", "such as 0.01 or 0.5deg/s"};
  }
  return {};
}

Dimension dimension(PlantUnit unit) {
  if (unit == PlantUnit::angle) return Dimension::angle;
  if (unit == PlantUnit::angular_rate) return Dimension::angular_rate;
  return unit == PlantUnit::time ? Dimension::time : Dimension::number;
}

// "12bit" as an angle.
std::optional<double> bits(std::string_view text) {
  if (!text.ends_with("bit")) return {};
  text.remove_suffix(3);
  int count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && 1 <= count && count <= 32 ? std::optional(step_of(count)) : std::nullopt;
}

std::optional<double> value_of(const PlantNumber& number, std::string_view text) {
  if (number.name == kQuantisation)
    if (const auto step = bits(text)) return step;
  const std::string_view suffix = words(number.unit).suffix;
  const bool has_suffix = !suffix.empty() && text.ends_with(suffix);
  if (has_suffix) text.remove_suffix(suffix.size());
  const auto [value, problem] = parse_quantity(text, dimension(number.unit));
  if (!problem.empty()) return {};
  return has_suffix && number.unit == PlantUnit::share ? value / 100.0 : value;
}

std::string set(PlantSetup& setup, const PlantSwitch& one, const std::string& value,
                const std::string& spoken) {
  std::string word = value;
  std::ranges::replace(word, '-', '_');
  for (const bool on : {false, true}) {
    if (word != one.words[on]) continue;
    (one.of_world != nullptr ? setup.world.*one.of_world : setup.faults.*one.of_faults) = on;
    return "";
  }
  const std::vector<std::string> known(std::begin(one.words), std::end(one.words));
  return fmt::format("{} is '{}'{}; it must be {} or {}", spoken, value, did_you_mean(value, known),
                     one.words[0], one.words[1]);
}

// The keys of a plant, and its presets.
std::vector<std::string> known_words() {
  std::vector<std::string> known;
  for (const PlantSwitch& one : plant_switches()) known.emplace_back(one.name);
  for (const PlantNumber& number : plant_numbers()) known.emplace_back(number.name);
  for (const PlantPreset& preset : plant_presets()) known.emplace_back(preset.name);
  for (const std::string& fault : walk::part_fault_names()) known.push_back(fault);
  return known;
}

// One part of the text of a plant.
std::string take(PlantSetup& setup, const std::string& part, bool is_first) {
  const std::size_t colon = part.find(':');
  if (std::ranges::count(walk::part_fault_names(), part.substr(0, colon)) > 0) {
    setup.parts.push_back(walk::parse_part_fault(part));
    return "";
  }
  if (colon != std::string::npos)
    return set(setup, part.substr(0, colon), part.substr(colon + 1), part.substr(0, colon));
  if (is_first)
    for (const PlantPreset& preset : plant_presets())
      if (part == preset.name) return setup = preset.setup, "";
  return fmt::format("'{}' is no plant{}; there are ideal and real, and NAME:VALUE, joined by +",
                     part, did_you_mean(part, known_words()));
}

}  // namespace

const std::vector<PlantNumber>& plant_numbers() {
  static const std::vector<PlantNumber> all = [] {
    std::vector<PlantNumber> numbers;
    for (const auto& [name, value, unit, least, greatest, meaning] : sim3d::imperfections())
      numbers.push_back({name, unit, least, greatest, meaning, value, nullptr});
    for (const auto& [name, value, unit, least, greatest, meaning] : walk::imperfections())
      numbers.push_back({name, unit, least, greatest, meaning, nullptr, value});
    return numbers;
  }();
  return all;
}

std::span<const PlantSwitch> plant_switches() {
  static constexpr PlantSwitch kAll[] = {
      {"velocity_limits",
       {"off", "on"},
       "Drives keep to the velocity limits of the model, as motors do",
       &sim3d::WorldParams::velocity_limits,
       nullptr},
      {"imu",
       {"off", "on"},
       "The robot has an inertial measurement unit: it knows where up is",
       &sim3d::WorldParams::imu,
       nullptr},
      {"servo",
       {"ideal", "position_only"},
       "What servos take: position_only is without velocities and efforts fed forward",
       nullptr,
       &walk::PlantFaults::positions_only}};
  return kAll;
}

bool PlantSetup::is_ideal() const {
  const PlantSetup ideal;
  const auto same = [&](const auto& part) { return part.of(*this) == part.of(ideal); };
  return parts.empty() && std::ranges::all_of(plant_numbers(), same) &&
         std::ranges::all_of(plant_switches(), same);
}

std::string name_with_unit(const PlantNumber& number) {
  return number.name + std::string(words(number.unit).in_json);
}

std::string expected(const PlantNumber& number) {
  const UnitWords unit = words(number.unit);
  const std::string_view dimensionless = symbol(number.unit);
  return fmt::format("{} from {:g} to {:g}{}, {}{}", unit.kind, number.least, number.greatest,
                     dimensionless == "1" ? "" : fmt::format(" {}", dimensionless), unit.examples,
                     number.name == kQuantisation ? ", or a sensor's 12bit" : "");
}

const std::vector<PlantPreset>& plant_presets() {
  static const std::vector<PlantPreset> all = {
      {"ideal", "nothing is wrong with it; friction 0.9", PlantSetup{}},
      {"real",
       "12-bit angles with noise of 0.5 mrad, contacts that rattle for 4 ms, 2 ms of delay of "
       "sensing and 4 ms of commands, friction 0.6, masses off by 10 %; of an inertial measurement "
       "unit, if there is one, noise of 0.05 m/s² and 0.005 rad/s, biases of 0.1 m/s² and 0.01 "
       "rad/s",
       real_plant()}};
  return all;
}

std::string set(PlantSetup& setup, std::string_view key, const std::string& value,
                const std::string& spoken) {
  std::string name(key);
  std::ranges::replace(name, '-', '_');
  for (const PlantSwitch& one : plant_switches())
    if (name == one.name) return set(setup, one, value, spoken);
  for (const PlantNumber& number : plant_numbers()) {
    if (name != number.name) continue;
    const std::optional<double> read = value_of(number, value);
    if (!read || !(number.least <= *read && *read <= number.greatest))
      return fmt::format("{} is '{}'; it must be {}", spoken, value, expected(number));
    (number.of_world != nullptr ? setup.world.*number.of_world : setup.faults.*number.of_faults) =
        *read;
    return "";
  }
  return fmt::format("a plant has no '{}'{}; hexagait list plants and list faults show what it has",
                     spoken, did_you_mean(name, known_words()));
}

void add_faults(PlantSetup& setup, std::span<const std::string> faults) {
  std::vector<std::string> problems;
  for (const std::string& fault : faults) {
    try {
      setup.parts.push_back(walk::parse_part_fault(fault));
      setup.name = fmt::format("{}{}", setup.name == "ideal" ? "" : setup.name + "+", fault);
    } catch (const InvalidInput& error) {
      problems.emplace_back(error.what());
    }
  }
  if (!problems.empty()) throw InvalidInput(fmt::format("{}", fmt::join(problems, "\n")));
}

PlantSetup parse_plant(const std::string& text) {
  PlantSetup setup;
  std::vector<std::string> problems;
  bool is_first = true;
  for (const std::string_view part : split(text, '+')) {
    try {
      const std::string problem = take(setup, std::string(part), is_first);
      if (!problem.empty()) problems.push_back(problem);
    } catch (const InvalidInput& error) {
      problems.emplace_back(error.what());
    }
    is_first = false;
  }
  if (!problems.empty()) throw InvalidInput(fmt::format("{}", fmt::join(problems, "\n")));
  setup.name = text;
  return setup;
}

}  // namespace hexagait::recording

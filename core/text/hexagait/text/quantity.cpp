// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <charconv>
#include <cmath>
#include <hexagait/text/quantity.hpp>
#include <hexagait/text/violations.hpp>
#include <numbers>
#include <optional>
#include <span>

namespace hexagait {
namespace {

struct Unit {
  std::string_view name;
  double size;  ///< [SI units, radians]
};
constexpr double kDegree = std::numbers::pi / 180.0;
constexpr Unit kLengths[] = {{"", 1.0}, {"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}};
constexpr Unit kTimes[] = {{"", 1.0}, {"s", 1.0}, {"ms", 1e-3}, {"us", 1e-6}, {"min", 60.0}};
constexpr Unit kAngles[] = {{"", 1.0}, {"rad", 1.0}, {"mrad", 1e-3}, {"deg", kDegree}};
constexpr Unit kNumbers[] = {{"", 1.0}};

std::span<const Unit> units(Dimension dimension) {
  switch (dimension) {
    case Dimension::number:
      return kNumbers;
    case Dimension::length:
      return kLengths;
    case Dimension::time:
      return kTimes;
    case Dimension::angle:
    case Dimension::angular_rate:
      return kAngles;
  }
  return kNumbers;
}

struct Number {
  double value = 0.0;
  std::string_view unit;
};

// The number that a text begins with; the unit is what follows it.
std::optional<Number> split(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || !std::isfinite(value)) return {};
  return Number{value, {rest, static_cast<std::size_t>(end - rest)}};
}

// deg(30) and rad(0.5). Degrees are multiplied before they are divided, as in all action files.
std::optional<double> function_of_angle(std::string_view text) {
  if (!text.ends_with(')')) return {};
  const bool degrees = text.starts_with("deg(");
  if (!degrees && !text.starts_with("rad(")) return {};
  const std::optional<Number> number = split(text.substr(4, text.size() - 5));
  if (!number || !number->unit.empty()) return {};
  return degrees ? number->value * std::numbers::pi / 180.0 : number->value;
}

std::string quote(std::string_view text) {
  std::string shown(text.substr(0, 60));
  for (char& letter : shown)
    if (static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f) letter = '?';
  return "'" + shown + "'";
}

Quantity bounded(double value, std::string_view text) {
  if (std::abs(value) <= kLargestQuantity) return {value};
  return {.problem = quote(text) + " is out of range; at most 1e9 in SI units is read"};
}

}  // namespace

std::string_view expected(Dimension dimension) {
  switch (dimension) {
    case Dimension::number:
      return "a finite number";
    case Dimension::length:
      return "a length such as 0.05, 5cm or 50mm";
    case Dimension::time:
      return "a time such as 2, 2s, 20ms or 1min";
    case Dimension::angle:
    case Dimension::angular_rate:
      return "a finite angle such as 30deg, 0.5rad or 0.5 (radians)";
  }
  return "?";
}

Quantity parse_quantity(std::string_view text, Dimension dimension) {
  const bool is_angle = dimension == Dimension::angle || dimension == Dimension::angular_rate;
  if (is_angle)
    if (const std::optional<double> value = function_of_angle(text)) return bounded(*value, text);

  const std::optional<Number> number = split(text);
  const Unit* unit = nullptr;
  for (const Unit& known : units(dimension))
    if (number && known.name == number->unit) unit = &known;
  if (!unit) return {.problem = quote(text) + " is not " + std::string(expected(dimension))};

  constexpr double kTurn = 2.0 * std::numbers::pi * (1.0 + 1e-9);
  if (dimension == Dimension::angle && unit->name.empty() && std::abs(number->value) > kTurn)
    return {.problem = quote(text) +
                       ": an angle without a unit is in radians and at most 2π; write " +
                       in_words(number->value) + "deg"};
  return bounded(number->value * unit->size, text);
}

}  // namespace hexagait

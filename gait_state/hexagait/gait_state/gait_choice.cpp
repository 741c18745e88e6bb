// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <charconv>
#include <hexagait/gait_state/gait_choice.hpp>

namespace hexagait::gait_state {
namespace {

constexpr std::string_view kWave = "wave:";

std::optional<double> parse_duty_factor(std::string_view text) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end || !(0.5 <= value && value < 1.0)) return {};
  return value;
}

}  // namespace

std::optional<GaitChoice> parse_gait_choice(std::string_view text) {
  if (text == "free") return GaitChoice{};
  if (text == "unadjusted") return GaitChoice{.adjustment = Adjustment::none};
  if (text == "literal") return GaitChoice{.adjustment = Adjustment::literal};
  if (text == "tripod") return GaitChoice{.stepper = {.stepping = Stepping::tripod}};
  if (text == "clocked")
    return GaitChoice{.stepper = {.stepping = Stepping::tripod}, .open_loop = true};
  if (!text.starts_with(kWave)) return {};
  const std::optional<double> duty_factor = parse_duty_factor(text.substr(kWave.size()));
  if (!duty_factor) return {};
  return GaitChoice{.stepper = {.stepping = Stepping::wave, .duty_factor = *duty_factor}};
}

std::string to_string(const GaitChoice& choice) {
  if (choice.stepper.stepping == Stepping::tripod) return choice.open_loop ? "clocked" : "tripod";
  if (choice.stepper.stepping == Stepping::wave) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.begin(), digits.end(), choice.stepper.duty_factor).ptr;
    return std::string(kWave).append(digits.begin(), end);
  }
  if (choice.adjustment == Adjustment::none) return "unadjusted";
  return choice.adjustment == Adjustment::literal ? "literal" : "free";
}

}  // namespace hexagait::gait_state

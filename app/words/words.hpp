// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/recording/json.hpp>
#include <numbers>

namespace hexagait::app {

/// "5.2 mm", "3.1 cm" or "1.25 m"; "none" for an infinite one.
[[nodiscard]] std::string length(double metres);

/// [°] of [rad].
[[nodiscard]] inline double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

/// Adds one of the aligned lines below a sentence.
void add(std::string& text, const char* label, const std::string& value);

/// "on flat ground", or over what.
[[nodiscard]] std::string ground(const std::string& terrain);

/// A walk for a person: a sentence with the verdict, then a few aligned lines.
[[nodiscard]] std::string in_words(const recording::WalkReport& report);

/// A walk in a sentence, and in a line of numbers.
[[nodiscard]] std::string headline(const recording::WalkReport& report);
[[nodiscard]] std::string subtitle(const recording::WalkReport& report);

/// It reached the distance asked for, or none was asked for.
[[nodiscard]] bool arrived(const recording::WalkReport& report);

/// What was recognised of a robot, for a person.
[[nodiscard]] std::string in_words(const RobotModel& robot);

/// The parameters of a robot, with unit and where each comes from.
/// @param given  those that were set; the others are kDerived
[[nodiscard]] std::string params_in_words(const RobotModel& robot, RobotParams given);

}  // namespace hexagait::app

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <hexagait/text/violations.hpp>
#include <numbers>
#include <string>

namespace hexagait {

// Rounded for messages; + 0.0 makes −0 a 0.

/// "12.5°"
[[nodiscard]] inline std::string degrees(double radians) {
  return in_words(std::round(10.0 * radians * 180.0 / std::numbers::pi) / 10.0 + 0.0) + "°";
}

/// "0.0123 m"
[[nodiscard]] inline std::string metres(double value) {
  return in_words(std::round(1e4 * value) / 1e4 + 0.0) + " m";
}

}  // namespace hexagait

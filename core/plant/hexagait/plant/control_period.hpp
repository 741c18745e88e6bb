// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace hexagait {

/// The control periods that the controller is made for [s]: 1 to 20 ms. Shorter ones only cost
/// processor time; with longer ones a foot goes on pressing for too long before its contact is
/// noticed, and the shortest phases of a swing would last less than a period.
inline constexpr double kShortestControlPeriod = 0.001;
inline constexpr double kLongestControlPeriod = 0.020;

/// Also false for what is not a number. Periods are accepted to within their rounding.
[[nodiscard]] constexpr bool is_control_period(double dt) noexcept {
  return dt >= kShortestControlPeriod * (1.0 - 1e-9) && dt <= kLongestControlPeriod * (1.0 + 1e-9);
}

}  // namespace hexagait

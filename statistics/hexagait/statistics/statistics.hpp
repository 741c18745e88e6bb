// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

namespace hexagait::statistics {

/// A mean and how well it is known, in the unit of what was measured.
///
///     mean ± t₀.₉₇₅(n − 1) · sd / √n
///
/// The interval supposes independent trials; it is exact for normal ones, and good for a hundred of
/// any that are not wild.
struct Estimate {
  int count = 0;
  double mean = 0.0;
  double sd = 0.0;          ///< of one trial, with n − 1; 0 for one trial
  double half_width = 0.0;  ///< of the 95 % confidence interval of the mean; infinite for one trial

  [[nodiscard]] double lower() const { return mean - half_width; }
  [[nodiscard]] double upper() const { return mean + half_width; }
};

/// @param values  one per trial, at least one
/// @throws std::invalid_argument  if there is none
[[nodiscard]] Estimate estimate(std::span<const double> values);

/// Of the differences a − b, trial by trial: what the trials have in common (start, terrain)
/// cancels.
/// @param a,b  of equal length, trial k of both with the same draws
/// @throws std::invalid_argument  if their lengths differ, or are 0
[[nodiscard]] Estimate paired_difference(std::span<const double> a, std::span<const double> b);

/// How often something happened, and the 95 % confidence interval of its probability by Wilson's
/// score: all p with |p̂ − p| ≤ z √(p (1 − p)/n), z = 1.96. It is inside [0, 1], and has a width even
/// if nothing or everything happened: 20 of 20 is at least 84 %.
struct Proportion {
  int count = 0;   ///< of those in which it happened
  int trials = 0;  ///< of all
  double lower = 0.0, upper = 1.0;

  [[nodiscard]] double share() const { return static_cast<double>(count) / trials; }
};

/// @throws std::invalid_argument  if there are no trials, or not 0 ≤ count ≤ trials
[[nodiscard]] Proportion proportion(int count, int trials);

/// The greatest and the least of some values. NaN if one of them is, or if there are none: nothing
/// that was not measured passes for small.
[[nodiscard]] double greatest(std::span<const double> values);
[[nodiscard]] double least(std::span<const double> values);

}  // namespace hexagait::statistics

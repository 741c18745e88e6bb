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
[[nodiscard]] Estimate estimate(std::span<const double> values);

/// Of the differences a − b, trial by trial: what the trials have in common (start, terrain)
/// cancels.
/// @param a,b  of equal length, trial k of both with the same draws
[[nodiscard]] Estimate paired_difference(std::span<const double> a, std::span<const double> b);

}  // namespace hexagait::statistics

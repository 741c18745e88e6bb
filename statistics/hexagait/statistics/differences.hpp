// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/statistics/statistics.hpp>
#include <span>

/// Differences of two samples, each with its 95 % confidence interval. For values that belong
/// together trial by trial paired_difference() knows more.
namespace hexagait::statistics {

struct Difference {
  double value = 0.0;               ///< in the unit of the samples
  double lower = 0.0, upper = 0.0;  ///< infinite where nothing is known
};

/// mean(a) − mean(b) of samples that have nothing in common, by Welch's t interval:
///
///     a̅ − b̅ ± t₀.₉₇₅(ν) √(s_a²/n_a + s_b²/n_b)
///
/// with ν after Welch and Satterthwaite: the variances need not be equal.
/// @throws std::invalid_argument  if one has no values
[[nodiscard]] Difference unpaired_difference(std::span<const double> a, std::span<const double> b);

/// share(a) − share(b) by Newcombe's hybrid score interval, which puts the Wilson limits of both
/// together in quadrature. It has a width where both shares are 0 or 1.
[[nodiscard]] Difference difference(const Proportion& a, const Proportion& b);

}  // namespace hexagait::statistics

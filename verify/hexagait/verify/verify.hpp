// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <hexagait/verify/report.hpp>
#include <hexagait/verify/rules.hpp>

/// The theorems of the gait state (docs/theory.md 1), each checked by exhaustive enumeration of its
/// cases with the update, adjustment and stepper of the library.
namespace hexagait::verify {

/// Bounds of the enumeration. The defaults are those of the claims; tests use less.
struct Scope {
  std::vector<int> legs = {4, 6, 8, 10, 12};  ///< numbers of legs; theorems about types use 6 only
  std::vector<int> odd_legs = {5, 7, 9, 11};  ///< legs of rings that have lost one
  int step_time = 6;                          ///< T = 1 … this [slices]
  int step_time_8 = 3;  ///< the same for Scene::all with 8 legs; more legs: reachable only
};

/// Called with the completed fraction, 0 … 1.
using Progress = std::function<void(double)>;

[[nodiscard]] TheoremReport verify(const Rules& rules = {}, const Scope& scope = {},
                                   const Progress& progress = {});

}  // namespace hexagait::verify

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <hexagait/verify/report.hpp>
#include <hexagait/verify/rules.hpp>

/// The theorems of the gait state (docs/theory.md 1), each over all of its cases: nothing is
/// sampled. The update, the adjustment and the stepper are the library's own.
namespace hexagait::verify {

/// How much to try. The default is what is claimed; less is for quick tests.
struct Scope {
  std::vector<int> legs = {4, 6, 8, 10, 12};  ///< rings; theorems about types take 6 only
  int step_time = 6;                          ///< T = 1 … this [slices]
  int step_time_8 = 3;  ///< the same for all situations of 8 legs; of more legs the reachable ones
};

/// Told how far it has got, 0 … 1.
using Progress = std::function<void(double)>;

[[nodiscard]] Report verify(const Rules& rules = {}, const Scope& scope = {},
                            const Progress& progress = {});

}  // namespace hexagait::verify

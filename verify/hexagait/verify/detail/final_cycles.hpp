// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <hexagait/verify/detail/settle.hpp>
#include <hexagait/verify/detail/situations.hpp>
#include <hexagait/verify/verify.hpp>
#include <string>

namespace hexagait::verify {

/// For example "<><><> with T = 3".
[[nodiscard]] inline std::string words_of(const Situation& situation, int step_time) {
  return fmt::format("{} with T = {}", to_string(situation), step_time);
}

/// Walks on from every reachable situation of these states to its final cycle. The theorem fails at a
/// slice that is no step or breaks rule 1.
/// @param states   of a ring of legs 0 … n − 1, not cyclic
/// @param inspect  called with each cycle once, in order
/// @returns number of situations that were started from
template <class Inspect>
std::int64_t final_cycles(Theorem& theorem, const Rules& rules,
                          const std::vector<GaitState>& states, int step_time,
                          Adjustment adjustment, const Inspect& inspect) {
  const Situations situations(states, step_time, Scene::reachable);
  const Slices slices(rules, states.front().ring(), step_time, adjustment);
  std::vector<std::int16_t> memo(situations.size(), 0);
  const auto key = [&](const Situation& s) { return situations.key(s); };
  const auto next = [&](const Situation& before) {
    const Slice slice = slices.advance(before);
    const bool good = theorem.check(is_step(slice) && keeps_rule_1(slice),
                                    [&] { return words_of(before, step_time); });
    return good ? slice.next : before;
  };
  std::int64_t starts = 0;
  situations.for_each_start([&](const Situation& start) {
    if (!theorem.holds()) return;
    settle(start, memo, key, next, inspect);
    ++starts;
  });
  return starts;
}

}  // namespace hexagait::verify

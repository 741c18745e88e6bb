// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace hexagait::verify {

/// Follows successors until they repeat. There are finitely many situations, each with one
/// successor, so every walk ends in a cycle.
///
/// @param start     first situation
/// @param memo      results of earlier walks: an integer per key, 0 for situations not visited yet
/// @param key       situation → its key in the memo, one to one
/// @param next      situation → its successor
/// @param on_cycle  called with each cycle that no earlier walk has found, in order
/// @returns number of steps from `start` to the first situation of the cycle
template <class Situation, class Memo, class Key, class Next, class OnCycle>
int settle(const Situation& start, Memo& memo, const Key& key, const Next& next,
           const OnCycle& on_cycle) {
  // In the memo: −1 on the present walk; k + 1 if the cycle is k steps away.
  std::vector<std::pair<decltype(key(start)), Situation>> walk;
  Situation here = start;
  auto here_key = key(here);
  for (; memo[here_key] == 0; here_key = key(here)) {
    memo[here_key] = -1;
    walk.emplace_back(here_key, here);
    here = next(here);
  }

  int left = memo[here_key];
  if (left == -1) {
    left = 1;
    std::vector<Situation> cycle;
    do {
      cycle.insert(cycle.begin(), walk.back().second);
      memo[walk.back().first] = 1;
      walk.pop_back();
    } while (cycle.front() != here);
    on_cycle(std::span<const Situation>(cycle));
  }
  for (; !walk.empty(); walk.pop_back())
    memo[walk.back().first] = static_cast<std::int16_t>(++left);
  return left - 1;
}

}  // namespace hexagait::verify

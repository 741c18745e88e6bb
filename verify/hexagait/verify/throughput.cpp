// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <hexagait/verify/detail/settle.hpp>
#include <hexagait/verify/detail/situations.hpp>
#include <hexagait/verify/detail/theorems.hpp>

namespace hexagait::verify {

using namespace gait_state;

namespace {

/// Final cycles of the gait without adjustment, from all states with one CCN, for one T.
struct Cycles {
  std::int64_t starts = 0;
  std::size_t shortest = SIZE_MAX, longest = 0;  // [slices]
};

Cycles explore(Theorem& theorem, const Rules& rules, int n, int ccn, int step_time) {
  std::vector<GaitState> states = non_cyclic_states(n);
  std::erase_if(states, [ccn](const GaitState& state) { return state.ccn() != ccn; });
  const Situations situations(states, step_time, Scene::reachable);
  const Slices slices(rules, n, step_time, Adjustment::none);
  std::vector<std::int16_t> memo(situations.size(), 0);
  Cycles cycles;

  const auto words = [&](const Situation& s) {
    return fmt::format("{} with T = {}", to_string(s), step_time);
  };
  const auto next = [&](const Situation& before) {
    const Slice slice = slices.advance(before);
    const bool good =
        theorem.check(is_step(slice) && keeps_rule_1(slice), [&] { return words(before); });
    return good ? slice.next : before;
  };
  const auto inspect = [&](std::span<const Situation> cycle) {
    std::size_t in_the_air = 0;
    bool tripod = false;
    for (const Situation& s : cycle) {
      const LegSet air = airborne(s);
      in_the_air += static_cast<std::size_t>(air.size());
      tripod = tripod || air == first_tripod(n) || air == second_tripod(n);
    }
    const auto m = static_cast<std::size_t>(std::min(ccn, n - ccn));
    theorem.check(in_the_air == m * cycle.size() && tripod == (2 * ccn == n), [&] {
      return fmt::format("{} legs in the air over {} slices, from {}", in_the_air, cycle.size(),
                         words(cycle.front()));
    });
    cycles.shortest = std::min(cycles.shortest, cycle.size());
    cycles.longest = std::max(cycles.longest, cycle.size());
  };
  situations.for_each_start([&](const Situation& start) {
    if (!theorem.holds()) return;
    settle(
        start, memo, [&](const Situation& s) { return situations.key(s); }, next, inspect);
    ++cycles.starts;
  });
  return cycles;
}

}  // namespace

Theorem throughput(const Rules& rules, const Scope& scope) {
  Theorem theorem;
  theorem.name = "throughput";
  theorem.statement =
      "Without adjustment, with equal step times, m = min(CCN, n - CCN) legs are in the air on "
      "average, exactly; and the tripod gait appears only if CCN = n/2.";
  theorem.convention =
      "Every state, every set of remaining air times 0 … T of priority legs, T = 1 up to the one "
      "given. Over the final cycle the slices in the air of all legs add up to m times its length.";
  theorem.table.columns = {"legs", "CCN", "T_up_to", "situations", "in_the_air", "cycle_slices"};
  for (const int n : scope.legs) {
    const int longest = n > 8 ? std::min(scope.step_time, 2) : scope.step_time;
    for (int ccn = 1; ccn < n; ++ccn) {
      std::int64_t starts = 0;
      Cycles cycles;
      for (int t = 1; t <= longest; ++t) {
        cycles = explore(theorem, rules, n, ccn, t);
        starts += cycles.starts;
      }
      theorem.cases += starts;
      const std::string slices = fmt::format("{} … {}", cycles.shortest, cycles.longest);
      theorem.table.add(n, ccn, longest, starts, std::min(ccn, n - ccn), slices);
    }
  }
  return theorem;
}

}  // namespace hexagait::verify

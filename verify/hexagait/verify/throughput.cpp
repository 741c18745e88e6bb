// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <hexagait/verify/detail/final_cycles.hpp>
#include <hexagait/verify/detail/theorems.hpp>

namespace hexagait::verify {

using namespace gait_state;

namespace {

std::vector<GaitState> states_with(int n, int ccn) {
  std::vector<GaitState> states = non_cyclic_states(n);
  std::erase_if(states, [ccn](const GaitState& state) { return state.ccn() != ccn; });
  return states;
}

void check_cycle(Theorem& theorem, std::span<const Situation> cycle, int ccn, int step_time) {
  const int n = cycle.front().state.n;
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
                       words_of(cycle.front(), step_time));
  });
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
      const std::vector<GaitState> states = states_with(n, ccn);
      std::int64_t starts = 0;
      std::size_t shortest_cycle = 0, longest_cycle = 0;  // of the last T [slices]
      for (int t = 1; t <= longest; ++t) {
        shortest_cycle = SIZE_MAX;
        longest_cycle = 0;
        starts += final_cycles(theorem, rules, states, t, Adjustment::none,
                               [&](std::span<const Situation> cycle) {
                                 check_cycle(theorem, cycle, ccn, t);
                                 shortest_cycle = std::min(shortest_cycle, cycle.size());
                                 longest_cycle = std::max(longest_cycle, cycle.size());
                               });
      }
      theorem.cases += starts;
      const std::string slices = fmt::format("{} … {}", shortest_cycle, longest_cycle);
      theorem.table.add(n, ccn, longest, starts, std::min(ccn, n - ccn), slices);
    }
  }
  return theorem;
}

}  // namespace hexagait::verify

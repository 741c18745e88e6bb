// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <hexagait/verify/detail/final_cycles.hpp>
#include <hexagait/verify/detail/theorems.hpp>

/// Rings that have closed over a lost leg: what the theorems of whole rings say, for odd n.
namespace hexagait::verify {

using namespace gait_state;

namespace {

/// The ring of a robot of n + 1 legs whose last leg is lost, so that legs are 0 … n − 1.
Ring odd_ring(int n) { return {n + 1, LegSet(1U << n)}; }

bool is_balanced(const GaitState& state) {
  return std::min(state.ccn(), state.n - state.ccn()) == state.n / 2;
}

/// Digits 0 … base − 1, least first; false after the last.
bool count_up(std::vector<int>& digits, int base) {
  for (int& digit : digits) {
    if (++digit < base) return true;
    digit = 0;
  }
  return false;
}

// (gait 3) without memory, with lags so close that most are tied in a chain.
void check_ties(Theorem& theorem, int n) {
  constexpr double kSpacing = 0.4 * kTolerance;
  const int base = n <= 5 ? 8 : n <= 7 ? 6 : 4;
  GaitInput input{LegArray<double>(n + 1, 0.0), {}, {}, odd_ring(n).lost};
  std::vector<int> digits(static_cast<std::size_t>(n), 0);
  std::int64_t cases = 0;
  do {
    for (LegId leg = 0; leg < n; ++leg)
      input.lag[leg] = kSpacing * digits[static_cast<std::size_t>(leg)];
    const GaitState fresh = fresh_relations(input, kTolerance);
    theorem.check(!fresh.is_cyclic(), [&] {
      return fmt::format("{} from lags of {} times 0.4 times the tolerance", to_string(fresh),
                         fmt::join(digits, ", "));
    });
    ++cases;
  } while (theorem.holds() && count_up(digits, base));
  theorem.cases += cases;
  theorem.table.add(n, "lags with ties", cases);
}

void check_balance(Theorem& theorem, int n) {
  const std::vector<GaitState> states = non_cyclic_states(odd_ring(n));
  for (const GaitState& state : states) {
    const GaitState result = balanced(state);
    theorem.check(is_balanced(result) && priority_legs(result) == priority_legs(state), [&] {
      return fmt::format("{} becomes {}", to_string(state), to_string(result));
    });
  }
  theorem.cases += static_cast<std::int64_t>(states.size());
  theorem.table.add(n, "states to balance", static_cast<std::int64_t>(states.size()));
}

// Any stored and raw relations, for a ring of five.
void check_combine(Theorem& theorem, const Rules& rules) {
  const Ring ring = odd_ring(5);
  const std::vector<GaitState> states = non_cyclic_states(ring), any = all_relations(ring);
  std::int64_t cases = 0;
  for (const GaitState& stored : states)
    for (const GaitState& before : any)
      for (const GaitState& now : any)
        for (const GaitState& fresh : states) {
          const GaitState result = rules.combine({stored, before, now, fresh, {}}).state;
          theorem.check(!result.is_cyclic() && !may_step(balanced(result), {}).empty(), [&] {
            return fmt::format("stored {}, raw {} then {}, fresh {}", to_string(stored),
                               to_string(before), to_string(now), to_string(fresh));
          });
          ++cases;
        }
  theorem.cases += cases;
  theorem.table.add(5, "stored and raw relations", cases);
}

}  // namespace

Theorem odd_no_lock(const Rules& rules, const Scope& scope) {
  Theorem theorem;
  theorem.name = "odd_no_lock";
  theorem.statement =
      "In a ring that has closed over a lost leg relations are never cyclic, however close the "
      "lags; the adjustment leads to the nearer CCN of (n - 1)/2 and (n + 1)/2 and keeps every "
      "< > pair; and the update ends in a state in which a leg may step.";
  theorem.convention =
      "Rings of n = 5 legs and more. Lags are multiples of 0.4 times the tolerance of ties: up to "
      "7 "
      "for 5 legs, 5 for 7, 3 for more.";
  theorem.table.columns = {"legs", "varied", "cases"};
  for (const int n : scope.odd_legs) {
    check_ties(theorem, n);
    check_balance(theorem, n);
  }
  check_combine(theorem, rules);
  return theorem;
}

namespace {

/// Lags from which a state of a robot's ring follows.
LegArray<double> lags_with_gap(const GaitState& state) {
  const Ring ring = state.ring();
  const LegArray<double> by_place = lags_of({state.bits, state.n, odd_ring(state.n).lost});
  LegArray<double> lag(ring.legs, 0.0);
  for (int k = 0; k < state.n; ++k) lag[leg_at(k, ring)] = by_place[leg_at(k, odd_ring(state.n))];
  return lag;
}

// Rule 1 by the order of the robot's legs, not by the ring that has closed.
bool flies_beside_another(LegSet airborne, LegId lost, int n) {
  LegId before = -1, first = -1;
  for (int k = 0; k < n; ++k) {
    const LegId leg = leg_at(k, n);
    if (leg == lost) continue;
    if (first < 0) first = leg;
    if (before >= 0 && airborne.contains(before) && airborne.contains(leg)) return true;
    before = leg;
  }
  return airborne.contains(before) && airborne.contains(first);
}

void check_rule_1(Theorem& theorem, const Rules& rules, LegId lost) {
  const Ring ring(kLegs, LegSet(1U << lost));
  const std::vector<GaitState> states = non_cyclic_states(ring), any = all_relations(ring);
  std::int64_t cases = 0;
  const auto check = [&](GaitLatch latch, const GaitInput& input) {
    if (!theorem.holds()) return;
    const GaitDecision decision = rules.update(latch, input, {.tie_tolerance = kTolerance});
    const bool keeps = !flies_beside_another(input.airborne | decision.may_step, lost, kLegs) &&
                       !decision.may_step.contains(lost);
    const bool walks_on = !input.airborne.empty() || !decision.may_step.empty();
    theorem.check(keeps && walks_on && is_balanced(decision.state), [&] {
      return fmt::format("{} without leg {}, legs in the air {:06b}", to_string(decision.state),
                         lost, input.airborne.bits());
    });
    ++cases;
  };
  for (const GaitState& order : states) {
    const LegArray<double> lags = lags_with_gap(order);
    for (std::uint32_t bits = 0; bits < (1U << kLegs); ++bits) {
      const LegSet air(bits);
      if (air.contains(lost) || flies_beside_another(air, lost, kLegs)) continue;
      for (const GaitState& stored : states)
        for (const GaitState& raw : any)
          for (const LegSet air_before : {air, ring.present()})
            check({stored, raw, air_before}, {lags, air, {}, ring.lost});
    }
  }
  theorem.cases += cases;
  theorem.table.add(lost, ring.size(), cases);
}

}  // namespace

Theorem odd_rule_1(const Rules& rules, const Scope&) {
  Theorem theorem;
  theorem.name = "odd_rule_1";
  theorem.statement =
      "Six legs of which any one is lost: two neighbours of those that are left, over the gap too, "
      "are never in the air together; and when all five stand, one may step.";
  theorem.convention =
      "As rule_1: one update from every stored state, every raw memory, every order of the feet "
      "and every set of legs in the air that keeps rule 1.";
  theorem.table.columns = {"lost_leg", "left", "cases"};
  for (LegId lost = 0; lost < 6; ++lost) check_rule_1(theorem, rules, lost);
  return theorem;
}

namespace {

std::vector<GaitState> balanced_states_of(const Ring& ring) {
  std::vector<GaitState> states = non_cyclic_states(ring);
  std::erase_if(states, [](const GaitState& state) { return !is_balanced(state); });
  return states;
}

// (n − 1)/2 legs are in the air on average over the cycle, and each leg as often.
void check_cycle(Theorem& theorem, std::span<const Situation> cycle, int step_time) {
  const int n = cycle.front().state.n;
  std::size_t in_the_air = 0;
  std::array<std::size_t, kMaxLegs> of{};
  for (const Situation& s : cycle)
    for (LegId leg = 0; leg < n; ++leg)
      if (airborne(s).contains(leg)) ++in_the_air, ++of[static_cast<std::size_t>(leg)];
  bool even = true;
  for (LegId leg = 1; leg < n; ++leg) even = even && of[static_cast<std::size_t>(leg)] == of[0];
  const auto m = static_cast<std::size_t>(n / 2);
  theorem.check(in_the_air == m * cycle.size() && even, [&] {
    return fmt::format("{} legs in the air over {} slices, from {}", in_the_air, cycle.size(),
                       words_of(cycle.front(), step_time));
  });
}

}  // namespace

Theorem odd_throughput(const Rules& rules, const Scope& scope) {
  Theorem theorem;
  theorem.name = "odd_throughput";
  theorem.statement =
      "In an odd ring with CCN = (n - 1)/2 or (n + 1)/2, with equal step times T, (n - 1)/2 legs "
      "are in the air on average, and all legs step equally often.";
  theorem.convention =
      "Every such state, every set of remaining air times 0 … T of priority legs, T = 1 up to the "
      "one given, over the final cycle. So a leg steps once in n T/m, with m = (n - 1)/2.";
  theorem.table.columns = {"legs", "T_up_to", "situations", "in_the_air", "longest_cycle"};
  for (const int n : scope.odd_legs) {
    const int longest = n > 7 ? std::min(scope.step_time, 2) : scope.step_time;
    const std::vector<GaitState> states = balanced_states_of(odd_ring(n));
    std::int64_t starts = 0, longest_cycle = 0;
    for (int t = 1; t <= longest; ++t)
      starts += final_cycles(
          theorem, rules, states, t, Adjustment::latched, [&](std::span<const Situation> cycle) {
            check_cycle(theorem, cycle, t);
            longest_cycle = std::max(longest_cycle, static_cast<std::int64_t>(cycle.size()));
          });
    theorem.cases += starts;
    theorem.table.add(n, longest, starts, n / 2, longest_cycle);
  }
  return theorem;
}

}  // namespace hexagait::verify

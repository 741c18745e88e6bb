// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <hexagait/verify/detail/situation.hpp>
#include <hexagait/verify/detail/theorems.hpp>

namespace hexagait::verify {

using namespace gait_state;

namespace {

/// Sets of legs without neighbours: those that may be in the air by rule 1.
std::vector<LegSet> flights() {
  std::vector<LegSet> sets;
  for (std::uint32_t bits = 0; bits <= ring_mask(kLegs); ++bits)
    if (!breaks_rule_1(LegSet(bits), kLegs)) sets.push_back(LegSet(bits));
  return sets;
}

std::string words(const LatchStep& step) {
  return fmt::format("stored {}, raw {} then {}, fresh {}, urgent legs {:06b}",
                     to_string(step.stored), to_string(step.raw_before), to_string(step.raw_now),
                     to_string(step.fresh), step.urgent.bits());
}

/// By the state's bits: does its adjustment have CCN = 3 and a leg that may step?
std::vector<bool> lively(const Rules& rules) {
  std::vector<bool> result(1U << kLegs, false);
  for (const GaitState& state : non_cyclic_states(kLegs)) {
    const GaitState balanced = rules.adjusted(state, kLegs / 2);
    result[state.bits] = balanced.ccn() == kLegs / 2 && !may_step(balanced, LegSet()).empty();
  }
  return result;
}

}  // namespace

Theorem no_lock(const Rules& rules, const Scope&) {
  Theorem theorem;
  theorem.name = "no_lock";
  theorem.statement =
      "From any stored and raw relations the update (gait 4) ends in a consistent state with CCN = "
      "3 "
      "in which a leg may step: it never locks.";
  theorem.convention =
      "Six legs. Stored and fresh relations are not cyclic, raw ones may be. Each triple with "
      "every "
      "set of fresh relations, and with every set of urgent legs.";
  theorem.table.columns = {"varied", "cases", "gave_way_to_fresh"};

  const std::vector<bool> is_lively = lively(rules);
  const std::vector<GaitState> states = non_cyclic_states(kLegs), any = all_relations(kLegs);
  std::int64_t cases = 0, cyclic = 0;
  const auto check = [&](const LatchStep& step) {
    if (!theorem.holds()) return;
    const Combined result = rules.combine(step);
    theorem.check(is_lively[result.state.bits], [&] { return words(step); });
    cyclic += result.was_cyclic ? 1 : 0;
    ++cases;
  };
  const auto close = [&](const char* varied) {
    theorem.table.add(varied, cases, cyclic);
    theorem.cases += cases;
    cases = cyclic = 0;
  };
  for (const GaitState& stored : states)
    for (const GaitState& before : any)
      for (const GaitState& now : any)
        for (const GaitState& fresh : states) check({stored, before, now, fresh, LegSet()});
  close("fresh relations");
  for (const GaitState& stored : states)
    for (const GaitState& before : any)
      for (const GaitState& now : any)
        for (std::uint32_t urgent = 0; urgent <= ring_mask(kLegs); ++urgent)
          check({stored, before, now, now.is_cyclic() ? stored : now, LegSet(urgent)});
  close("urgent legs");
  return theorem;
}

Theorem rule_1(const Rules& rules, const Scope&) {
  Theorem theorem;
  theorem.name = "rule_1";
  theorem.statement =
      "Two neighbours are never in the air together, whatever the ground, the step times and the "
      "headings; and when all legs stand, one may step.";
  theorem.convention =
      "Six legs. One update from every stored state, every raw memory, every order of the feet and "
      "every set of legs in the air that keeps rule 1; of the other legs, none or all have just "
      "landed. What may lift keeps the rule, so by induction it always holds. A foot that loses "
      "the "
      "ground by itself is a fault, not a step.";

  const std::vector<GaitState> states = non_cyclic_states(kLegs), any = all_relations(kLegs);
  const std::vector<LegSet> sets = flights();
  const auto check = [&](GaitLatch latch, const GaitInput& input, const GaitState& order) {
    if (!theorem.holds()) return;
    const LatchStep start{latch.stored, latch.raw, order, order, {}};
    const GaitDecision decision = rules.update(latch, input, {.tie_tolerance = kTolerance});
    const bool keeps_rule_1 = !breaks_rule_1(input.airborne | decision.may_step, kLegs);
    const bool walks_on = !input.airborne.empty() || !decision.may_step.empty();
    theorem.check(keeps_rule_1 && walks_on && decision.state.ccn() == kLegs / 2, [&] {
      return fmt::format("{}, legs in the air {:06b}", words(start), input.airborne.bits());
    });
    ++theorem.cases;
  };
  for (const GaitState& order : states) {
    const LegArray<double> lags = lags_of(order);
    for (const LegSet air : sets)
      for (const GaitState& stored : states)
        for (const GaitState& raw : any)
          for (const LegSet air_before : {air, LegSet::all(kLegs)})
            check({stored, raw, air_before}, {lags, air, {}}, order);
  }
  theorem.table.columns = {"stored", "raw", "orders", "sets_in_the_air", "landed"};
  const auto count = [](const auto& list) { return static_cast<std::int64_t>(list.size()); };
  theorem.table.add(count(states), count(any), count(states), count(sets), 2);
  return theorem;
}

}  // namespace hexagait::verify

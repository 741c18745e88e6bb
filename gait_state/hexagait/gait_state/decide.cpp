// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/gait_state/decide.hpp>
#include <hexagait/gait_state/ring.hpp>

namespace hexagait::gait_state {
namespace {

// Those beside which everybody surely stands. A tripod lifts as a whole, or not at all.
LegSet beside_sure_legs(LegSet may_step, LegSet unsure, Stepping stepping, const Ring& ring) {
  if (unsure.empty()) return may_step;
  if (stepping == Stepping::tripod) return {};
  return without(may_step, neighbours_of(unsure, ring));
}

}  // namespace

StepDecision decide(GaitMemory& memory, const GaitInput& legs, const StepConditions& conditions,
                    const GaitParams& gait, const StepperParams& stepper) noexcept {
  StepDecision result;
  result.gait = memory.latch.update(legs, gait);
  LegSet may_step = conditions.crawls ? conditions.open : result.gait.may_step;
  if (!conditions.walking) may_step = {};
  const Ring ring(legs.lag.size(), legs.lost);
  const StepperParams used = conditions.crawls || !legs.lost.empty() ? StepperParams{} : stepper;
  const LegSet sure = beside_sure_legs(may_step, conditions.unsure, used.stepping, ring);
  LegSet lifts = without(sure, legs.airborne);
  if (conditions.steady && !lifts.empty()) lifts = conditions.steady(lifts);
  result.lifts = memory.stepper.update({.time = conditions.time,
                                        .airborne = legs.airborne,
                                        .may_step = lifts | (may_step & legs.airborne),
                                        .rear_edge = conditions.rear_edge},
                                       used);
  result.waits = without(may_step, result.lifts);
  result.rule1_violations = rule_1_violations(result.lifts, legs.airborne, ring);
  return result;
}

}  // namespace hexagait::gait_state

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/gait_state/decide.hpp>
#include <hexagait/gait_state/ring.hpp>

namespace hexagait::gait_state {

StepDecision decide(GaitMemory& memory, const GaitInput& legs, const StepConditions& conditions,
                    const GaitParams& gait, const StepperParams& stepper) noexcept {
  StepDecision result;
  result.gait = memory.latch.update(legs, gait);
  const LegSet may_step = conditions.walking ? result.gait.may_step : LegSet();
  result.lifts = memory.stepper.update({.time = conditions.time,
                                        .airborne = legs.airborne,
                                        .may_step = may_step,
                                        .rear_edge = conditions.rear_edge},
                                       stepper);
  result.waits = without(may_step, result.lifts);
  result.rule1_violations = rule_1_violations(result.lifts, legs.airborne, legs.lag.size());
  return result;
}

}  // namespace hexagait::gait_state

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <hexagait/verify/detail/situation.hpp>
#include <hexagait/verify/detail/theorems.hpp>
#include <limits>

// The theorems hold for the library's rules, and each rule that is broken is noticed.
namespace hexagait::verify {
namespace {

using namespace gait_state;
using ::testing::Contains;
using ::testing::ElementsAre;

const Scope kQuick{.legs = {4, 6}, .odd_legs = {5, 7}, .step_time = 2, .step_time_8 = 0};

Theorem quick_convergence(const Rules& rules) {
  return convergence(rules, kQuick, [](double) {});
}

std::vector<CaseValue> row(std::initializer_list<CaseValue> cells) { return cells; }
CaseValue number(std::int64_t value) { return value; }

TEST(Verify, FindsThatTheLibrarysRulesHoldAndTellsHowFarItHasGot) {
  double last = 0.0;
  const TheoremReport report = verify({}, kQuick, [&](double share) {
    EXPECT_GE(share, last);
    last = share;
  });
  EXPECT_NEAR(last, 1.0, 1e-9);
  EXPECT_EQ(report.theorems.size(), 14U);
  for (const Theorem& theorem : report.theorems) {
    EXPECT_TRUE(theorem.holds()) << theorem.name << ": " << theorem.counterexample;
    EXPECT_GT(theorem.cases, 0) << theorem.name;
    for (const auto& cells : theorem.table.rows)
      EXPECT_EQ(cells.size(), theorem.table.columns.size()) << theorem.name;
  }
}

// 20 states, each with air times 0 … T on six legs: 20 * 64 and 20 * 729. The bound is 3 T − 1.
TEST(Verify, CountsSituationsAndTheirWorstTransient) {
  const Theorem theorem = quick_convergence({});
  EXPECT_THAT(theorem.table.rows,
              Contains(row({number(6), "all", number(1), number(1280), number(2), number(2)})));
  EXPECT_THAT(theorem.table.rows,
              Contains(row({number(6), "all", number(2), number(14580), number(5), number(5)})));
}

// Each of the 12 cells of [PC04] Table 1; 5 of them with CCN 1 or 5 and 2 or 4 are mirrored.
TEST(Verify, CountsTheStatesOfTable1) {
  std::vector<std::int64_t> counts;
  for (const auto& cells : states({}, kQuick).table.rows)
    counts.push_back(std::get<std::int64_t>(cells[2]));
  EXPECT_THAT(counts, ElementsAre(6, 6, 6, 3, 6, 6, 6, 2, 6, 6, 3, 6));
}

// What is wrong with a rule, and the theorems that notice.

TEST(BrokenRule, WithTheSignOfTheLagFlipped) {
  Rules rules;
  rules.update = [](GaitLatch& latch, GaitInput input, const GaitParams& params) {
    for (double& lag : input.lag) lag = -lag;
    return latch.update(input, params);
  };
  EXPECT_FALSE(quick_convergence(rules).holds());
  EXPECT_FALSE(throughput(rules, kQuick).holds());
  EXPECT_FALSE(latched_convergence(rules, kQuick).holds());
}

TEST(BrokenRule, WithoutTheLatch) {
  Rules rules;
  rules.update = [](GaitLatch& latch, const GaitInput& input, GaitParams params) {
    if (params.adjustment == Adjustment::latched) params.adjustment = Adjustment::literal;
    return latch.update(input, params);
  };
  EXPECT_FALSE(latched_convergence(rules, kQuick).holds());
}

TEST(BrokenRule, WithAnAdjustmentThatIsNotLiteralInTheLiteralReading) {
  Rules rules;
  rules.update = [](GaitLatch& latch, const GaitInput& input, GaitParams params) {
    if (params.adjustment == Adjustment::literal) params.adjustment = Adjustment::latched;
    return latch.update(input, params);
  };
  EXPECT_FALSE(literal_reading(rules, kQuick).holds());
}

TEST(BrokenRule, WithoutTheCyclicCase) {
  Rules rules;
  rules.combine = [](const LatchStep& step) {
    const Combined combined = combine(step);
    return combined.was_cyclic ? Combined{{ring_mask(6), 6}, false} : combined;
  };
  EXPECT_FALSE(no_lock(rules, kQuick).holds());
  EXPECT_FALSE(odd_no_lock(rules, kQuick).holds());
}

// The lost leg still keeps its neighbours apart, as if it stood between them.
TEST(BrokenRule, WithARingThatDoesNotClose) {
  Rules rules;
  rules.update = [](GaitLatch& latch, GaitInput input, const GaitParams& params) {
    latch.stored.n = latch.raw.n = input.lag.size();
    latch.stored.lost = latch.raw.lost = input.lost = {};
    return latch.update(input, params);
  };
  EXPECT_FALSE(odd_rule_1(rules, kQuick).holds());
}

TEST(BrokenRule, WithAnOddRingThatIsNotBalanced) {
  Rules rules;
  rules.update = [](GaitLatch& latch, const GaitInput& input, GaitParams params) {
    params.adjustment = Adjustment::none;
    return latch.update(input, params);
  };
  EXPECT_FALSE(odd_rule_1(rules, kQuick).holds());
}

// Legs 1 and 3 stand in each other's places: 0 and 3, 1 and 5 are no longer neighbours.
TEST(BrokenRule, WithTwoLegsOfTheRingExchanged) {
  const auto exchanged = [](LegSet legs) {
    LegSet result = legs;
    result.set(1, legs.contains(3));
    result.set(3, legs.contains(1));
    return result;
  };
  Rules rules;
  rules.update = [exchanged](GaitLatch& latch, GaitInput input, const GaitParams& params) {
    if (input.lag.size() >= 6) {
      std::swap(input.lag[1], input.lag[3]);
      input.airborne = exchanged(input.airborne);
    }
    GaitDecision decision = latch.update(input, params);
    if (input.lag.size() >= 6) decision.may_step = exchanged(decision.may_step);
    return decision;
  };
  EXPECT_FALSE(rule_1(rules, kQuick).holds());
  EXPECT_FALSE(quick_convergence(rules).holds());
}

// `< > >` becomes `> < >`: as good for the CCN, but another leg gets the priority.
TEST(BrokenRule, WithAnAdjustmentThatMovesAPair) {
  Rules rules;
  rules.adjusted = [](GaitState state, int ccn) {
    const GaitState result = adjusted(state, ccn);
    return result == state ? result : GaitState{from_before(result.bits, result.n), result.n};
  };
  EXPECT_FALSE(adjustment(rules, kQuick).holds());
}

TEST(BrokenRule, WithAnAdjustmentThatGivesUp) {
  Rules rules;
  rules.adjusted = [](GaitState state, int) { return state; };
  EXPECT_FALSE(adjustment(rules, kQuick).holds());
  EXPECT_FALSE(no_lock(rules, kQuick).holds());
}

TEST(BrokenRule, WithRearLegsThatDoNotWaitForEachOther) {
  Rules rules;
  rules.step = [](Stepper&, const StepperInput& input, const StepperParams&) {
    return input.may_step;
  };
  EXPECT_FALSE(wave_gaits(rules, kQuick).holds());
}

// Not a broken rule: half a period after the other is enough for the same attractor. The whole one
// keeps a rear leg from stepping twice in a row when the other is held up.
TEST(RearLegRule, HasTheSameAttractorWithoutTheWholePeriod) {
  Rules rules;
  rules.step = [](Stepper& stepper, const StepperInput& input, const StepperParams& params) {
    LegSet lifted = stepper.update(input, params);
    for (const LegId rear : {leg_at(input.rear_edge, 6), leg_at((input.rear_edge + 1) % 6, 6)}) {
      Stepper forgetful = stepper;
      forgetful.lifted_at[rear] = -std::numeric_limits<double>::infinity();
      lifted = lifted | (forgetful.update(input, params) & LegSet(1U << rear));
    }
    return lifted;
  };
  EXPECT_TRUE(wave_gaits(rules, kQuick).holds());
}

// The pair in front is delayed instead of the one behind.
TEST(BrokenRule, WithTheHalfPeriodOfTheWrongLegs) {
  Rules rules;
  rules.step = [](Stepper& stepper, StepperInput input, const StepperParams& params) {
    input.rear_edge = (input.rear_edge + 3) % 6;
    return stepper.update(input, params);
  };
  EXPECT_FALSE(wave_gaits(rules, kQuick).holds());
}

TEST(BrokenRule, WithAStepperThatLiftsWhomItWants) {
  Rules rules;
  rules.step = [](Stepper&, const StepperInput& input, const StepperParams&) {
    return without(LegSet::all(6), input.airborne);
  };
  EXPECT_FALSE(duty_factor_changes(rules, kQuick).holds());
}

}  // namespace
}  // namespace hexagait::verify

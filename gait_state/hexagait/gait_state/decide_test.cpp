// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/gait_state/decide.hpp>
#include <hexagait/gait_state/ring.hpp>
#include <random>

namespace hexagait::gait_state::decide_test {
namespace {

constexpr GaitParams kParams{.tie_tolerance = 1e-3};

constexpr int kLegs = 6;

GaitInput standing() { return {LegArray<double>(kLegs, 0.0), LegSet(), LegSet()}; }

// Equal lags: ties go to the first tripod. One call after the other, of the latch and the stepper.
TEST(Decide, IsTheLatchAndThenTheStepper) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> lag(-0.05, 0.05);
  GaitMemory memory(kLegs, 1.0);
  GaitLatch latch;
  Stepper stepper(kLegs, 1.0);
  const StepperParams wave{.stepping = Stepping::wave, .duty_factor = 0.75};
  for (int k = 0; k < 500; ++k) {
    GaitInput input = standing();
    for (double& value : input.lag) value = lag(random);
    input.airborne = LegSet(static_cast<std::uint32_t>(random() % 64U));
    const double time = 0.1 * k;
    const StepDecision decision = decide(memory, input, {.time = time}, kParams, wave);
    const GaitDecision gait = latch.update(input, kParams);
    ASSERT_EQ(decision.gait.may_step, gait.may_step);
    ASSERT_EQ(decision.lifts,
              stepper.update({.time = time, .airborne = input.airborne, .may_step = gait.may_step},
                             wave));
    ASSERT_EQ(decision.lifts | decision.waits, gait.may_step);
    ASSERT_TRUE((decision.lifts & decision.waits).empty());
    ASSERT_TRUE(decision.rule1_violations.empty());
  }
}

TEST(Decide, LiftsNobodyOfARobotThatIsToStand) {
  GaitMemory memory(kLegs, 1.0);
  const StepDecision decision = decide(memory, standing(), {.walking = false}, kParams, {});
  EXPECT_FALSE(decision.gait.may_step.empty());
  EXPECT_TRUE((decision.lifts | decision.waits).empty());
}

// Of all 64 sets of legs that feel nothing: their neighbours wait, the others lift as they would.
TEST(Decide, LiftsNobodyBesideALegThatFeelsNothing) {
  for (const Stepping stepping : {Stepping::free, Stepping::tripod})
    for (std::uint32_t bits = 0; bits < 64; ++bits) {
      const LegSet unsure(bits);
      GaitMemory memory(kLegs, 1.0);
      const StepDecision decision =
          decide(memory, standing(), {.unsure = unsure}, kParams, {.stepping = stepping});
      const LegSet tripod = first_tripod(kLegs);
      LegSet lifts = without(tripod, neighbours_of(unsure, kLegs));
      if (stepping == Stepping::tripod && !unsure.empty()) lifts = {};
      ASSERT_EQ(decision.lifts, lifts) << bits;
      ASSERT_EQ(decision.waits, without(tripod, lifts)) << bits;
    }
}

// The neighbours of leg 0 (LF) are 1 (RF) and 2 (LM); decide() itself never breaks the rule.
TEST(RuleOne, IsBrokenByLegsThatLiftTogetherAndBesideALegInTheAir) {
  const LegSet lf(1U), rf(2U), lm(4U);
  EXPECT_EQ(rule_1_violations(lf, rf, kLegs), lf);
  EXPECT_EQ(rule_1_violations(lf | rf, LegSet(), kLegs), lf | rf);
  EXPECT_EQ(rule_1_violations(rf | lm, lf, kLegs), rf | lm);
  EXPECT_EQ(rule_1_violations(rf | lm, LegSet(), kLegs), LegSet());
  EXPECT_EQ(rule_1_violations(LegSet(), LegSet::all(kLegs), kLegs), LegSet());
}

}  // namespace
}  // namespace hexagait::gait_state::decide_test

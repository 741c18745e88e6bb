// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/gait_state/stepper.hpp>
#include <vector>

// Who steps, of those that may. Legs 5 and 4 are the rear ones of six.
namespace hexagait::gait_state {
namespace {

constexpr double kStep = 2.0;

LegSet legs(std::initializer_list<LegId> members) {
  LegSet set;
  for (const LegId leg : members) set.insert(leg);
  return set;
}

StepperParams wave(double duty_factor) {
  return {.stepping = Stepping::wave, .duty_factor = duty_factor};
}

// All legs stand, and `may_step` may step.
LegSet ask(Stepper& stepper, double time, LegSet may_step, const StepperParams& params) {
  return stepper.update({.time = time, .airborne = {}, .may_step = may_step}, params);
}

TEST(FreeStepping, LiftsAllThatMayStep) {
  Stepper stepper(6, kStep);
  EXPECT_EQ(ask(stepper, 0.0, legs({0, 3, 4}), {}), legs({0, 3, 4}));
  EXPECT_EQ(ask(stepper, 0.0, LegSet(), {}), LegSet());
}

// β = 3/4: P = 2 / (1 − 3/4) = 8. Leg 4 may follow 4 after leg 5, leg 5 itself 8 after itself.
TEST(WaveStepping, LetsARearLegWaitHalfAPeriodForTheOtherAndAWholeOneForItself) {
  Stepper stepper(6, kStep);
  EXPECT_EQ(ask(stepper, 0.0, legs({5}), wave(0.75)), legs({5})) << "nobody has lifted before";
  stepper.stepping = LegSet();  // that step is not measured here
  EXPECT_EQ(ask(stepper, 3.9, legs({4}), wave(0.75)), LegSet());
  EXPECT_EQ(ask(stepper, 7.9, legs({5}), wave(0.75)), LegSet());
  EXPECT_EQ(ask(stepper, 8.0, legs({5}), wave(0.75)), legs({5}));
  stepper.stepping = LegSet();
  EXPECT_EQ(ask(stepper, 11.9, legs({4}), wave(0.75)), LegSet());
  EXPECT_EQ(ask(stepper, 12.0, legs({4}), wave(0.75)), legs({4}));
}

TEST(WaveStepping, NeverDelaysOtherLegsAndAddsNone) {
  Stepper stepper(6, kStep);
  (void)ask(stepper, 0.0, legs({5}), wave(0.8));
  for (std::uint32_t bits = 0; bits < 64; ++bits) {
    Stepper copy = stepper;
    const LegSet lifted = ask(copy, 0.1, LegSet(bits), wave(0.8));
    EXPECT_EQ(lifted, LegSet(bits) & legs({0, 1, 2, 3})) << bits;
  }
}

// Turned up, the same leg waits on; turned down, it goes at once: 8 and 5 after its last lift.
TEST(WaveStepping, FollowsTheDutyFactorAtOnce) {
  Stepper stepper(6, kStep);
  (void)ask(stepper, 0.0, legs({5}), wave(0.75));
  stepper.stepping = LegSet();
  EXPECT_EQ(ask(stepper, 5.0, legs({5}), wave(0.75)), LegSet());
  EXPECT_EQ(ask(stepper, 5.0, legs({5}), wave(0.6)), legs({5}));
}

// Edge 0 joins legs 0 and 1: walking backwards they are the rear ones.
TEST(WaveStepping, TakesTheRearLegsFromTheEdge) {
  Stepper stepper(6, kStep);
  const auto at = [&](double time, LegSet may_step) {
    return stepper.update({.time = time, .airborne = {}, .may_step = may_step, .rear_edge = 0},
                          wave(0.75));
  };
  EXPECT_EQ(at(0.0, legs({0})), legs({0}));
  stepper.stepping = LegSet();
  EXPECT_EQ(at(3.9, legs({1, 4})), legs({4}));
  EXPECT_EQ(at(4.0, legs({1})), legs({1}));
}

// 0.1 + 0.2 > 0.3: a period that is met but for rounding is met.
TEST(WaveStepping, DoesNotWaitForRounding) {
  Stepper stepper(6, 0.1);
  double time = 0.0;
  (void)ask(stepper, time, legs({5}), wave(0.5));
  stepper.stepping = LegSet();
  for (int i = 0; i < 10; ++i) time += 0.02;  // 0.19999999999999998
  EXPECT_EQ(ask(stepper, time, legs({5}), wave(0.5)), legs({5}));
}

// A step lasts until the leg is seen to stand; T is the longest of the legs' last ones.
TEST(StepTime, IsMeasuredFromLiftToLanding) {
  Stepper stepper(6, kStep);
  EXPECT_EQ(stepper.longest_step(), kStep);
  (void)ask(stepper, 10.0, legs({1, 2}), {});
  (void)stepper.update({.time = 11.0, .airborne = legs({1, 2}), .may_step = {}}, {});
  EXPECT_EQ(stepper.stepping, legs({1, 2}));
  (void)stepper.update({.time = 12.5, .airborne = legs({2}), .may_step = {}}, {});
  (void)stepper.update({.time = 13.5, .airborne = LegSet(), .may_step = {}}, {});
  EXPECT_EQ(stepper.step_time[1], 2.5);
  EXPECT_EQ(stepper.step_time[2], 3.5);
  EXPECT_EQ(stepper.step_time[0], kStep) << "not seen yet";
  EXPECT_EQ(stepper.longest_step(), 3.5);
  EXPECT_EQ(stepper.stepping, LegSet());
}

// A leg that has searched for 8 is not waited for as long once more: P = 2 · 3, not 2 · 8.
TEST(WaveStepping, DoesNotWaitForALongStepAgain) {
  Stepper stepper(6, kStep);
  (void)ask(stepper, 0.0, legs({5}), wave(0.5));
  (void)stepper.update({.time = 8.0, .airborne = LegSet(), .may_step = {}}, {});
  ASSERT_EQ(stepper.longest_step(), 8.0);
  const StepperParams bounded{.stepping = Stepping::wave, .duty_factor = 0.5, .longest_step = 3.0};
  Stepper other = stepper;
  EXPECT_EQ(ask(other, 9.0, legs({5}), wave(0.5)), LegSet());
  EXPECT_EQ(ask(stepper, 9.0, legs({5}), bounded), legs({5}));
  stepper.stepping = LegSet();
  EXPECT_EQ(ask(stepper, 14.9, legs({5}), bounded), LegSet());
  EXPECT_EQ(ask(stepper, 15.0, legs({5}), bounded), legs({5}));
}

TEST(TripodStepping, LiftsTheTripodsInTurnWhenAllStandWhateverTheGaitState) {
  Stepper stepper(6, kStep);
  const StepperParams tripod{.stepping = Stepping::tripod};
  const LegSet may_step = legs({1});  // somebody may whenever all stand
  EXPECT_EQ(ask(stepper, 0.0, may_step, tripod), first_tripod(6));
  for (const LegSet air : {first_tripod(6), legs({3})})
    EXPECT_EQ(stepper.update({.time = 1.0, .airborne = air, .may_step = may_step}, tripod),
              LegSet());
  EXPECT_EQ(ask(stepper, 2.0, may_step, tripod), second_tripod(6));
  EXPECT_EQ(ask(stepper, 4.0, may_step, tripod), first_tripod(6));
}

// A robot that is told to stand hands over an empty set.
TEST(TripodStepping, StaysDownWhileNobodyMayStepAndThenGoesOnInTurn) {
  Stepper stepper(6, kStep);
  const StepperParams tripod{.stepping = Stepping::tripod};
  EXPECT_EQ(ask(stepper, 0.0, LegSet(), tripod), LegSet());
  EXPECT_EQ(ask(stepper, 1.0, legs({1}), tripod), first_tripod(6));
}

TEST(HindmostEdge, IsBetweenTheLastLegs) {
  for (const int n : {4, 6, 8, 10, 12}) {
    EXPECT_EQ(leg_at(hindmost_edge(n), n), n - 1);
    EXPECT_EQ(leg_at(hindmost_edge(n) + 1, n), n - 2);
  }
}

}  // namespace
}  // namespace hexagait::gait_state

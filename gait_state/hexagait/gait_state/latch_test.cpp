// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/gait_state/latch.hpp>
#include <string>
#include <type_traits>
#include <vector>

// The rules of the latch one by one, on six legs. Lags are in units of the tolerance.
namespace hexagait::gait_state::latch_test {
namespace {

constexpr double kTolerance = 1e-3;
constexpr GaitParams kParams{.tie_tolerance = kTolerance};
const LegSet kNone;

LegSet legs(std::initializer_list<LegId> members) {
  LegSet set;
  for (const LegId leg : members) set.insert(leg);
  return set;
}

// Lags in ring order: of legs 0 1 3 5 4 2.
GaitInput input(const std::vector<double>& ring_lags, LegSet airborne = kNone,
                LegSet urgent = kNone) {
  const int n = static_cast<int>(ring_lags.size());
  GaitInput result{LegArray<double>(n), airborne, urgent};
  for (int k = 0; k < n; ++k) {
    result.lag[leg_at(k, n)] = ring_lags[static_cast<std::size_t>(k)] * kTolerance;
  }
  return result;
}

std::string raw(GaitLatch& latch, const GaitInput& in) {
  return to_string(latch.update(in, kParams).raw);
}
std::string state(GaitLatch& latch, const GaitInput& in, Adjustment mode = Adjustment::latched) {
  return to_string(latch.update(in, {.tie_tolerance = kTolerance, .adjustment = mode}).state);
}

// A monotone row of lags: leg 0 lags least, leg 2 (position 5) most. CCN 5.
const std::vector<double> kStaircase = {10, 20, 30, 40, 50, 60};

TEST(RawRelation, GivesPriorityToTheLegThatLagsMore) {
  GaitLatch latch;
  EXPECT_EQ(raw(latch, input({10, 30, 20, 60, 50, 40})), "<><>>>");
  EXPECT_EQ(raw(latch, input({-10, -30, -20, -60, -50, -40})), "><><<<");
}

TEST(RawRelation, OfATieFavoursTheFirstTripod) {
  GaitLatch latch;
  const GaitDecision all_equal = latch.update(input({7, 7, 7, 7, 7, 7}), kParams);
  EXPECT_EQ(all_equal.may_step, first_tripod(6));
  // Differences of up to the tolerance are ties, whichever way they point.
  EXPECT_EQ(to_string(fresh_relations(input({0, 0.9, 0, 0.9, 0, 0.9}), kTolerance)), "><><><");
  EXPECT_EQ(to_string(fresh_relations(input({0, 1.1, 0, 0.9, 0, 0.9}), kTolerance)), "<>><><");
}

TEST(RawRelation, GivesPriorityToTheLegInTheAir) {
  GaitLatch latch;
  EXPECT_EQ(raw(latch, input(kStaircase, legs({0, 3}))), "><><<<");
}

// A tie left, then re-entered, then contradicted: each turn needs the tolerance on the far side.
TEST(RawRelation, TurnsRoundOnlyWhenContradictedByMoreThanTheTolerance) {
  GaitLatch latch;
  const auto first_relation = [&](double lag_of_leg_1) {
    return raw(latch, input({0, lag_of_leg_1, 50, 40, 30, 20}))[0];
  };
  EXPECT_EQ(first_relation(0.0), '>') << "a tie: leg 0 is of the first tripod";
  EXPECT_EQ(first_relation(0.9), '>');
  EXPECT_EQ(first_relation(1.1), '<') << "the tie is left";
  EXPECT_EQ(first_relation(0.0), '<') << "equal lags are no reason to turn back";
  EXPECT_EQ(first_relation(-0.9), '<');
  EXPECT_EQ(first_relation(-1.1), '>') << "the order is reversed";
}

// Leg 1 was ahead of leg 0 by order when it lifted. It lands in a tie with 0: nothing to hold on
// to.
TEST(RawRelation, IsDecidedAfreshAfterLanding) {
  GaitLatch latch;
  EXPECT_EQ(raw(latch, input({0, 9, 50, 40, 30, 20}))[0], '<');
  EXPECT_EQ(raw(latch, input({0, 9, 50, 40, 30, 20}, legs({1})))[0], '<');
  EXPECT_EQ(raw(latch, input({0, 0.5, 50, 40, 30, 20}))[0], '>') << "a tie, not an old order";

  GaitLatch stays_down;
  EXPECT_EQ(raw(stays_down, input({0, 9, 50, 40, 30, 20}))[0], '<');
  EXPECT_EQ(raw(stays_down, input({0, 0.5, 50, 40, 30, 20}))[0], '<') << "hysteresis";
}

TEST(RawRelation, IsKeptWhileBothLegsAreInTheAir) {
  GaitLatch latch;
  EXPECT_EQ(raw(latch, input({0, 9, 50, 40, 30, 20}))[0], '<');
  EXPECT_EQ(raw(latch, input({90, 9, 50, 40, 30, 20}, legs({0, 1})))[0], '<');
  EXPECT_EQ(raw(latch, input({90, 9, 50, 40, 30, 20}, legs({0})))[0], '>') << "one has landed";
  EXPECT_EQ(raw(latch, input({0, 9, 50, 40, 30, 20}, legs({0, 1})))[0], '>');
}

// <<<<<> has CCN 5; the adjustment turns the relations of positions 0-1 and 1-2.
TEST(Latch, KeepsAnAdjustedRelationWhileNothingHappensToItsLegs) {
  GaitLatch latch;
  const GaitDecision first = latch.update(input(kStaircase), kParams);
  EXPECT_EQ(to_string(first.raw), "<<<<<>");
  EXPECT_EQ(to_string(first.state), ">><<<>");
  EXPECT_EQ(first.ccn_before_adjustment, 5);
  EXPECT_EQ(first.may_step, legs({2}));

  const GaitDecision second = latch.update(input({15, 25, 35, 45, 55, 65}), kParams);
  EXPECT_EQ(second.state, first.state);
  EXPECT_EQ(second.ccn_before_adjustment, 3) << "nothing is left to adjust";
  EXPECT_EQ(to_string(second.raw), "<<<<<>");

  // Leg 2 (position 5) steps: only its own two relations follow.
  EXPECT_EQ(state(latch, input(kStaircase, legs({2}))), ">><<<>");
  EXPECT_EQ(state(latch, input({10, 20, 30, 40, 50, 0})), ">><<><");
}

TEST(Latch, ForgetsAnAdjustedRelationWhenALegOfItIsReordered) {
  GaitLatch latch;
  EXPECT_EQ(state(latch, input(kStaircase)), ">><<<>");
  // A slip reverses positions 0 and 1 and later puts them back. Their relation is raw again, the
  // one beside it is still the adjusted one, and another must give way: `> < <` at edges 1 2 3.
  EXPECT_EQ(raw(latch, input({10, 5, 30, 40, 50, 60})), "><<<<>");
  const GaitDecision back = latch.update(input(kStaircase), kParams);
  EXPECT_EQ(back.ccn_before_adjustment, 4);
  EXPECT_EQ(to_string(back.state), "<>><<>");
}

TEST(Latch, GivesAnUrgentLegItsRawRelationsAtOnce) {
  GaitLatch latch;
  EXPECT_EQ(state(latch, input(kStaircase)), ">><<<>");
  // Leg 3 (position 2) has its relation with leg 1 adjusted away; urgency brings it back, and
  // another relation must give way.
  const GaitDecision urgent = latch.update(input(kStaircase, kNone, legs({3})), kParams);
  EXPECT_EQ(urgent.ccn_before_adjustment, 4);
  EXPECT_EQ(urgent.state.ccn(), 3);
  EXPECT_EQ(urgent.may_step, legs({2})) << "it still waits for legs that lag even more";
}

TEST(Modes, WithoutTheLatchEveryUpdateAdjustsAnew) {
  GaitLatch literal, none;
  for (int i = 0; i < 3; ++i) {
    const GaitDecision decision = literal.update(
        input(kStaircase), {.tie_tolerance = kTolerance, .adjustment = Adjustment::literal});
    EXPECT_EQ(decision.ccn_before_adjustment, 5) << "yesterday's adjustment is forgotten";
    EXPECT_EQ(to_string(decision.state), ">><<<>");
    EXPECT_EQ(state(none, input(kStaircase), Adjustment::none), "<<<<<>");
  }
}

TEST(Latch, IsAValue) {
  static_assert(std::is_trivially_copyable_v<GaitLatch> && sizeof(GaitLatch) <= 28);
  static_assert(std::is_trivially_copyable_v<GaitDecision>);
  GaitLatch latch;
  (void)latch.update(input(kStaircase, legs({2})), kParams);
  GaitLatch copy = latch;
  const GaitInput next = input({30, 10, 20, 60, 50, 40}, legs({3}));
  EXPECT_EQ(copy.update(next, kParams).state, latch.update(next, kParams).state);
}

TEST(Latch, StartsAfreshForAnotherNumberOfLegs) {
  GaitLatch latch;
  (void)latch.update(input(kStaircase), kParams);
  EXPECT_EQ(state(latch, input({10, 20, 30, 40, 50, 60, 70, 80})), ">>><<<<>");
  EXPECT_EQ(state(latch, input({0, 0, 0, 0})), "><><");
}

}  // namespace
}  // namespace hexagait::gait_state::latch_test

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <hexagait/gait_state/latch.hpp>
#include <vector>

// No sequence of inputs makes the gait state cyclic, so with all feet down somebody may step.
namespace hexagait::gait_state::latch_cycle_test {
namespace {

constexpr double kTolerance = 1e-3;
constexpr GaitParams kParams{.tie_tolerance = kTolerance};
constexpr RingBits kStates = 64;

bool is_cyclic(RingBits bits) { return bits == 0 || bits == kStates - 1; }

// Lags on, just above and between multiples of the tolerance, for every leg, with every set of legs
// in the air. "Within the tolerance" is not transitive, so ties are where cycles would come from.
TEST(FreshRelations, AreNeverCyclic) {
  const std::array lags = {0.0, 0.9e-3, kTolerance, std::nextafter(kTolerance, 1.0), 1.9e-3};
  for (int code = 0; code < 5 * 5 * 5 * 5 * 5 * 5; ++code) {
    GaitInput input{LegArray<double>(6), {}, {}};
    int rest = code;
    for (double& lag : input.lag) {
      lag = lags[static_cast<std::size_t>(rest % 5)];
      rest /= 5;
    }
    for (std::uint32_t air = 0; air < kStates; ++air) {
      input.airborne = LegSet(air);
      ASSERT_FALSE(fresh_relations(input, kTolerance).is_cyclic());
    }
  }
}

// Every triple of 62 stored, 64 old raw and 64 new raw states, cyclic raw ones included (hysteresis
// isn't transitive), with every set of urgent legs. The oracle goes edge by edge.
TEST(Combine, NeverGivesACyclicStateAndElseFollowsTheLatchRule) {
  std::array<bool, kStates> somebody_steps{};
  for (RingBits bits = 1; bits + 1 < kStates; ++bits) {
    const GaitState balanced = adjusted({bits, 6}, 3);
    somebody_steps[bits] = balanced.ccn() == 3 && !may_step(balanced, LegSet()).empty();
  }
  const GaitState fresh{0b010101, 6};
  for (RingBits stored = 1; stored + 1 < kStates; ++stored) {
    for (RingBits before = 0; before < kStates; ++before) {
      for (RingBits now = 0; now < kStates; ++now) {
        const Combined result = combine({{stored, 6}, {before, 6}, {now, 6}, fresh, LegSet()});
        RingBits expected = 0;
        for (int k = 0; k < 6; ++k) {
          const RingBits bit = 1U << k;
          expected |= (before & bit) != (now & bit) ? now & bit : stored & bit;
        }
        ASSERT_EQ(result.was_cyclic, is_cyclic(expected));
        ASSERT_EQ(result.state.bits, is_cyclic(expected) ? fresh.bits : expected);
        for (std::uint32_t urgent = 0; urgent < kStates; ++urgent) {
          const Combined any = combine({{stored, 6}, {before, 6}, {now, 6}, fresh, LegSet(urgent)});
          ASSERT_TRUE(somebody_steps[any.state.bits]);
        }
      }
    }
  }
}

TEST(Combine, MakesBothRelationsOfAnUrgentLegRaw) {
  for (LegId leg = 0; leg < 6; ++leg) {
    const GaitState stored{0b010101, 6}, raw{0b101010, 6};
    const RingBits turned =
        combine({stored, raw, raw, raw, LegSet(1U << leg)}).state.bits ^ stored.bits;
    const int k = position_of(leg, 6);
    EXPECT_EQ(turned, (1U << k) | (1U << (k + 5) % 6));
  }
}

TEST(Combine, StartsFromFreshRelationsWhenOldAndNewOnesCloseTheCircle) {
  // The old relations `< < < > > <` of which the last four have turned round.
  const GaitState fresh{0b000111, 6};
  const Combined result = combine({*parse_gait_state("<<<>>>"), *parse_gait_state("<<>>>>"),
                                   *parse_gait_state("<<><<<"), fresh, LegSet()});
  EXPECT_TRUE(result.was_cyclic);
  EXPECT_EQ(result.state, fresh);
}

// All 720 x 720 pairs of orders of the lags: what a change of heading with all feet down can do.
// Then the robot stands there for a while.
TEST(HeadingChange, WithAllFeetDownAlwaysLeavesSomebodyWhoMayStep) {
  std::array<int, 6> order = {0, 1, 2, 3, 4, 5};
  std::vector<GaitInput> inputs;
  do {
    GaitInput input{LegArray<double>(6), {}, {}};
    for (LegId leg = 0; leg < 6; ++leg)
      input.lag[leg] = 0.01 * order[static_cast<std::size_t>(leg)];
    inputs.push_back(input);
  } while (std::next_permutation(order.begin(), order.end()));

  int cyclic = 0;
  for (const GaitInput& old_heading : inputs) {
    GaitLatch start;
    (void)start.update(old_heading, kParams);
    for (const GaitInput& new_heading : inputs) {
      GaitLatch latch = start;
      const GaitDecision decision = latch.update(new_heading, kParams);
      ASSERT_FALSE(decision.may_step.empty());
      ASSERT_EQ(decision.state.ccn(), 3);
      ASSERT_EQ(latch.update(new_heading, kParams).state, decision.state);
      cyclic += decision.was_cyclic ? 1 : 0;
    }
  }
  EXPECT_GT(cyclic, 0) << "the case is real";
}

// Under urgency the two rules pull at the same relations: raw, adjusted, raw, … It must not swing.
// From every stored state, for every raw state and every set of urgent legs.
TEST(Urgency, SettlesAfterTwoUpdates) {
  for (RingBits raw = 1; raw + 1 < kStates; ++raw) {
    for (RingBits stored = 1; stored + 1 < kStates; ++stored) {
      for (std::uint32_t urgent = 0; urgent < kStates; ++urgent) {
        std::array<GaitState, 4> state{GaitState{stored, 6}};
        for (std::size_t i = 1; i < state.size(); ++i) {
          const GaitState same{raw, 6};
          state[i] = adjusted(combine({state[i - 1], same, same, same, LegSet(urgent)}).state, 3);
        }
        ASSERT_EQ(state[3], state[2]) << "stored " << stored << ", raw " << raw << ", " << urgent;
      }
    }
  }
}

}  // namespace
}  // namespace hexagait::gait_state::latch_cycle_test

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <hexagait/gait_state/gait_state.hpp>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

// The oracles here work on strings of `<` and `>`, read round the ring; the library works on bits.
namespace hexagait::gait_state {
namespace {

constexpr int kRings[] = {4, 6, 8, 10, 12};

GaitState state_of(const std::string& text) { return parse_gait_state(text).value(); }

std::vector<GaitState> non_cyclic_states(int n) {
  std::vector<GaitState> states;
  for (RingBits bits = 1; bits + 1 < (1U << n); ++bits) states.push_back({bits, n});
  return states;
}

char relation(const std::string& state, int k) {
  const int n = static_cast<int>(state.size());
  return state[static_cast<std::size_t>((k + n) % n)];
}

// Positions of legs inside `< a >`: the relation on their left and on their right.
std::vector<int> inside_pairs(const std::string& state) {
  std::vector<int> positions;
  for (int k = 0; k < static_cast<int>(state.size()); ++k) {
    if (relation(state, k - 1) == '<' && relation(state, k) == '>') positions.push_back(k);
  }
  return positions;
}

std::string smallest_rotation(std::string state) {
  std::string smallest = state;
  for (std::size_t i = 0; i < state.size(); ++i) {
    std::rotate(state.begin(), state.begin() + 1, state.end());
    smallest = std::min(smallest, state);
  }
  return smallest;
}

int ccn_of(const std::string& state) {
  return static_cast<int>(std::count(state.begin(), state.end(), '<'));
}

// All results of replacing one occurrence of the pattern, wherever it stands on the ring.
std::vector<std::string> rewritten(std::string state, const std::string& from,
                                   const std::string& to) {
  std::vector<std::string> results;
  for (std::size_t i = 0; i < state.size(); ++i) {
    if (state.compare(0, from.size(), from) == 0) {
      std::string result = to + state.substr(from.size());
      std::rotate(result.rbegin(), result.rbegin() + static_cast<std::ptrdiff_t>(i), result.rend());
      results.push_back(result);
    }
    std::rotate(state.begin(), state.begin() + 1, state.end());
  }
  return results;
}

// Every state that the paper's rules can lead to, whatever the choices.
std::set<std::string> reachable_by_rewriting(const std::string& start, int ccn) {
  std::set<std::string> frontier{start};
  while (ccn_of(*frontier.begin()) != ccn) {
    std::set<std::string> next;
    for (const std::string& state : frontier) {
      const bool low = ccn_of(state) < ccn;
      for (const auto& s : low ? rewritten(state, ">><", "><<") : rewritten(state, "><<", ">><")) {
        next.insert(s);
      }
    }
    frontier = std::move(next);
  }
  return frontier;
}

// [PC04] Table 1. Necklaces of 6 beads in 2 colours, without the two of one colour: 12 classes.
TEST(Types, CountAsInTable1WithOneClassPerCell) {
  using Cell = std::pair<int, GaitType>;
  std::map<Cell, int> count;
  std::map<Cell, std::set<std::string>> classes;
  for (const GaitState& state : non_cyclic_states(6)) {
    const Cell cell{state.ccn(), type_of(state)};
    ++count[cell];
    classes[cell].insert(smallest_rotation(to_string(state)));
  }
  const std::map<Cell, int> expected = {
      {{1, GaitType::A}, 6}, {{2, GaitType::A}, 6}, {{2, GaitType::B}, 6}, {{2, GaitType::C}, 3},
      {{3, GaitType::A}, 6}, {{3, GaitType::B}, 6}, {{3, GaitType::C}, 6}, {{3, GaitType::D}, 2},
      {{4, GaitType::A}, 6}, {{4, GaitType::B}, 6}, {{4, GaitType::C}, 3}, {{5, GaitType::A}, 6}};
  EXPECT_EQ(count, expected);
  for (const auto& [cell, members] : classes) EXPECT_EQ(members.size(), 1U);
}

// Representatives that can be checked by eye; {2, 5} in Fig. 2's numbers are opposite on the ring.
TEST(Types, AreThoseOfThePapersExamples) {
  EXPECT_EQ(type_of(state_of("<<<>>>")), GaitType::A);
  EXPECT_EQ(type_of(state_of("<><>>>")), GaitType::B);
  EXPECT_EQ(type_of(state_of("<>><>>")), GaitType::C);
  EXPECT_EQ(type_of(state_of("<><><>")), GaitType::D);
  EXPECT_EQ(type_of(state_of("<<<<<<")), GaitType::none);
  EXPECT_EQ(type_of(state_of("<><>")), GaitType::none) << "types are defined for six legs";
}

// "< > < > < > is 1 < 2 > 4 < 6 > 5 < 3 > 1": 2, 6 and 3 of the paper stand inside `< >`.
TEST(PriorityLegs, OfThePapersFirstExampleAre2And6And3) {
  EXPECT_EQ(priority_legs(state_of("<><><>")), LegSet((1U << 1) | (1U << 5) | (1U << 2)));
  EXPECT_EQ(priority_legs(state_of(">>>>><")), LegSet(1U << 0)) << "begins with > and ends with <";
}

TEST(PriorityLegs, AreThoseInsidePairsNeverNeighboursAndNoneOnlyIfCyclic) {
  for (const int n : kRings) {
    for (RingBits bits = 0; bits < (1U << n); ++bits) {
      const GaitState state{bits, n};
      LegSet expected;
      for (const int k : inside_pairs(to_string(state))) expected.insert(leg_at(k, n));
      ASSERT_EQ(priority_legs(state), expected);
      ASSERT_FALSE(breaks_rule_1(expected, n));
      ASSERT_EQ(expected.empty(), state.is_cyclic());
    }
  }
}

// For every state and every set of legs in the air, also sets that break rule 1 themselves: a leg
// that starts has both neighbours on the ground and not starting.
TEST(MayStep, NeverBreaksRule1) {
  for (const int n : {4, 6, 8, 10}) {
    for (RingBits bits = 0; bits < (1U << n); ++bits) {
      for (std::uint32_t air = 0; air < (1U << n); ++air) {
        const LegSet starting = may_step(GaitState{bits, n}, LegSet(air));
        ASSERT_TRUE((neighbours_of(starting, n) & (LegSet(air) | starting)).empty());
        ASSERT_TRUE((starting & LegSet(air)).empty());
      }
    }
  }
}

TEST(MayStep, HoldsBackNoPriorityLegWithoutReason) {
  for (RingBits bits = 0; bits < 64; ++bits) {
    for (std::uint32_t air = 0; air < 64; ++air) {
      const LegSet starting = may_step(GaitState{bits, 6}, LegSet(air));
      for (LegId leg = 0; leg < 6; ++leg) {
        const LegSet near = neighbours_of(LegSet(1U << leg), 6) | LegSet(1U << leg);
        const bool expected =
            priority_legs(GaitState{bits, 6}).contains(leg) && (near & LegSet(air)).empty();
        ASSERT_EQ(starting.contains(leg), expected);
      }
    }
  }
}

TEST(Adjustment, EndsAtHalfFromEveryStateByThePapersRulesAlone) {
  for (const int n : kRings) {
    for (const GaitState& state : non_cyclic_states(n)) {
      const GaitState result = adjusted(state, n / 2);
      ASSERT_EQ(result.ccn(), n / 2);
      const std::string text = to_string(state);
      ASSERT_TRUE(reachable_by_rewriting(text, n / 2).contains(to_string(result))) << text;
    }
  }
}

TEST(Adjustment, KeepsEveryPriorityLegAndAddsNone) {
  for (const int n : kRings) {
    for (const GaitState& state : non_cyclic_states(n)) {
      const GaitState result = adjusted(state, n / 2);
      ASSERT_EQ(inside_pairs(to_string(result)), inside_pairs(to_string(state)));
      ASSERT_EQ(type_of(result), type_of(state));
    }
  }
}

// p pairs `< >` need p of each relation, so p <= CCN <= n - p; all of that range can be reached.
TEST(Adjustment, ReachesEveryCcnThatThePriorityLegsAllow) {
  for (const GaitState& state : non_cyclic_states(8)) {
    const int p = priority_legs(state).size();
    for (int ccn = p; ccn <= 8 - p; ++ccn) ASSERT_EQ(adjusted(state, ccn).ccn(), ccn);
  }
}

TEST(Adjustment, LeavesABalancedStateAlone) {
  for (const int n : kRings) {
    for (const GaitState& state : non_cyclic_states(n)) {
      if (state.ccn() != n / 2) continue;
      ASSERT_EQ(adjusted(state, n / 2), state);
    }
  }
}

// Type C is the only choice that six legs have. `< > > < > >`: the legs at positions 0 and 3 wait
// for both neighbours, 0 is of the first tripod and passes the one before it (edge 5). `> > < > >
// <`: positions 2 and 5, 2 passes 1. `< < > < < >`: positions 0 and 3 again, 0 passes the one after
// it (edge 0).
TEST(Adjustment, LetsALegOfTheFirstTripodGainIfThereIsAChoice) {
  EXPECT_EQ(to_string(adjusted(state_of("<>><>>"), 3)), "<>><><");
  EXPECT_EQ(to_string(adjusted(state_of(">><>><"), 3)), "><<>><");
  EXPECT_EQ(to_string(adjusted(state_of("<<><<>"), 3)), "><><<>");
}

TEST(Adjustment, OfThePapersTable1GoesDownItsColumns) {
  EXPECT_EQ(to_string(adjusted(state_of("<>>>>>"), 3)), "<>>><<");
  EXPECT_EQ(to_string(adjusted(state_of("<<<<<>"), 3)), ">><<<>");
}

// Eq. 2 of [PC04] as string rewriting: the two relations beside the leg change places.
TEST(Step, ReversesTheTwoRelationsOfTheLegAndKeepsTheCcn) {
  for (const int n : kRings) {
    for (const GaitState& state : non_cyclic_states(n)) {
      for (const int k : inside_pairs(to_string(state))) {
        std::string expected = to_string(state);
        std::swap(expected[static_cast<std::size_t>((k + n - 1) % n)],
                  expected[static_cast<std::size_t>(k)]);
        const GaitState result = after_step(state, leg_at(k, n));
        ASSERT_EQ(to_string(result), expected);
        ASSERT_EQ(result.ccn(), state.ccn());
      }
    }
  }
}

TEST(Text, IsReadAndWrittenAlike) {
  for (const int n : kRings) {
    for (RingBits bits = 0; bits < (1U << n); ++bits) {
      const GaitState state{bits, n};
      ASSERT_EQ(parse_gait_state(to_string(state)), state);
    }
  }
  EXPECT_EQ(to_string(GaitState{0b000001, 6}), "<>>>>>") << "bit 0 is the first relation";
}

TEST(Text, RefusesWhatIsNoGaitState) {
  for (const char* text : {"", "<>", "<><", "<><>>", "<><><>x>", "< > < >", "<><><><><><><>"}) {
    EXPECT_FALSE(parse_gait_state(text).has_value()) << text;
  }
}

}  // namespace
}  // namespace hexagait::gait_state

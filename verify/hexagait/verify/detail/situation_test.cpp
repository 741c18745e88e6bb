// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/verify/detail/settle.hpp>
#include <hexagait/verify/detail/situations.hpp>
#include <hexagait/verify/detail/wave_slices.hpp>
#include <map>
#include <set>

namespace hexagait::verify {
namespace {

using namespace gait_state;

GaitState state_of(const char* text) { return parse_gait_state(text).value(); }

// 6 states with one priority leg, 12 with two, 2 with three. All: 4 air times on each of 6 legs.
// Reachable: on priority legs only, 6 * 4 + 12 * 16 + 2 * 64.
TEST(Situations, CountAsTheConventionSays) {
  const auto count = [](int step_time, Scene scene) {
    int starts = 0;
    const Situations situations(balanced_states(6), step_time, scene);
    situations.for_each_start([&](const Situation&) { ++starts; });
    return starts;
  };
  EXPECT_EQ(count(3, Scene::all), 20 * 4 * 4 * 4 * 4 * 4 * 4);
  EXPECT_EQ(count(3, Scene::reachable), 344);
  EXPECT_EQ(count(1, Scene::reachable), 6 * 2 + 12 * 4 + 2 * 8);
}

TEST(Situations, HaveKeysOfTheirOwn) {
  for (const Scene scene : {Scene::all, Scene::reachable}) {
    const Situations situations(balanced_states(6), 2, scene);
    std::set<std::size_t> keys;
    std::size_t starts = 0;
    situations.for_each_start([&](const Situation& start) {
      const std::size_t key = situations.key(start);
      ASSERT_LT(key, situations.size());
      keys.insert(key);
      ++starts;
    });
    EXPECT_EQ(keys.size(), starts);
  }
}

// < < < > > >: leg 5, at position 3, is the only one inside < a >. Legs 3 and 4 wait for it.
TEST(Slices, LandInFrontFromAStepAndInPlaceAfterASlip) {
  const Rules rules;
  const Slices slices(rules, 6, 3, Adjustment::latched);
  Situation start{.state = state_of("<<<>>>"), .air = {}, .slipped = {}};
  start.air[5] = 1;
  EXPECT_EQ(slices.advance(start).next.state, state_of("<<><>>")) << "< 5 > becomes > 5 <";
  EXPECT_EQ(slices.advance(start).lifted, LegSet((1U << 3) | (1U << 4)));
  start.slipped = LegSet(1U << 5);
  EXPECT_EQ(slices.advance(start).next.state, start.state);
  EXPECT_EQ(slices.advance(start).lifted, LegSet(1U << 5)) << "down again, it may make its step";
}

// 3 -> 4 -> 5 -> 3 and 0 -> 1 -> 2 -> 5: the cycle is 3 4 5, and 0 is three successors away.
TEST(Settle, CountsSuccessorsUntilTheCycle) {
  const std::map<int, int> successor = {{0, 1}, {1, 2}, {2, 5}, {3, 4}, {4, 5}, {5, 3}};
  std::map<int, std::int16_t> memo;
  std::vector<int> cycle;
  const auto walk = [&](int start) {
    return settle(
        start, memo, [](int s) { return s; }, [&](int s) { return successor.at(s); },
        [&](std::span<const int> found) { cycle.insert(cycle.end(), found.begin(), found.end()); });
  };
  EXPECT_EQ(walk(0), 3);
  EXPECT_EQ(cycle, (std::vector<int>{5, 3, 4}));
  EXPECT_EQ(walk(1), 2);
  EXPECT_EQ(walk(4), 0);
  EXPECT_EQ(cycle.size(), 3U) << "one cycle, reported once";
}

// The slow wave gait of [PC04] Fig. 3, T = 1, period 6: legs 6 4 2 5 3 1 of the paper one by one.
TEST(Wave, IsThatOfFigure3AndNoOther) {
  const std::vector<LegSet> slow = {LegSet(1U << 5), LegSet(1U << 3), LegSet(1U << 1),
                                    LegSet(1U << 4), LegSet(1U << 2), LegSet(1U << 0)};
  EXPECT_TRUE(is_wave(slow, 6, 1, hindmost_edge(6)));
  EXPECT_FALSE(is_wave(slow, 6, 1, 0)) << "seen from the front it goes backwards";
  std::vector<LegSet> exchanged = slow;
  std::swap(exchanged[1], exchanged[4]);
  EXPECT_FALSE(is_wave(exchanged, 6, 1, hindmost_edge(6)));
  EXPECT_FALSE(is_wave(std::vector<LegSet>(6), 6, 1, hindmost_edge(6))) << "nobody walks";
}

}  // namespace
}  // namespace hexagait::verify

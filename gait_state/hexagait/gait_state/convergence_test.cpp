// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <hexagait/gait_state/latch.hpp>
#include <map>
#include <utility>
#include <vector>

// "The gait of the robot will soon converge to the tripod gait" ([PC04] 3.2), through the latch
// itself. Conditions: CCN = n/2, all steps last T slices, legs start as soon as they may. A slice
// is landings, a decision, lifts. A foot lands in front, with lag 0, and support legs fall back
// alike, so of two neighbours the one that landed last lags less: priorities change only when a
// step ends.
namespace hexagait::gait_state {
namespace {

constexpr double kAdvance = 0.005;  // lag that a support leg gains per slice [m]

using AirTimes = std::array<int, kMaxLegs>;

// Lags that have `state` as their raw relations: for each leg the longest row of waiting legs below
// it.
LegArray<double> lags_for(const GaitState& state) {
  LegArray<double> lag(state.n, 0.0);
  for (int round = 0; round < state.n; ++round) {
    for (int k = 0; k < state.n; ++k) {
      const bool less = ((state.bits >> k) & 1U) != 0;
      double& a = lag[leg_at(k, state.n)];
      double& b = lag[leg_at((k + 1) % state.n, state.n)];
      double& first = less ? b : a;
      first = std::max(first, (less ? a : b) + 0.01);
    }
  }
  return lag;
}

class SliceWorld {
 public:
  SliceWorld(const GaitState& start, const AirTimes& air, int step_time, Adjustment adjustment)
      : n_(start.n), step_time_(step_time), air_(air), lag_(lags_for(start)) {
    params_.adjustment = adjustment;
    decision = latch_.update({lag_, airborne(), {}}, params_);
  }

  // One slice. Also steps an abstract gait state that knows only `< a >` -> `> a <`.
  void advance() {
    for (LegId leg = 0; leg < n_; ++leg) {
      auto& left = air_[static_cast<std::size_t>(leg)];
      lag_[leg] = left == 1 ? 0.0 : lag_[leg] + kAdvance;
      if (left == 1) landed_.push_back(leg);
      if (left > 0) --left;
    }
    decision = latch_.update({lag_, airborne(), {}}, params_);
    lifted = decision.may_step;
    for (LegId leg = 0; leg < n_; ++leg) {
      if (lifted.contains(leg)) air_[static_cast<std::size_t>(leg)] = step_time_;
    }
    // The control loop is faster than the slices: it also sees the lifts.
    EXPECT_TRUE(latch_.update({lag_, airborne(), {}}, params_).may_step.empty());
  }

  LegSet airborne() const {
    LegSet set;
    for (std::size_t leg = 0; leg < air_.size(); ++leg)
      set.set(static_cast<LegId>(leg), air_[leg] > 0);
    return set;
  }

  std::vector<LegId> take_landed() { return std::exchange(landed_, {}); }
  std::pair<RingBits, AirTimes> situation() const { return {decision.state.bits, air_}; }

  GaitDecision decision;
  LegSet lifted;

 private:
  int n_;
  int step_time_;
  AirTimes air_;
  LegArray<double> lag_;
  std::vector<LegId> landed_;
  GaitParams params_;
  GaitLatch latch_;
};

struct Convergence {
  int transient = 0;           // slices before the first situation of the final cycle
  bool ends_in_tripod = true;  // in that cycle, whole tripods lift, and in turn
};

// Counts from the first slice's lifts: what happens before them is the start, not the gait.
Convergence run(SliceWorld world, int n) {
  world.advance();
  std::map<std::pair<RingBits, AirTimes>, int> seen;
  int slice = 0;
  while (seen.emplace(world.situation(), slice).second) {
    world.advance();
    ++slice;
  }
  Convergence result{.transient = seen[world.situation()]};
  LegSet lifted;
  for (int i = result.transient; i < slice; ++i) {
    world.advance();
    lifted = lifted | world.lifted;
    const bool whole =
        world.lifted.empty() || world.lifted == first_tripod(n) || world.lifted == second_tripod(n);
    result.ends_in_tripod = result.ends_in_tripod && whole;
  }
  result.ends_in_tripod = result.ends_in_tripod && lifted == LegSet::all(n);
  return result;
}

// All combinations of remaining air times 0 … T of the priority legs: what a controller can get
// into.
std::vector<AirTimes> reachable_air_times(const GaitState& state, int step_time) {
  std::vector<AirTimes> all{AirTimes{}};
  for (LegId leg = 0; leg < state.n; ++leg) {
    if (!priority_legs(state).contains(leg)) continue;
    const std::vector<AirTimes> before = all;
    for (const AirTimes& air : before) {
      for (int left = 1; left <= step_time; ++left) {
        all.push_back(air);
        all.back()[static_cast<std::size_t>(leg)] = left;
      }
    }
  }
  return all;
}

std::vector<GaitState> non_cyclic_states(int n) {
  std::vector<GaitState> states;
  for (RingBits bits = 1; bits + 1 < (1U << n); ++bits) states.push_back({bits, n});
  return states;
}

// For T = 3: 6 states with one priority leg, 12 with two, 2 with three, each leg with 4 air times:
// 6 * 4 + 12 * 16 + 2 * 64 = 344 situations. The slowest need two step times, found by enumeration.
TEST(Convergence, ToTheTripodGaitFromEveryReachableSituationWithCcn3) {
  for (const int step_time : {1, 2, 3, 4}) {
    int situations = 0, worst = 0;
    for (const GaitState& state : non_cyclic_states(6)) {
      if (state.ccn() != 3) continue;
      for (const AirTimes& air : reachable_air_times(state, step_time)) {
        const SliceWorld world(state, air, step_time, Adjustment::latched);
        ASSERT_EQ(world.decision.state, state) << "the lags must produce the situation";
        const Convergence result = run(world, 6);
        ASSERT_TRUE(result.ends_in_tripod) << to_string(state);
        worst = std::max(worst, result.transient);
        ++situations;
      }
    }
    EXPECT_EQ(worst, 2 * step_time);
    EXPECT_TRUE(step_time != 3 || situations == 344);
  }
}

// [PC04]'s step rule alone, without lags, tolerance or latch, predicts every state of every slice.
TEST(Convergence, TakesThePathOfTheStepRuleAlone) {
  for (const GaitState& state : non_cyclic_states(6)) {
    for (const AirTimes& air : reachable_air_times(state, 2)) {
      SliceWorld world(state, air, 2, Adjustment::none);
      GaitState predicted = state;
      for (int slice = 0; slice < 30; ++slice) {
        world.advance();
        for (const LegId leg : world.take_landed()) predicted = after_step(predicted, leg);
        ASSERT_EQ(world.decision.state, predicted);
      }
    }
  }
}

TEST(Convergence, NeedsTheAdjustmentWhenTheCcnIsNot3) {
  for (const GaitState& state : non_cyclic_states(6)) {
    if (state.ccn() == 3) continue;
    EXPECT_TRUE(run({state, {}, 3, Adjustment::latched}, 6).ends_in_tripod);
    for (const Adjustment inert : {Adjustment::none, Adjustment::literal}) {
      EXPECT_FALSE(run({state, {}, 3, inert}, 6).ends_in_tripod) << to_string(state);
    }
  }
}

// From every state, with the bound found by enumeration: less than n/2 step times.
TEST(Convergence, HoldsForOtherRings) {
  for (const int n : {4, 8, 10, 12}) {
    for (const GaitState& state : non_cyclic_states(n)) {
      const Convergence result = run({state, {}, 3, Adjustment::latched}, n);
      ASSERT_TRUE(result.ends_in_tripod) << to_string(state);
      ASSERT_LT(result.transient, n / 2 * 3);
    }
  }
}

}  // namespace
}  // namespace hexagait::gait_state

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <hexagait/gait_state/latch.hpp>
#include <hexagait/sim/random.hpp>
#include <string>
#include <vector>

// What a gait state must not depend on: how legs are numbered, units, where lags are counted from.
namespace hexagait::gait_state {
namespace {

constexpr GaitParams kParams{.tie_tolerance = 0.125};

// A relabelling that keeps neighbours and tripods: ring position k becomes sense * k + shift.
struct Relabelling {
  int sense = 1;
  int shift = 0;

  int position(int k, int n) const { return ((sense * k + shift) % n + n) % n; }
  LegId leg(LegId old, int n) const { return leg_at(position(position_of(old, n), n), n); }
};

std::vector<Relabelling> relabellings(int n) {
  std::vector<Relabelling> all;
  for (const int sense : {1, -1}) {
    for (int shift = 0; shift < n; shift += 2) all.push_back({sense, shift});
  }
  return all;
}

LegSet mapped(LegSet legs, const Relabelling& map, int n) {
  LegSet result;
  for (LegId leg = 0; leg < n; ++leg) {
    if (legs.contains(leg)) result.insert(map.leg(leg, n));
  }
  return result;
}

GaitInput mapped(const GaitInput& input, const Relabelling& map) {
  const int n = input.lag.size();
  GaitInput result{LegArray<double>(n), mapped(input.airborne, map, n),
                   mapped(input.urgent, map, n)};
  for (LegId leg = 0; leg < n; ++leg) result.lag[map.leg(leg, n)] = input.lag[leg];
  return result;
}

// Edge k joins k and k + 1; seen in a mirror it is the edge before the image of k, and `<` is `>`.
GaitState mapped(const GaitState& state, const Relabelling& map) {
  GaitState result{0, state.n};
  for (int k = 0; k < state.n; ++k) {
    const bool less = ((state.bits >> k) & 1U) != 0;
    const int image = map.position(map.sense > 0 ? k : k + 1, state.n);
    if (less == (map.sense > 0)) result.bits |= 1U << image;
  }
  return result;
}

// Lags in steps of 1/16, half the tolerance, so ties of all sorts occur; anything may be in the
// air.
GaitInput random_input(int n, RandomSequence& random) {
  GaitInput input{LegArray<double>(n), {}, {}};
  for (LegId leg = 0; leg < n; ++leg) {
    input.lag[leg] = std::floor(random.uniform(0.0, 16.0)) / 16.0;
    input.airborne.set(leg, random.u01() < 0.2);
    input.urgent.set(leg, random.u01() < 0.1);
  }
  return input;
}

void expect_equivariant(int n, const GaitParams& params, std::uint32_t trial) {
  for (const Relabelling& map : relabellings(n)) {
    RandomSequence random{.seed = 11, .trial = trial};
    GaitLatch latch, mapped_latch;
    for (int i = 0; i < 100; ++i) {
      const GaitInput input = random_input(n, random);
      const GaitDecision a = latch.update(input, params);
      const GaitDecision b = mapped_latch.update(mapped(input, map), params);
      ASSERT_EQ(b.raw, mapped(a.raw, map));
      ASSERT_EQ(b.state, mapped(a.state, map));
      ASSERT_EQ(b.may_step, mapped(a.may_step, map, n));
    }
  }
}

// The choices that break ties (lags, adjustment) look at tripods only, so for six legs the symmetry
// is exact, ties included.
TEST(Symmetry, SixLegsDecideAlikeHoweverTheRingIsTurnedOrMirrored) {
  for (std::uint32_t trial = 0; trial < 50; ++trial) {
    expect_equivariant(6, kParams, trial);
    expect_equivariant(6, {.tie_tolerance = 0.125, .adjustment = Adjustment::literal}, trial);
  }
}

// Four legs have no choice in the adjustment; with more than six the last resort is the position.
TEST(Symmetry, OtherRingsDoSoUpToTheChoiceOfTheAdjustedRelation) {
  for (std::uint32_t trial = 0; trial < 20; ++trial) {
    expect_equivariant(4, kParams, trial);
    for (const int n : {8, 10, 12}) {
      expect_equivariant(n, {.tie_tolerance = 0.125, .adjustment = Adjustment::none}, trial);
    }
  }
}

void expect_invariant(const std::function<double(double)>& map, const GaitParams& mapped_params) {
  RandomSequence random{.seed = 12};
  GaitLatch latch, mapped_latch;
  for (int i = 0; i < 2000; ++i) {
    GaitInput input = random_input(6, random);
    const GaitState state = latch.update(input, kParams).state;
    for (double& lag : input.lag) lag = map(lag);
    ASSERT_EQ(mapped_latch.update(input, mapped_params).state, state);
  }
}

// Powers of two and sixteenths: the floating-point arithmetic is exact.
TEST(Symmetry, UnitsOfLagDoNotMatter) {
  expect_invariant([](double lag) { return 1024.0 * lag; }, {.tie_tolerance = 128.0});
}

TEST(Symmetry, WhereLagIsCountedFromDoesNotMatter) {
  expect_invariant([](double lag) { return lag - 3.0; }, kParams);
}

}  // namespace
}  // namespace hexagait::gait_state

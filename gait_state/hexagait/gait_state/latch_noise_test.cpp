// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <hexagait/gait_state/latch.hpp>
#include <hexagait/sim/random.hpp>

// Sensor noise at the rate of the control loop must not re-decide relations: each decision wipes
// out the adjustment of that relation.
namespace hexagait::gait_state::latch_noise_test {
namespace {

constexpr GaitParams kParams{.tie_tolerance = 1e-3};
// |noise of a lag| < half the tolerance, so that of a difference of two stays below the tolerance.
constexpr double kNoise = 0.499 * kParams.tie_tolerance;
constexpr int kUpdates = 300;

GaitInput noisy(const LegArray<double>& lag, double drift, RandomSequence& random) {
  GaitInput input{lag, {}, {}};
  for (double& value : input.lag) value += drift + random.uniform(-kNoise, kNoise);
  return input;
}

// True lags are multiples of 2 tolerances: ties, and orders that noise below 1 tolerance can't
// reach. All legs support, so the body's advance shifts all lags alike.
TEST(Noise, BelowTheToleranceChangesNoDecisionWhileTheBodyAdvances) {
  for (std::uint32_t trial = 0; trial < 300; ++trial) {
    RandomSequence random{.seed = 1, .trial = trial};
    LegArray<double> lag(6);
    for (double& value : lag) value = 2e-3 * std::floor(random.uniform(0.0, 4.0));
    GaitLatch latch;
    const GaitDecision first = latch.update({lag, {}, {}}, kParams);
    for (int i = 0; i < kUpdates; ++i) {
      const GaitDecision now = latch.update(noisy(lag, 1e-4 * i, random), kParams);
      ASSERT_EQ(now.raw, first.raw);
      ASSERT_EQ(now.state, first.state);
      ASSERT_EQ(now.may_step, first.may_step);
    }
  }
}

// A turn needs a difference beyond +tolerance, a turn back one beyond -tolerance: they are 2
// tolerances apart, and the noise of a difference is less than that from end to end.
TEST(Noise, TurnsARelationAtMostOnceWhateverTheTrueLags) {
  int turned = 0;
  for (std::uint32_t trial = 0; trial < 300; ++trial) {
    RandomSequence random{.seed = 2, .trial = trial};
    LegArray<double> lag(6);
    for (double& value : lag) value = random.uniform(0.0, 4e-3);
    GaitLatch latch;
    RingBits raw = latch.update(noisy(lag, 0.0, random), kParams).raw.bits;
    RingBits already = 0;
    for (int i = 0; i < kUpdates; ++i) {
      const GaitDecision now = latch.update(noisy(lag, 0.0, random), kParams);
      if (now.was_cyclic) break;  // begins a new history
      ASSERT_EQ((now.raw.bits ^ raw) & already, 0U);
      already |= now.raw.bits ^ raw;
      raw = now.raw.bits;
    }
    turned += std::popcount(already);
  }
  EXPECT_GT(turned, 0) << "the test must meet relations that noise can turn";
}

// The same with noise of twice the tolerance: the bound above is not an accident of the test.
TEST(Noise, AboveTheToleranceTurnsTiesAgainAndAgain) {
  RandomSequence random{.seed = 3};
  const GaitParams sharp{.tie_tolerance = 0.25 * kNoise};
  const LegArray<double> lag(6, 0.0);
  GaitLatch latch;
  int turns = 0;
  RingBits raw = latch.update({lag, {}, {}}, sharp).raw.bits;
  for (int i = 0; i < kUpdates; ++i) {
    const RingBits now = latch.update(noisy(lag, 0.0, random), sharp).raw.bits;
    turns += std::popcount(now ^ raw);
    raw = now;
  }
  EXPECT_GT(turns, kUpdates);
}

}  // namespace
}  // namespace hexagait::gait_state::latch_noise_test

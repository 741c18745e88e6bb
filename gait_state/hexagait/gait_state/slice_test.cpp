// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <hexagait/core/random.hpp>
#include <hexagait/gait_state/latch.hpp>

// The slice model of [PC04] 5.1 on flat ground, in its units: a step puts the foot 25 ahead of its
// workspace centre and is 6 slices in the air; per slice the body goes on until the feet, those in
// the air included, are on average at their centres.
namespace hexagait::gait_state {
namespace {

constexpr int kStarts = 100;
constexpr int kSlices = 500;
constexpr double kUnit = 1e-3;  // [m of path]

struct SliceRobot {
  std::array<double, 6> foot{};  // ahead of its centre
  std::array<int, 6> air{};      // slices left
  GaitLatch latch;
  GaitParams params;
  double travelled = 0.0;

  GaitDecision advance() {
    GaitInput input{LegArray<double>(6), {}, {}};
    for (std::size_t i = 0; i < 6; ++i) {
      input.lag[static_cast<LegId>(i)] = -foot[i] * kUnit;
      input.airborne.set(static_cast<LegId>(i), air[i] > 0);
    }
    const GaitDecision decision = latch.update(input, params);
    start(decision.may_step);
    move_body();
    return decision;
  }

 private:
  void start(LegSet legs) {
    for (std::size_t i = 0; i < 6; ++i) {
      if (!legs.contains(static_cast<LegId>(i))) continue;
      foot[i] = 25.0;
      air[i] = 6;
    }
  }

  void move_body() {
    double sum = 0.0;
    int supporting = 0;
    for (std::size_t i = 0; i < 6; ++i) {
      sum += foot[i];
      supporting += air[i] == 0 ? 1 : 0;
    }
    const double advance = sum / supporting;
    for (std::size_t i = 0; i < 6; ++i) {
      if (air[i] == 0) foot[i] -= advance;
      if (air[i] > 0) --air[i];
    }
    travelled += advance;
  }
};

SliceRobot random_start(std::uint32_t trial, Adjustment adjustment) {
  RandomSequence random{.seed = 31, .stream = RandomStream::posture, .trial = trial};
  SliceRobot robot;
  for (double& foot : robot.foot) foot = random.uniform(-25.0, 25.0);
  robot.params = {.tie_tolerance = kUnit, .adjustment = adjustment};
  return robot;
}

double mean_speed(Adjustment adjustment) {
  double travelled = 0.0;
  for (std::uint32_t trial = 0; trial < kStarts; ++trial) {
    SliceRobot robot = random_start(trial, adjustment);
    for (int slice = 0; slice < kSlices; ++slice) (void)robot.advance();
    travelled += robot.travelled;
  }
  return travelled / (kStarts * kSlices);
}

// The trap: the adjustment never moves a `< >` pair, so one that is forgotten at every slice lets
// the same legs step in every slice, for ever.
TEST(Trap, ThePapersWordsTakenLiterallyWalkExactlyAsWithoutAdjustment) {
  int adjusted_slices = 0;
  for (std::uint32_t trial = 0; trial < kStarts; ++trial) {
    SliceRobot literal = random_start(trial, Adjustment::literal);
    SliceRobot none = random_start(trial, Adjustment::none);
    for (int slice = 0; slice < kSlices; ++slice) {
      const GaitDecision a = literal.advance();
      const GaitDecision b = none.advance();
      ASSERT_EQ(a.may_step, b.may_step) << "trial " << trial << ", slice " << slice;
      ASSERT_EQ(literal.foot, none.foot);
      adjusted_slices += a.state == b.state ? 0 : 1;
    }
  }
  EXPECT_GT(adjusted_slices, kSlices) << "it does adjust; it only doesn't matter";
}

// Tripods alternate every 6 slices and the body goes 50 per step: the mean foot is at 0, three feet
// are at +25 in the air, so the support feet go from +25 to -25 meanwhile.
TEST(Latch, WalksTheSliceModelAtTheTripodsSpeed) {
  const double tripod = 50.0 / 6.0;
  EXPECT_NEAR(mean_speed(Adjustment::latched), tripod, 0.01 * tripod);
  EXPECT_LT(mean_speed(Adjustment::none), 0.85 * tripod);
}

// Both tripods have stepped after two steps of 6 slices each.
TEST(Latch, ReachesTheTripodGaitWithinTwoStepsOfEveryRandomStart) {
  for (std::uint32_t trial = 0; trial < kStarts; ++trial) {
    SliceRobot robot = random_start(trial, Adjustment::latched);
    for (int slice = 0; slice < 60; ++slice) {
      const LegSet lifted = robot.advance().may_step;
      if (slice < 12 || lifted.empty()) continue;
      ASSERT_TRUE(lifted == first_tripod(6) || lifted == second_tripod(6)) << "slice " << slice;
    }
  }
}

}  // namespace
}  // namespace hexagait::gait_state

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/footstep_gen/roughness.hpp>

namespace hexagait::footstep_gen {
namespace {

constexpr StepParams kStep{.height = 0.1, .level_height = 0.4, .haste = 1.6, .descent = 1.4};

TEST(HeightSpread, IsFromTheLowestPrintToTheHighest) {
  LegArray<Vector3> print_O(4, Vector3(0.3, -0.2, 5.0));
  EXPECT_EQ(height_spread(print_O), 0.0) << "wherever the ground is";
  print_O[1].z() = 5.03, print_O[2].z() = 4.98, print_O[3].z() = 5.01;
  EXPECT_NEAR(height_spread(print_O), 0.05, 1e-12);
}

// On level ground 0.4 · 0.1 = 0.04. From a spread of 0.06 on all of it.
TEST(OnGround, LiftsTheFeetByWhatThePrintsDifferByUpToTheNominalHeight) {
  EXPECT_NEAR(on_ground(kStep, 0.0).height, 0.04, 1e-12);
  for (const double spread : {0.01, 0.02, 0.03, 0.05, 0.059})
    EXPECT_NEAR(on_ground(kStep, spread).height, 0.04 + spread, 1e-12) << spread;
  for (const double spread : {0.061, 0.1, 1.0}) EXPECT_EQ(on_ground(kStep, spread).height, 0.1);
}

TEST(OnGround, IsTheSameEverywhereForWhoSaysSo) {
  StepParams same = kStep;
  same.level_height = 1.0;
  for (const double spread : {0.0, 0.03, 1.0}) EXPECT_EQ(on_ground(same, spread).height, 0.1);
}

// Half a step height, 5 cm, is forgotten after one stroke of 0.2 m; what is found is known at once.
TEST(RememberedSpread, IsTheGreatestOfLate) {
  StepParams step = kStep;
  step.stroke = 0.2;
  EXPECT_EQ(remembered_spread(0.0, 0.12, 0.001, step), 0.12);
  double spread = 0.12;
  for (int k = 0; k < 100; ++k) spread = remembered_spread(spread, 0.01, 0.002, step);
  EXPECT_NEAR(spread, 0.07, 1e-12);
  for (int k = 0; k < 200; ++k) spread = remembered_spread(spread, 0.01, 0.002, step);
  EXPECT_EQ(spread, 0.01);
  EXPECT_EQ(remembered_spread(0.12, 0.01, 0.0, step), 0.12) << "who stands forgets nothing";
  EXPECT_NEAR(remembered_spread(5.0, 0.01, 0.2, step), 0.2, 1e-12) << "a fall is forgotten too";
}

// Full haste up to a spread of 0.15 m, none from 0.25 m on, half of it between them. So descents.
TEST(OnGround, IsInHasteWherePrintsDifferLittle) {
  for (const double spread : {0.0, 0.1, 0.149}) EXPECT_EQ(on_ground(kStep, spread).haste, 1.6);
  EXPECT_NEAR(on_ground(kStep, 0.2).haste, 1.3, 1e-12);
  for (const double spread : {0.251, 1.0}) EXPECT_EQ(on_ground(kStep, spread).haste, 1.0);
  EXPECT_EQ(on_ground(kStep, 0.1).descent, 1.4);
  EXPECT_NEAR(on_ground(kStep, 0.2).descent, 1.2, 1e-12);
  EXPECT_EQ(on_ground(kStep, 0.251).descent, 1.0);
  StepParams flat_feet = kStep;
  flat_feet.height = 0.0;
  EXPECT_EQ(on_ground(flat_feet, 0.0).haste, 1.0) << "no clearance, no haste";
}

// (step 10) Steps of 0.04 m in a haste of 1.6 become such of 0.028 m in one of 1.81, which touch down at the same speed
// and are slow over 30 % of the way; none of it from a spread of 0.03 m on.
TEST(OnLevelGround, TakesLowerStepsInMoreHasteThatTouchDownNoFaster) {
  StepParams full = kStep;
  full.touchdown = 1.5;
  const auto level = [&full](double spread) {
    return on_level_ground(on_ground(full, spread), spread, full);
  };
  EXPECT_NEAR(level(0.0).height, 0.028, 1e-12);
  EXPECT_NEAR(level(0.0).haste, 1.81, 1e-12);
  EXPECT_NEAR(level(0.0).haste * level(0.0).touchdown, 1.6 * full.touchdown, 1e-12);
  EXPECT_NEAR(level(0.0).slow_way, 0.3, 1e-12);
  EXPECT_NEAR(level(0.0).overreach, 0.0, 1e-12);
  EXPECT_NEAR(level(0.015).height, 0.04 + 0.015 - 0.006, 1e-12);
  EXPECT_NEAR(level(0.015).haste, 1.6 + 0.105, 1e-12);
  EXPECT_NEAR(level(0.015).slow_way, 0.65, 1e-12);
  EXPECT_NEAR(level(0.015).overreach, 0.5, 1e-12);
  for (const double spread : {0.031, 0.2, 1.0}) {
    EXPECT_EQ(level(spread).height, on_ground(full, spread).height) << spread;
    EXPECT_EQ(level(spread).haste, on_ground(full, spread).haste) << spread;
    EXPECT_EQ(level(spread).touchdown, full.touchdown) << spread;
    EXPECT_EQ(level(spread).slow_way, 1.0) << spread;
    EXPECT_EQ(level(spread).overreach, 1.0) << spread;
  }
  StepParams late = full;
  late.haste = 1.0;
  EXPECT_EQ(on_level_ground(late, 0.0, full).height, full.height) << "drives that lag";
  EXPECT_EQ(on_level_ground(late, 0.0, full).slow_way, 1.0) << "drives that lag";
  EXPECT_EQ(on_level_ground(late, 0.0, late).haste, 1.0) << "who asks for no haste";
}

// (step 11) A foot of 2 cm: an edge from 2.5 mm below on, or from by what the prints differ; where that is 1 cm it can't tell.
TEST(EdgeDepth, IsAnEighthOfTheFootOrWhatThePrintsDifferBy) {
  EXPECT_NEAR(edge_depth(0.0, 0.02), 0.0025, 1e-12);
  EXPECT_NEAR(edge_depth(0.006, 0.02), 0.006, 1e-12);
  EXPECT_EQ(edge_depth(0.01, 0.02), SearchDepth::kNever);
  EXPECT_EQ(edge_depth(0.1, 0.02), SearchDepth::kNever);
  EXPECT_EQ(edge_depth(0.0, 0.0), SearchDepth::kNever) << "a foot without a radius";
}

// As fast as always up to a spread of 0.1 m, 1.4 times as fast from 0.13 m on.
TEST(OnGuessedGround, DescendsFasterWherePrintsDifferByMoreThanTheClearance) {
  EXPECT_EQ(on_guessed_ground(kStep, 0.099).descent, 1.0);
  EXPECT_NEAR(on_guessed_ground(kStep, 0.115).descent, 1.2, 1e-12);
  EXPECT_NEAR(on_guessed_ground(kStep, 0.131).descent, 1.4, 1e-12);
}

// Up or down: all of it up to a sine of 0.10, none from 0.15 on.
TEST(OnSlope, DescendsNoFasterWhereThePathIsSteep) {
  for (const double sense : {1.0, -1.0}) {
    EXPECT_EQ(on_slope(kStep, sense * 0.099).descent, kStep.descent);
    EXPECT_NEAR(on_slope(kStep, sense * 0.125).descent, 1.2, 1e-12);
    EXPECT_EQ(on_slope(kStep, sense * 0.151).descent, 1.0);
  }
  EXPECT_EQ(on_slope(kStep, 1.0).haste, kStep.haste);
}

// From a spread of 0.065 m on, all of it from 0.095 m on.
TEST(OnGuessedGround, TouchesDownFasterAndStepsFarther) {
  StepParams step = kStep;
  step.stroke = 0.2, step.touchdown = 2.5;
  for (const double spread : {0.0, 0.03, 0.064}) {
    EXPECT_EQ(on_guessed_ground(step, spread).touchdown, 1.0) << spread;
    EXPECT_EQ(on_guessed_ground(step, spread).stroke, 0.2) << spread;
  }
  EXPECT_NEAR(on_guessed_ground(step, 0.08).touchdown, 1.75, 1e-12);
  EXPECT_NEAR(on_guessed_ground(step, 0.08).stroke, 0.21, 1e-12);
  for (const double spread : {0.096, 0.2, 5.0}) {
    EXPECT_NEAR(on_guessed_ground(step, spread).touchdown, 2.5, 1e-12) << spread;
    EXPECT_NEAR(on_guessed_ground(step, spread).stroke, 0.22, 1e-12) << spread;
  }
  EXPECT_EQ(on_guessed_ground(step, 0.2).height, step.height);
  step.height = 0.0;
  EXPECT_EQ(on_guessed_ground(step, 1.0).touchdown, 1.0) << "no clearance, no guess";
}

// Steps of 0.1 m: from a spread of 0.23 m on.
TEST(VeryRough, IsGroundWherePrintsDifferMuch) {
  for (const double spread : {0.0, 0.1, 0.229}) EXPECT_FALSE(very_rough(spread, kStep)) << spread;
  for (const double spread : {0.231, 0.25, 1.0}) EXPECT_TRUE(very_rough(spread, kStep)) << spread;
  StepParams flat_feet = kStep;
  flat_feet.height = 0.0;
  EXPECT_FALSE(very_rough(1.0, flat_feet)) << "no clearance, no scale";
  EXPECT_EQ(very_rough_gait(0.8).stepping, gait_state::Stepping::wave);
  EXPECT_EQ(very_rough_gait(0.8).duty_factor, 0.5);
  EXPECT_NEAR(very_rough_gait(0.8).longest_step, 0.96, 1e-12);
}

}  // namespace
}  // namespace hexagait::footstep_gen

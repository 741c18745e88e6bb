// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/footstep_gen/roughness.hpp>

namespace hexagait::footstep_gen {
namespace {

constexpr StepParams kStep{.height = 0.1, .level_height = 0.4};

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

}  // namespace
}  // namespace hexagait::footstep_gen

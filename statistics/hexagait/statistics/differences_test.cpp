// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <hexagait/statistics/differences.hpp>
#include <vector>

namespace hexagait::statistics {
namespace {

// {1, 2, 3} and {4, 6}: s² = 1 and 2, so the variances of the means are 1/3 and 1, and
// ν = (4/3)² / ((1/9)/2 + 1/1) = 1.684; t₀.₉₇₅(1.684) = 5.1762 by Simpson's rule over the density.
TEST(UnpairedDifference, IsThatOfWelch) {
  const std::vector<double> a = {4.0, 6.0}, b = {1.0, 2.0, 3.0};
  const Difference d = unpaired_difference(a, b);
  EXPECT_DOUBLE_EQ(d.value, 3.0);
  EXPECT_NEAR(d.upper - d.value, 5.17623 * std::sqrt(4.0 / 3.0), 1e-4);
  EXPECT_DOUBLE_EQ(d.upper - d.value, d.value - d.lower);
  EXPECT_DOUBLE_EQ(unpaired_difference(b, a).value, -3.0);
}

TEST(UnpairedDifference, OfOneValueIsNotKnownAndOfEqualOnesIsExact) {
  EXPECT_TRUE(std::isinf(unpaired_difference(std::vector{1.0}, std::vector{1.0, 2.0}).upper));
  const Difference d = unpaired_difference(std::vector{2.0, 2.0}, std::vector{1.0, 1.0});
  EXPECT_EQ(d.lower, 1.0);
  EXPECT_EQ(d.upper, 1.0);
}

// Newcombe 1998, table II, method 10: 56/70 − 48/80 = 0.2 from 0.0524 to 0.3339.
TEST(DifferenceOfProportions, IsThatOfNewcombe) {
  const Difference d = difference(proportion(56, 70), proportion(48, 80));
  EXPECT_NEAR(d.value, 0.2, 1e-12);
  EXPECT_NEAR(d.lower, 0.0524, 1e-4);
  EXPECT_NEAR(d.upper, 0.3339, 1e-4);
}

TEST(DifferenceOfProportions, IsNotCertainWhereNothingHappened) {
  const Difference d = difference(proportion(0, 20), proportion(0, 20));
  EXPECT_EQ(d.value, 0.0);
  EXPECT_GT(d.upper, 0.1);
  EXPECT_DOUBLE_EQ(d.lower, -d.upper);
}

}  // namespace
}  // namespace hexagait::statistics

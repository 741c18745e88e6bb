// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <hexagait/sim/random.hpp>
#include <hexagait/statistics/statistics.hpp>

namespace hexagait::statistics {
namespace {

// 2 4 4 4 6: mean 4, squares 4 + 4, sd √(8/4) = √2; t₀.₉₇₅(4) = 2.776445.
TEST(Estimate, IsThatOfAHandComputedSample) {
  const Estimate e = estimate(std::array{2.0, 4.0, 4.0, 4.0, 6.0});
  EXPECT_EQ(e.count, 5);
  EXPECT_DOUBLE_EQ(e.mean, 4.0);
  EXPECT_DOUBLE_EQ(e.sd, std::sqrt(2.0));
  EXPECT_NEAR(e.half_width, 2.776445 * std::sqrt(2.0) / std::sqrt(5.0), 1e-6);
  EXPECT_DOUBLE_EQ(e.upper() - e.mean, e.mean - e.lower());
}

// Two values 0, 1: sd 1/√2, half width t₀.₉₇₅(1) · 1/√2/√2 = tan(0.475 π)/2 = 12.7062/2 (Cauchy).
TEST(Estimate, OfTwoTrialsIsTheCauchyQuantile) {
  EXPECT_NEAR(estimate(std::array{0.0, 1.0}).half_width, std::tan(0.475 * 3.14159265358979) / 2.0,
              1e-9);
}

TEST(Estimate, OfOneTrialKnowsNothingOfItsError) {
  const Estimate e = estimate(std::array{7.0});
  EXPECT_EQ(e.mean, 7.0);
  EXPECT_TRUE(std::isinf(e.half_width));
}

// 1000 samples of 10 uniform numbers: the true mean 1/2 is outside about 50 times, with standard
// deviation √(1000 · 0.05 · 0.95) = 7.
TEST(Estimate, CoversTheTrueMeanNineteenTimesInTwenty) {
  RandomSequence random{.seed = 3};
  int outside = 0;
  for (int sample = 0; sample < 1000; ++sample) {
    std::array<double, 10> values{};
    for (double& value : values) value = random.u01();
    const Estimate e = estimate(values);
    outside += e.lower() > 0.5 || e.upper() < 0.5 ? 1 : 0;
  }
  EXPECT_NEAR(outside, 50, 4 * 7);
}

// Trials differ by 10, the pairs by 1, 1, 2: mean 4/3, sd 1/√3, t₀.₉₇₅(2) = 4.302653.
TEST(PairedDifference, CancelsWhatTheTrialsHaveInCommon) {
  const Estimate e = paired_difference(std::array{11.0, 21.0, 32.0}, std::array{10.0, 20.0, 30.0});
  EXPECT_DOUBLE_EQ(e.mean, 4.0 / 3.0);
  EXPECT_NEAR(e.half_width, 4.302653 / std::sqrt(3.0) / std::sqrt(3.0), 1e-6);
}

}  // namespace
}  // namespace hexagait::statistics

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <hexagait/sim/random.hpp>
#include <hexagait/statistics/statistics.hpp>
#include <stdexcept>

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

TEST(Estimate, OfNothingOrOfUnequalPairsIsAnError) {
  EXPECT_THROW((void)estimate({}), std::invalid_argument);
  EXPECT_THROW((void)paired_difference(std::array{1.0}, std::array{1.0, 2.0}),
               std::invalid_argument);
}

// The limits solve (p̂ − p)² = z² p (1 − p)/n; at p̂ = 1 that is p = n/(n + z²), at p̂ = 0 z²/(n + z²).
TEST(Proportion, OfAllOrNoneIsTheClosedForm) {
  constexpr double kZ2 = 1.959963984540054 * 1.959963984540054;
  for (const int n : {1, 5, 20, 300}) {
    EXPECT_NEAR(proportion(n, n).lower, n / (n + kZ2), 1e-12);
    EXPECT_EQ(proportion(n, n).upper, 1.0);
    EXPECT_NEAR(proportion(0, n).upper, kZ2 / (n + kZ2), 1e-12);
    EXPECT_EQ(proportion(0, n).lower, 0.0);
  }
  EXPECT_NEAR(proportion(20, 20).lower, 0.8389, 5e-5);
}

// Swapping what counts mirrors the interval.
TEST(Proportion, OfTheOppositeIsTheMirrorImage) {
  for (int k = 0; k <= 37; ++k) {
    const Proportion p = proportion(k, 37), q = proportion(37 - k, 37);
    EXPECT_NEAR(p.lower, 1.0 - q.upper, 1e-12);
    EXPECT_NEAR(p.upper, 1.0 - q.lower, 1e-12);
    EXPECT_LE(p.lower, p.share());
    EXPECT_GE(p.upper, p.share());
  }
}

// Coverage by going through all outcomes, weighted by the binomial distribution: P(lower ≤ p ≤
// upper) summed over k. Wilson's interval covers 95 % on average over p, not for each p: near the
// ends single values of p have less (Brown, Cai & DasGupta 2001 give 0.83 as its least).
TEST(Proportion, CoversTheTrueProbabilityNineteenTimesInTwentyOnAverage) {
  for (const int n : {10, 20, 50}) {
    double sum = 0.0;
    int count = 0;
    for (double p = 0.0025; p < 1.0; p += 0.005, ++count) {
      double covered = 0.0, weight = std::pow(1.0 - p, n);  // of k = 0
      for (int k = 0; k <= n; ++k) {
        const Proportion interval = proportion(k, n);
        if (interval.lower <= p && p <= interval.upper) covered += weight;
        weight *= p / (1.0 - p) * (n - k) / (k + 1.0);
      }
      EXPECT_GT(covered, 0.83) << n << " trials, p = " << p;
      sum += covered;
    }
    EXPECT_NEAR(sum / count, 0.95, 0.01) << n << " trials";
  }
}

TEST(Proportion, OfNoTrialsOrOfMoreThanAllIsAnError) {
  EXPECT_THROW((void)proportion(0, 0), std::invalid_argument);
  EXPECT_THROW((void)proportion(3, 2), std::invalid_argument);
  EXPECT_THROW((void)proportion(-1, 2), std::invalid_argument);
}

TEST(Extremes, AreNotANumberIfAValueIsOrIfThereAreNone) {
  const double nan = std::nan("");
  EXPECT_EQ(greatest(std::array{1.0, 3.0, 2.0}), 3.0);
  EXPECT_EQ(least(std::array{3.0, 1.0, 2.0}), 1.0);
  for (const auto& values : {std::array{nan, 1.0}, std::array{1.0, nan}}) {
    EXPECT_TRUE(std::isnan(greatest(values)));
    EXPECT_TRUE(std::isnan(least(values)));
  }
  EXPECT_TRUE(std::isnan(greatest({})));
  EXPECT_TRUE(std::isnan(least({})));
}

}  // namespace
}  // namespace hexagait::statistics

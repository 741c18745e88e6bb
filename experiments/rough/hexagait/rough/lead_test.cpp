// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/rough/lead.hpp>

namespace hexagait::experiments {
namespace {

TEST(TimeOfTurn, IsThatOfAStepIfAllTakeTheSameTime) {
  const std::vector<double> same = {0.7};
  EXPECT_NEAR(time_of_turn(same, WaitsFor::neighbours, 100), 0.7, 1e-12);
  EXPECT_NEAR(time_of_turn(same, WaitsFor::tripod, 100), 0.7, 1e-12);
}

// Of steps of 0 or 1 s, as often, the last of three takes 1 − 1/8 s. Who waits for two of them waits for less.
TEST(TimeOfTurn, IsThatOfTheLastOfThoseWaitedFor) {
  const std::vector<double> times = {0.0, 1.0};
  EXPECT_NEAR(time_of_turn(times, WaitsFor::tripod, 40000), 0.875, 0.01);
  const double free = time_of_turn(times, WaitsFor::neighbours, 40000);
  EXPECT_GT(free, 0.75) << "the last of two, that begin at the same time";
  EXPECT_LT(free, 0.86);
}

LeadPoint of(double short_step, double long_step, double cycle) {
  return {0.15, {.steps = {short_step, long_step}, .cycles = {cycle}}};
}

TEST(LeadOfStepTimes, IsSmallWhereStepsDifferLittle) {
  const Verdict verdict = judge_lead_of_step_times(std::vector{of(0.5, 0.9, 1.66)});
  EXPECT_TRUE(verdict.is_accounted_for());
  EXPECT_FALSE(judge_lead_of_step_times(std::vector{of(0.5, 0.9, 2.2)}).is_accounted_for())
      << "something else takes time";
  EXPECT_FALSE(judge_lead_of_step_times(std::vector{of(0.0, 1.0, 1.65)}).is_accounted_for())
      << "5 % are within reach";
}

}  // namespace
}  // namespace hexagait::experiments

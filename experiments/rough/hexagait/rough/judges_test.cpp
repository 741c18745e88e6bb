// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <hexagait/rough/tally.hpp>

namespace hexagait::experiments {
namespace {

constexpr const char *kFails = "FAILS", *kKnown = "as expected, does not hold";

RoughPoint of(const std::string& plant, const std::string& controller, double height, int arrived,
              double speed, double lead = 0.0, double half = 0.0005) {
  return {.plant = plant,
          .controller = controller,
          .height = height,
          .arrived = statistics::proportion(arrived, 200),
          .fell = 200 - arrived,
          .speed = {speed, speed, speed},
          .lead = {lead, lead - half, lead + half}};
}

// As many arrive as are known to, with both plants.
std::vector<RoughPoint> points() {
  std::vector<RoughPoint> all;
  struct Row {
    double height;
    int ideal, real;
  };
  for (const bool ideal : {true, false})
    for (const Row& row : {Row{0.0, 200, 200}, Row{0.15, 200, 195}, Row{0.20, 199, 196},
                           Row{0.25, 193, 183}, Row{0.30, 188, 165}})
      for (const char* controller : {"tripod", "free"})
        all.push_back(of(ideal ? "ideal" : "real", controller, row.height,
                         ideal ? row.ideal : row.real, 0.15, row.height < 0.25 ? 0.0 : -0.01));
  return all;
}

RoughPoint& free_at(std::vector<RoughPoint>& all, const std::string& plant, double height) {
  return const_cast<RoughPoint&>(*point(all, plant, "free", height));
}

TEST(JudgeRough, FindsAsManyAsAreKnownToArrive) {
  EXPECT_EQ(judge_success(points()).word(), kKnown);
  EXPECT_EQ(judge_success(points()).checks.size(), 4U);
}

TEST(JudgeRough, FailsIfLessArriveThanIsKnown) {
  auto all = points();
  free_at(all, "ideal", 0.25).arrived = statistics::proportion(180, 200);
  EXPECT_EQ(judge_success(all).word(), kFails);
  EXPECT_EQ(judge_success(all).checks[2].finding(), Finding::fails_otherwise);
}

TEST(JudgeRough, WantsEveryWalkOver15CentimetresToArrive) {
  auto all = points();
  EXPECT_EQ(judge_success(all).checks[0].finding(), Finding::holds);
  free_at(all, "ideal", 0.15).arrived = statistics::proportion(199, 200);
  EXPECT_EQ(judge_success(all).word(), kFails);
}

TEST(JudgeRough, TellsWhenMoreArriveThanWasDeclared) {
  auto all = points();
  free_at(all, "ideal", 0.25).arrived = statistics::proportion(196, 200);
  EXPECT_EQ(judge_success(all).word(), kFails);
  EXPECT_EQ(judge_success(all).checks[2].finding(), Finding::holds_unexpectedly);
}

TEST(JudgeRough, AllowsThePlantRealThreePoints) {
  auto all = points();
  EXPECT_EQ(judge_real(all).word(), kKnown);  // from 25 cm on
  EXPECT_EQ(judge_real(all).checks[0].finding(), Finding::holds);
  EXPECT_EQ(judge_real(all).checks[1].finding(), Finding::holds);
  free_at(all, "real", 0.15).arrived = statistics::proportion(193, 200);
  EXPECT_EQ(judge_real(all).word(), kFails);
}

// All of the interval has to be above −1 %: −1 % of 0.15 m/s is −0.0015 m/s.
TEST(JudgeRough, WantsAllOfTheIntervalAboveTheMargin) {
  auto all = points();
  EXPECT_EQ(judge_lead(all).checks.size(), 7U);
  EXPECT_EQ(judge_lead(all).word(), kKnown);  // the ratios of 1.05, and a wave over 25 and 30 cm
  free_at(all, "ideal", 0.20).lead = {-0.0011, -0.0016, -0.0006};
  EXPECT_EQ(judge_lead(all).word(), kFails);
}

TEST(JudgeRough, TellsWhenTheWaveIsNotSlower) {
  auto all = points();
  free_at(all, "ideal", 0.25).lead = {0.001, 0.0, 0.002};
  EXPECT_EQ(judge_lead(all).word(), kFails);
}

TEST(JudgeRough, TellsWhenTheFreeGaitLeads) {
  auto all = points();
  free_at(all, "ideal", 0.15).lead = {0.009, 0.008, 0.010};
  EXPECT_THAT(judge_lead(all).lines(), ::testing::Contains(::testing::HasSubstr("1.06; claimed")));
  EXPECT_EQ(judge_lead(all).word(), kFails);
}

TEST(RoughTable, HasSharesOfReachAndOfTheSpeedOnFlatGround) {
  auto all = points();
  free_at(all, "ideal", 0.20).speed = {0.12, 0.11, 0.13};
  const figures::Csv csv = table(all, 0.5);
  const auto column = [&](const char* name) {
    return static_cast<std::size_t>(std::ranges::find(csv.header(), name) - csv.header().begin());
  };
  ASSERT_EQ(csv.rows().size(), all.size());
  const auto& row = csv.rows()[5];  // of the free gait with the ideal plant
  EXPECT_EQ(row[column("height_of_reach")], "0.4");
  EXPECT_EQ(row[column("speed_of_flat")], "0.8");
  EXPECT_EQ(row[column("fell")], "1");
}

TEST(RoughPage, SaysHowTheOthersEndedAndLeavesOutWhatThereIsNot) {
  auto all = points();
  RoughPoint& free = free_at(all, "real", 0.30);
  free.arrived = statistics::proportion(0, 200);
  free.fell = 150;
  free.stuck = 30;
  free.late = 10;
  free.speed = {};
  const std::string text = page(all, 0.63);
  EXPECT_THAT(text, ::testing::HasSubstr("Plant `real`:"));
  EXPECT_THAT(
      text, ::testing::HasSubstr("| 30 | 0.48 | `free` | 0 of 200 (0–2 %) | 150 fell, 30 stuck, 10 "
                                 "late, 10 fault | – | – |"));
}

}  // namespace
}  // namespace hexagait::experiments

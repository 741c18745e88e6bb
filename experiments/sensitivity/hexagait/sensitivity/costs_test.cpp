// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <hexagait/recording/plant_setup.hpp>
#include <hexagait/sensitivity/costs.hpp>
#include <set>

namespace hexagait::experiments {
namespace {

Cost cost(int arrived, double speed) {
  return {.arrived = statistics::proportion(arrived, 10), .speed = speed, .off_path = 0.01};
}

const std::vector<PlantCost> kCosts = {{"ideal", cost(10, 0.20), cost(10, 0.15)},
                                       {"late_ticks:1%", cost(10, 0.161), cost(8, 0.121)},
                                       {"late_ticks:5%", cost(10, 0.161), cost(7, 0.121)},
                                       {"late_ticks:9%", cost(10, 0.20), cost(10, 0.15)},
                                       {"servo_lag:1ms", cost(10, 0.15), cost(10, 0.15)},
                                       {"armature:1kgm2", {}, {}}};

TEST(Sensitivity, AllLaddersHavePlantsThatExistEachOnce) {
  for (const bool short_form : {false, true}) {
    std::set<std::string> seen;
    for (const Ladder& ladder : ladders(short_form))
      for (const std::string& plant : ladder.plants) {
        EXPECT_NO_THROW((void)recording::parse_plant(plant)) << plant;
        EXPECT_TRUE(seen.insert(plant).second) << plant;
      }
    EXPECT_TRUE(seen.contains("ideal") && seen.contains("real"));
  }
}

// Every number that a plant has is on a ladder, and each ladder rises.
TEST(Sensitivity, LaddersHaveEveryNumberAndGoAwayFromIdeal) {
  std::set<std::string> seen;
  for (const Ladder& ladder : ladders(false)) seen.insert(ladder.fault);
  for (const recording::PlantNumber& number : recording::plant_numbers()) {
    EXPECT_TRUE(seen.contains(number.name)) << number.name;
    for (const Ladder& ladder : ladders(false)) {
      if (ladder.fault != number.name) continue;
      double before = 0.0;
      for (const std::string& plant : ladder.plants) {
        const double off = std::abs(number.of(recording::parse_plant(plant)) - number.of({}));
        EXPECT_GT(off, before) << plant;
        before = off;
      }
    }
  }
}

// Four of five, and four fifths of the speed, are enough on either terrain; less is not.
TEST(Sensitivity, ItBreaksAtTheFirstSizeThatIsTooMuch) {
  EXPECT_EQ(breaks_at({"late_ticks", {"late_ticks:1%", "late_ticks:5%", "late_ticks:9%"}}, kCosts),
            "late_ticks:5%");
  EXPECT_EQ(breaks_at({"servo_lag", {"servo_lag:1ms"}}, kCosts), "servo_lag:1ms");
  EXPECT_EQ(breaks_at({"late_ticks", {"late_ticks:1%"}}, kCosts), "");
}

// Where none walked on there is no speed.
TEST(Sensitivity, ThePageHasALinePerPlantAndPerFault) {
  std::vector<PlantCost> costs = kCosts;
  costs.back().flat.arrived = costs.back().boxes.arrived = statistics::proportion(0, 10);
  const std::string text = page({5.0, 45.0, 4, 12, false},
                                {{"", {"ideal"}},
                                 {"late_ticks", {"late_ticks:1%", "late_ticks:5%"}},
                                 {"armature", {"armature:1kgm2"}}},
                                costs);
  for (const char* part :
       {"| `late_ticks` | Probability that", "| **5%** |", "| **1kgm2** |",
        "| `late_ticks:5%` | 10 of 10 (72–100 %) | 0.161 | 80 | 1.0 | 0.00 (0.00) | 7 of 10 (40–",
        "| `armature:1kgm2` | 0 of 10 (0–28 %) | – | – | – |"})
    EXPECT_THAT(text, ::testing::HasSubstr(part));
}

TEST(Sensitivity, ThePageSaysWhatEachLadderIsAndItsSizesAlone) {
  const std::vector<PlantCost> costs = {{"ideal", cost(10, 0.20), cost(10, 0.15)},
                                        {"imu:on", cost(10, 0.20), cost(10, 0.15)},
                                        {"imu:on+rate_bias:0.05", cost(10, 0.1), cost(10, 0.15)}};
  const std::string text =
      page({}, {{"imu", {"imu:on"}}, {"rate_bias", {"imu:on+rate_bias:0.05"}}}, costs);
  EXPECT_THAT(text, ::testing::HasSubstr("| `imu` | The robot has an inertial measurement unit"));
  EXPECT_THAT(text, ::testing::HasSubstr("| still walks at on |"));
  EXPECT_THAT(text, ::testing::HasSubstr("| **0.05** |"));
}

}  // namespace
}  // namespace hexagait::experiments

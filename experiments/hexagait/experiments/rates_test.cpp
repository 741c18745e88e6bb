// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/experiments/rates.hpp>

namespace hexagait::experiments::rates_test {
namespace {

constexpr double kReach = 0.6;  // [m]

std::vector<JudgedWalk> good_walks(double control_dt = 0.002) {
  JudgedWalk walk{.group = "heading", .name = "", .simulation = {}, .max_lateral = 0.005};
  walk.simulation.trial.distance = 5.0;
  walk.simulation.control_dt = control_dt;
  walk.summary.seconds = 40.0;
  walk.summary.speed = 0.23;
  walk.summary.lateral_mean = 0.001;
  walk.summary.arrived = true;
  return std::vector<JudgedWalk>(20, walk);
}

std::string word_on_flat(double control_dt, auto change) {
  std::vector<JudgedWalk> walks = good_walks(control_dt);
  change(walks[7].summary);
  return judge_rate(walks, good_walks(), kReach).word();
}

TEST(JudgeRate, FailsAWalkThatIsWorseThanItsReference) {
  EXPECT_EQ(word_on_flat(0.005, [](auto&) {}), "holds");
  EXPECT_EQ(word_on_flat(0.005, [](auto& s) { s.fell = true; }), "FAILS");
  EXPECT_EQ(word_on_flat(0.005, [](auto& s) { s.stuck = true; }), "FAILS");
  EXPECT_EQ(word_on_flat(0.005, [](auto& s) { s.speed *= 0.96; }), "FAILS");
  EXPECT_EQ(word_on_flat(0.005, [](auto& s) { s.speed = std::nan(""); }), "FAILS");
}

constexpr const char* kAsExpected = "as expected, does not hold";

TEST(JudgeRate, ExpectsLessSpeedFromTenMillisecondsOn) {
  for (const double control_dt : {0.010, 0.020}) {
    EXPECT_EQ(word_on_flat(control_dt, [](auto& s) { s.speed *= 0.95; }), kAsExpected);
    EXPECT_EQ(word_on_flat(control_dt, [](auto& s) { s.speed *= 0.92; }), "FAILS");
    EXPECT_EQ(word_on_flat(control_dt, [](auto& s) { s.speed *= 0.98; }), "FAILS") << "it holds";
  }
}

TEST(JudgeRate, AllowsACentimetreOnlyAboveTenMilliseconds) {
  const auto off_path = [](double control_dt, double distance) {
    return word_on_flat(control_dt, [distance](auto& s) {
      s.speed *= 0.95;
      s.lateral_mean = distance;
    });
  };
  EXPECT_EQ(off_path(0.010, 0.006), "FAILS");
  EXPECT_EQ(off_path(0.020, 0.006), kAsExpected);
  EXPECT_EQ(off_path(0.020, 0.011), "FAILS");
}

TEST(JudgeRate, TakesASpinByItsOutermostFoot) {
  std::vector<JudgedWalk> spins = good_walks(0.005);
  for (JudgedWalk& walk : spins) {
    walk.summary.speed = 0.0;
    walk.summary.turned = -12.0;
  }
  EXPECT_EQ(judge_rate(spins, spins, kReach).word(), "holds");
  const std::vector<JudgedWalk> reference = spins;
  spins[3].summary.turned = -11.0;
  EXPECT_EQ(judge_rate(spins, reference, kReach).word(), "FAILS");
}

TEST(JudgeRateOnTerrain, CountsWhoArrives) {
  std::vector<JudgedWalk> walks = good_walks(0.020);
  walks[3].summary.arrived = false;
  EXPECT_EQ(judge_rate_on_terrain(walks, 19).word(), "holds");
  EXPECT_EQ(judge_rate_on_terrain(walks, 20).word(), "FAILS");
}

}  // namespace
}  // namespace hexagait::experiments::rates_test

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/pc04/navigation/navigation_judge.hpp>

namespace hexagait::experiments {
namespace {

using navigation::Reason;

NavigationWalk an_hour() {
  NavigationWalk walk;
  walk.simulation.trial.seconds = 3600.0;
  walk.summary.seconds = 3600.0;
  walk.path = 150.0;
  walk.area = 15.0;
  walk.deepest = 0.001;
  for (int k = 0; k < 200; ++k)
    for (const Reason reason : {Reason::cliff, Reason::touch})
      walk.meetings.push_back({.reason = reason});
  return walk;
}

std::vector<bool> holding(const std::vector<NavigationWalk>& walks) {
  std::vector<bool> all;
  for (const Verdict& verdict : judge_navigation(walks)) all.push_back(verdict.holds());
  return all;
}

TEST(JudgeNavigation, WantsAnHourWithoutAFallAmongWallsAndCliffs) {
  using Words = std::vector<bool>;
  EXPECT_EQ(holding({an_hour(), an_hour()}), (Words{true, true}));
  const auto broken = [](auto change) {
    std::vector<NavigationWalk> walks = {an_hour(), an_hour()};
    change(walks[1]);
    return holding(walks);
  };
  EXPECT_EQ(broken([](auto& w) { w.summary.fell = true; }), (Words{false, true}));
  EXPECT_EQ(broken([](auto& w) { w.summary.fault = footstep_gen::Fault::plant_closed; }),
            (Words{false, true}));
  EXPECT_EQ(broken([](auto& w) { w.summary.stuck = true; }), (Words{false, true}));
  EXPECT_FALSE(broken([](auto& w) { w.summary.seconds = 3500.0; })[0]);
  EXPECT_FALSE(broken([](auto& w) { w.deepest = 0.03; })[0]);
  const auto without = [&](Reason reason) {
    return broken([&](NavigationWalk& w) {
      std::erase_if(w.meetings, [&](const auto& one) { return one.reason == reason; });
    });
  };
  EXPECT_EQ(without(Reason::cliff), (Words{true, false}));
  EXPECT_EQ(without(Reason::touch), (Words{true, false}));
  EXPECT_FALSE(broken([](auto& w) { w.path = 50.0; })[1]);
  EXPECT_FALSE(broken([](auto& w) { w.area = 3.0; })[1]);
}

}  // namespace
}  // namespace hexagait::experiments

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/fg16/judges.hpp>

// Each judge is shown what makes its claims hold, and then, one by one, what must break them.

namespace hexagait::experiments::judges_test {
namespace {

using Words = std::vector<std::string>;
const std::string kHolds = "holds", kFails = "FAILS";

Words words(const std::vector<Verdict>& verdicts) {
  Words all;
  for (const Verdict& verdict : verdicts) all.push_back(verdict.word());
  return all;
}

walk::ActionSummary succeeded() {
  walk::ActionSummary s;
  s.result.outcome = hexagait::Outcome::succeeded;
  s.margin_min = 0.05;
  return s;
}

const Vector3 kBlockedFoothold(0.5, 0.3, 0.02);

// Two climbs; in the second, leg 2 stands 3 cm beside its blocked foothold, and meets its next.
std::vector<Climbed> climbs() {
  Climbed free{succeeded(), {0.001, 0.002}, {{1.0, 0, {0.4, 0.3, 0.02}, {0.401, 0.3, 0.02}}}};
  Climbed blocked = free;
  for (int k = 0; k < 40; ++k) blocked.touchdowns.push_back(free.touchdowns.front());
  blocked.touchdowns.push_back(
      {2.0, 2, kBlockedFoothold, kBlockedFoothold + Vector3(-0.03, 0, 0.06)});
  blocked.touchdowns.push_back({3.0, 2, {0.7, 0.3, 0.02}, {0.701, 0.3, 0.02}});
  return {free, blocked};
}

Words judged(const std::vector<Climbed>& all) {
  return words(judge_climbs(all, all.back(), 2, kBlockedFoothold));
}

TEST(JudgeClimbs, WantsAllUpTheStepOnTheirFootholds) {
  EXPECT_EQ(judged(climbs()), (Words{kHolds, kHolds, kHolds}));
  const auto broken = [](auto change) {
    std::vector<Climbed> all = climbs();
    change(all);
    return judged(all);
  };
  EXPECT_EQ(broken([](auto& all) { all[0].summary.fell = true; })[0], kFails);
  EXPECT_EQ(broken([](auto& all) { all[0].summary.result.outcome = hexagait::Outcome::failed; })[0],
            kFails);
  EXPECT_EQ(broken([](auto& all) { all[0].summary.tilt_max = 0.7; })[0], kFails);
  EXPECT_EQ(broken([](auto& all) { all[0].swing_errors.assign(9, 0.02); })[1], kFails);
  EXPECT_EQ(broken([](auto& all) {
              for (Climbed& c : all) c.swing_errors.clear();
            })[1],
            kFails)
      << "no errors are not small errors";
}

TEST(JudgeClimbs, LooksAtTheFootThatIsBlockedAndNotAtTheWorstOne) {
  const auto broken = [](auto change) {
    std::vector<Climbed> all = climbs();
    change(all.back().touchdowns);
    return judged(all)[2];
  };
  // Another leg is far off; the blocked one stood on its foothold after all.
  EXPECT_EQ(broken([](auto& touchdowns) {
              touchdowns[0].reached.x() += 0.3;
              touchdowns[41].reached = touchdowns[41].foothold;
            }),
            kFails);
  EXPECT_EQ(broken([](auto& touchdowns) { touchdowns[42].reached.x() += 0.02; }), kFails);
  EXPECT_EQ(broken([](auto& touchdowns) { touchdowns.pop_back(); }), kFails) << "it has no next";
  EXPECT_EQ(broken([](auto& touchdowns) { touchdowns.clear(); }), kFails);
}

LocalisedWalk localised(double touchdown_error) {
  LocalisedWalk walk{succeeded(), 0.0008, 0.033, {touchdown_error}, {touchdown_error}};
  walk.summary.odometry_position = 0.05;
  return walk;
}

TEST(JudgeLocalised, WantsDriftJumpsSmoothnessAndAccuracy) {
  const LocalisedWalk good = localised(0.013), odometry = localised(0.047);
  const auto judge = [](const LocalisedWalk& combined, const LocalisedWalk& other) {
    return words(judge_localised(combined, other, 3.0, 0.015));
  };
  EXPECT_EQ(judge(good, odometry), (Words{kHolds, kHolds, kHolds}));
  const auto broken = [&](auto change) {
    LocalisedWalk walk = good;
    change(walk);
    return judge(walk, odometry);
  };
  EXPECT_EQ(broken([](auto& w) { w.summary.odometry_position = 0.01; })[0], kFails);
  EXPECT_EQ(broken([](auto& w) { w.localised_jump = 0.001; })[0], kFails);
  EXPECT_EQ(broken([](auto& w) { w.summary.fell = true; })[0], kFails);
  EXPECT_EQ(broken([](auto& w) { w.commanded_jump = 0.002; })[1], kFails);
  EXPECT_EQ(broken([](auto& w) { w.last_metre = {0.03}; })[2], kFails);
  EXPECT_EQ(broken([](auto& w) { w.last_metre.clear(); })[2], kFails) << "nothing is not near";
}

}  // namespace
}  // namespace hexagait::experiments::judges_test

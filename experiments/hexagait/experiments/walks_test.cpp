// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/experiments/walks.hpp>

// Each judge is shown walks as they should be, and then, one by one, what must fail them.

namespace hexagait::experiments {
namespace {

constexpr double kReach = 0.6;  // [m]

JudgedWalk well_walked(const std::string& group) {
  JudgedWalk walk{.group = group, .name = "", .simulation = {}, .max_lateral = 0.005};
  walk.simulation.trial.schedule = {{0.0, heading_control::Heading::straight(0.0)}};
  walk.simulation.trial.seconds = 40.0;
  walk.simulation.trial.distance = 5.0;
  walk.summary.seconds = 40.0;
  walk.summary.speed = 0.23;
  walk.summary.lateral_mean = 0.001;
  walk.summary.slip_p95 = 0.0001;
  walk.summary.tripod_after_steps = 4;
  walk.summary.arrived = true;
  return walk;
}

// Three walks that hold, each after a change of its own.
std::vector<JudgedWalk> three_walks(const std::string& group, auto change) {
  std::vector<JudgedWalk> walks(3, well_walked(group));
  for (JudgedWalk& walk : walks) change(walk.summary);
  return walks;
}

// Three walks that hold, and what the judge says once the second one is changed.
template <class Judge>
struct Bench {
  Judge judge;
  std::string word(auto change) const {
    std::vector<JudgedWalk> walks(3, well_walked("walk"));
    for (std::size_t k = 0; k < walks.size(); ++k)
      walks[k].summary.lateral_mean += 1e-6 * static_cast<double>(k);
    change(walks[1].summary);
    return judge(walks).word();
  }
  void holds_unless_it_falls_or_stops() const {
    EXPECT_EQ(word([](auto&) {}), "holds");
    EXPECT_EQ(word([](auto& s) { s.fell = true; }), "FAILS");
    EXPECT_EQ(word([](auto& s) { s.fault = footstep_gen::Fault::emergency_stop; }), "FAILS");
  }
};
template <class Judge>
Bench(Judge) -> Bench<Judge>;  // clang 14 doesn't deduce it of an aggregate

const auto judge_ten = [](const auto& walks) { return judge_headings(walks, kReach); };

TEST(JudgeHeadings, FailsARobotThatFallsStopsOrFreezesInAnyHeading) {
  const Bench bench{judge_ten};
  bench.holds_unless_it_falls_or_stops();
  EXPECT_EQ(bench.word([](auto& s) { s.stuck = true; }), "FAILS");
  EXPECT_EQ(bench.word([](auto& s) { s.seconds = 12.0; }), "FAILS");
  EXPECT_EQ(bench.word([](auto& s) { s.speed = 0.0; }), "FAILS") << "it froze";
}

TEST(JudgeHeadings, TakesASpinForMotion) {
  EXPECT_EQ(Bench{judge_ten}.word([](auto& s) {
    s.speed = 0.0;
    s.turned = -12.5;  // 0.31 rad/s at 0.6 m: 0.19 m/s
  }),
            "holds");
}

TEST(JudgeHeadings, FailsWhatIsOffThePathSlipsOrLosesContact) {
  const Bench bench{judge_ten};
  EXPECT_EQ(bench.word([](auto& s) { s.lateral_mean = 0.006; }), "FAILS");
  EXPECT_EQ(bench.word([](auto& s) { s.slip_p95 = 0.001; }), "FAILS");
  EXPECT_EQ(bench.word([](auto& s) { s.slip_p95 = std::nan(""); }), "FAILS") << "not measured";
  EXPECT_EQ(bench.word([](auto& s) { s.contact_losses = 1; }), "FAILS");
  EXPECT_EQ(bench.word([](auto& s) { s.neighbour_flight = 0.002; }), "FAILS");
}

TEST(JudgePostures, WantsTheTripodGaitSoonFromEveryStart) {
  const Bench bench{judge_postures};
  bench.holds_unless_it_falls_or_stops();
  EXPECT_EQ(bench.word([](auto& s) { s.tripod_after_steps = 26; }), "FAILS");
  EXPECT_EQ(bench.word([](auto& s) { s.tripod_after_steps = std::nullopt; }), "FAILS");
  EXPECT_EQ(bench.word([](auto& s) { s.stuck = true; }), "FAILS");
}

TEST(JudgeCommands, WantsNoFallNoViolationAndTheWholeTime) {
  const Bench bench{judge_commands};
  bench.holds_unless_it_falls_or_stops();
  EXPECT_EQ(bench.word([](auto& s) { s.rule1_violations = 1; }), "holds");
  EXPECT_EQ(bench.word([](auto& s) { s.rule1_violations = 2; }), "FAILS");
  EXPECT_EQ(bench.word([](auto& s) { s.stuck = true; }), "FAILS");
  EXPECT_EQ(bench.word([](auto& s) { s.seconds = 10.0; }), "FAILS");
}

// Off the path as far as is known, neither more nor less, and inside of the feet.
TEST(JudgeSharpChanges, KnowsHowFarItLeavesThePath) {
  const auto word = [](auto change) {
    std::vector<JudgedWalk> walks = three_walks("sharp change", [](auto& s) {
      s.lateral_max = 0.035;
      s.margin_min = -0.05;
      s.neighbour_flight = 0.1;
    });
    change(walks[1].summary);
    return judge_sharp_changes(walks).word();
  };
  EXPECT_EQ(word([](auto&) {}), "as expected, does not hold");
  EXPECT_EQ(word([](auto& s) { s.fell = true; }), "FAILS");
  EXPECT_EQ(word([](auto& s) { s.stuck = true; }), "FAILS");
  EXPECT_EQ(word([](auto& s) { s.lateral_max = 0.05; }), "FAILS");
  EXPECT_EQ(word([](auto& s) { s.margin_min = -0.31; }), "FAILS") << "outside its band";
  EXPECT_EQ(word([](auto& s) { s.neighbour_flight = 0.6; }), "FAILS") << "outside its band";
}

TEST(JudgeTerrain, WantsAllToArriveNearThePath) {
  const Bench bench{judge_terrain};
  bench.holds_unless_it_falls_or_stops();
  EXPECT_EQ(bench.word([](auto& s) { s.arrived = false; }), "FAILS");
  EXPECT_EQ(bench.word([](auto& s) { s.lateral_mean = 0.2; }), "FAILS");
}

TEST(JudgePlant, WantsAllToArriveWithoutAFall) {
  const Bench bench{judge_plant};
  bench.holds_unless_it_falls_or_stops();
  EXPECT_EQ(bench.word([](auto& s) { s.arrived = false; }), "FAILS");
}

TEST(JudgeRealPlant, WantsNearlyAllToArriveAndNoFault) {
  const Bench bench{judge_real_plant};
  bench.holds_unless_it_falls_or_stops();
  EXPECT_EQ(bench.word([](auto& s) { s.arrived = false; }), "FAILS");
}

// Flights and lost contacts are expected as many as they are: neither more nor less goes unnoticed.
TEST(JudgeFirstWalk, WantsThePathAndAccountsForFlightsAndLosses) {
  const auto word = [](auto change) {
    return judge_first_walk(three_walks("first walk",
                                        [&](auto& s) {
                                          s.steps = 50;
                                          s.neighbour_flight = 0.3;
                                          s.real_contact_losses = 2;
                                          change(s);
                                        }))
        .word();
  };
  EXPECT_EQ(word([](auto&) {}), "as expected, does not hold");
  EXPECT_EQ(word([](auto& s) { s.fell = true; }), "FAILS");
  EXPECT_EQ(word([](auto& s) { s.stuck = true; }), "FAILS");
  EXPECT_EQ(word([](auto& s) { s.lateral_mean = 0.031; }), "FAILS");
  EXPECT_EQ(word([](auto& s) { s.neighbour_flight = 0.7; }), "FAILS");
  EXPECT_EQ(word([](auto& s) { s.neighbour_flight = 0.05; }), "FAILS") << "unexpectedly";
  EXPECT_EQ(word([](auto& s) { s.real_contact_losses = 6; }), "FAILS");
  EXPECT_EQ(word([](auto& s) { s.contact_losses = 40; }), "as expected, does not hold")
      << "bounces";
}

}  // namespace
}  // namespace hexagait::experiments

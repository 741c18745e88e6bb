// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <hexagait/walk/referee/detail/hand_made_walk.hpp>
#include <utility>

namespace hexagait::walk {
namespace {

using testing::kDt;

using heading_control::Heading;
using heading_control::Turn;

// Lifts of legs together, a group every 0.8 s.
std::vector<TimedLift> lifts_of(const std::vector<std::vector<LegId>>& groups,
                                double spread = 0.0) {
  std::vector<TimedLift> lifts;
  double time = 0.0;
  for (const std::vector<LegId>& group : groups) {
    for (std::size_t k = 0; k < group.size(); ++k)
      lifts.push_back({group[k], time + spread * static_cast<double>(k) / 2.0});
    time += 0.8;
  }
  return lifts;
}

const std::vector<LegId> kFirst = {0, 3, 4}, kSecond = {1, 2, 5};

TEST(FirstTripodGait, IsAtOnceWhenTripodsAlternateFromTheStart) {
  EXPECT_EQ(first_tripod_gait(lifts_of({kFirst, kSecond, kFirst, kSecond}), 6, 0.8), 0);
  EXPECT_EQ(first_tripod_gait(lifts_of({kSecond, kFirst, kSecond, kFirst}), 6, 0.8), 0);
}

// In a different order within the group it is the same tripod.
TEST(FirstTripodGait, DoesNotMindTheOrderWithinATripod) {
  EXPECT_EQ(first_tripod_gait(lifts_of({{4, 0, 3}, {5, 1, 2}, {3, 4, 0}, kSecond}), 6, 0.8), 0);
}

TEST(FirstTripodGait, CountsTheLiftsBefore) {
  EXPECT_EQ(first_tripod_gait(lifts_of({{2}, {5, 0}, kFirst, kSecond, kFirst, kSecond}), 6, 0.8),
            3);
}

TEST(FirstTripodGait, NeedsFourGroupsInARow) {
  EXPECT_EQ(first_tripod_gait({}, 6, 0.8), std::nullopt);
  EXPECT_EQ(first_tripod_gait(lifts_of({kFirst, kSecond, kFirst}), 6, 0.8), std::nullopt);
  EXPECT_EQ(first_tripod_gait(lifts_of({kFirst, kSecond, kFirst, {0, 1, 2}}), 6, 0.8),
            std::nullopt);
  EXPECT_EQ(first_tripod_gait(lifts_of({kFirst, kSecond, {0, 3}, kSecond, kFirst}), 6, 0.8),
            std::nullopt);
}

TEST(FirstTripodGait, NeedsTheTripodsToAlternate) {
  EXPECT_EQ(first_tripod_gait(lifts_of({kFirst, kFirst, kSecond, kFirst}), 6, 0.8), std::nullopt);
}

// A group's lifts span `spread`; 20 % of the step time of 0.8 s is 0.16 s.
TEST(FirstTripodGait, NeedsTripodsToLiftTogether) {
  const std::vector<std::vector<LegId>> groups = {kFirst, kSecond, kFirst, kSecond};
  EXPECT_EQ(first_tripod_gait(lifts_of(groups, 0.15), 6, 0.8), 0);
  EXPECT_EQ(first_tripod_gait(lifts_of(groups, 0.17), 6, 0.8), std::nullopt);
}

TEST(Percentile, IsTheNearestRank) {
  const std::vector<double> values = {5.0, 1.0, 4.0, 2.0, 3.0};
  EXPECT_EQ(percentile(values, 0.0), 1.0);
  EXPECT_EQ(percentile(values, 0.2), 1.0);
  EXPECT_EQ(percentile(values, 0.5), 3.0);
  EXPECT_EQ(percentile(values, 0.81), 5.0);
  EXPECT_EQ(percentile(values, 1.0), 5.0);
  EXPECT_TRUE(std::isnan(percentile({}, 0.5))) << "nothing was measured";
}

// 100 ticks at 1 mm, then 100 at 3 mm to the right: mean 2 mm, max and end 3 mm; 0.4 m in 0.4 s.
TEST(Referee, AveragesTheDistanceFromTheCommandedLine) {
  HandMadeWalk walk;
  for (int k = 1; k <= 200; ++k) {
    walk.truth.X_WB.p = {0.002 * k, k <= 100 ? -0.001 : -0.003, 0.3};
    walk.tick();
  }
  const Summary s = walk.referee.summary();
  EXPECT_NEAR(s.lateral_mean, 0.002, 1e-12);
  EXPECT_NEAR(s.lateral_max, 0.003, 1e-12);
  EXPECT_NEAR(s.lateral_end, 0.003, 1e-12);
  EXPECT_NEAR(s.distance, 0.4, 1e-12);
  EXPECT_NEAR(s.speed, 1.0, 1e-9);
  EXPECT_NEAR(walk.referee.deviation().lateral, -0.003, 1e-12);
}

// 30 J before the walk do not count; then 120 J for 2 m with 20 kg: 120/(20 · 9.81 · 2) = 0.3058.
TEST(Referee, DividesTheWorkByWeightAndWay) {
  HandMadeWalk unknown;
  unknown.truth.X_WB.p.x() = 1.0;
  unknown.tick();
  EXPECT_TRUE(std::isnan(unknown.referee.summary().cost_of_transport)) << "the world tells none";

  RobotModel model = HandMadeWalk::six_legs();
  model.mass = 20.0;
  HandMadeWalk walk;
  walk.truth.work = 30.0;
  Referee referee(model, walk.truth, kDt, testing::round_params().referee);
  referee.observe(walk.record, walk.truth);
  EXPECT_TRUE(std::isnan(referee.summary().cost_of_transport)) << "without way";
  walk.truth.X_WB.p.x() = 2.0;
  walk.truth.work = 150.0;
  referee.observe(walk.record, walk.truth);
  EXPECT_NEAR(referee.summary().cost_of_transport, 0.3058, 1e-4);
}

// 1 m ahead, then 0.5 m crabbing to the left: 1.5 m of path, and not the metre that backing up to
// the first line's start would take off.
TEST(Referee, AddsUpTheDistanceOfAllCommands) {
  HandMadeWalk walk;
  walk.truth.X_WB.p.x() = 1.0;
  walk.tick();
  walk.record.heading = Heading::straight(std::numbers::pi / 2.0);
  walk.truth.X_WB.p.y() = 0.5;
  walk.tick();
  EXPECT_NEAR(walk.referee.distance(), 1.5, 1e-12);
}

// Half a turn in steps of 0.01 rad, past ±π: the turn is counted on.
TEST(Referee, CountsTheTurnThroughThePointWhereYawWraps) {
  HandMadeWalk walk({3.0, {0.0, 0.0}});
  walk.record.heading = Heading::spin(Turn::ccw);
  for (int k = 1; k <= 300; ++k) {
    walk.truth.X_WB.R = rotation_z(3.0 + 0.01 * k);
    walk.tick();
  }
  EXPECT_NEAR(walk.referee.summary().turned, 3.0, 1e-9);
  EXPECT_EQ(walk.referee.summary().heading_max, 0.0);
}

// Odometry starts at the truth's start. Here at (1, 0) facing +y: odometry's 2 m ahead with 0.1 rad
// is (1, 2) in the world, the truth 3 cm beyond with no turn.
TEST(Referee, ComparesOdometryFromTheSameStart) {
  HandMadeWalk walk({std::numbers::pi / 2.0, {1.0, 0.0}});
  walk.truth.X_WB.p = {1.0, 2.03, 0.3};
  walk.record.state.X_OB = {rotation_z(0.1), {2.0, 0.0, 0.3}};
  walk.tick();
  EXPECT_NEAR(walk.referee.summary().odometry_position, 0.03, 1e-9);
  EXPECT_NEAR(walk.referee.summary().odometry_heading, 0.1, 1e-9);
}

// The feet span ±0.4 by ±0.5 m. A centre of mass 0.1 m to the left of the middle is 0.4 m from
// either of the nearest edges; with the left middle foot gone nothing changes, with all left feet
// gone it is 0.6 m outside of the line of the right ones.
TEST(Referee, MeasuresTheMarginInTheTrueSupportPolygon) {
  HandMadeWalk walk;
  walk.truth.X_WB.p.y() = 0.1;
  walk.tick();
  EXPECT_NEAR(walk.referee.summary().margin_min, 0.4, 1e-12);
  for (const LegId leg : {0, 2, 4}) walk.truth.feet[leg].in_contact = false;
  walk.tick();
  EXPECT_NEAR(walk.referee.summary().margin_min, -0.6, 1e-12);
}

TEST(Referee, RemembersTheExtremesOfPosture) {
  HandMadeWalk walk;
  walk.truth.X_WB = {rotation({-0.2, 0.0, 0.0}), {0.0, 0.0, 0.25}};
  walk.tick();
  walk.truth.X_WB = {rotation({0.0, 0.1, 0.0}), {0.0, 0.0, 0.35}};
  walk.tick();
  const Summary s = walk.referee.summary();
  EXPECT_NEAR(s.roll_max, 0.2, 1e-12);
  EXPECT_NEAR(s.pitch_max, 0.1, 1e-12);
  EXPECT_NEAR(s.height_min, 0.25, 1e-12);
  EXPECT_NEAR(s.height_max, 0.35, 1e-12);
  EXPECT_FALSE(s.fell);
}

TEST(Referee, SeesAFall) {
  HandMadeWalk touching, tilted, upright, exploded;
  touching.truth.base_touches_ground = true;
  tilted.truth.X_WB.R = rotation({0.0, 1.06, 0.0});
  upright.truth.X_WB.R = rotation({1.03, 0.0, 0.0});
  exploded.truth.finite = false;
  for (HandMadeWalk* walk : {&touching, &tilted, &upright, &exploded}) walk->tick();
  EXPECT_TRUE(touching.referee.fell());
  EXPECT_TRUE(tilted.referee.fell());
  EXPECT_FALSE(upright.referee.fell());
  EXPECT_TRUE(exploded.referee.fell());
}

TEST(Referee, CallsTenSecondsWithoutProgressStuck) {
  HandMadeWalk walk;
  walk.tick(4990);
  EXPECT_FALSE(walk.referee.stuck());
  walk.tick(20);
  EXPECT_TRUE(walk.referee.stuck());
}

// At a cliff a foot stands again and again between its tries.
TEST(Referee, NamesTheLegThatFoundNoGround) {
  HandMadeWalk walk;
  for (int k = 0; k < 100; ++k) walk.tick();
  for (int k = 0; !walk.referee.summary().stuck && k < 10000; ++k) {
    walk.record.legs[2].found_no_ground = k % 500 == 0;
    walk.tick();
  }
  const Hindrance why = walk.referee.summary().hindrance;
  EXPECT_EQ(why.leg, 2);
  EXPECT_GT(why.no_ground, 1);
  EXPECT_NE(cause_in_words(why, HandMadeWalk::six_legs()).find("no ground"), std::string::npos);
}

// Whatever phase the last tick found it in; one that touches for an instant and is not confirmed does not stand.
TEST(Referee, SaysThatALegIsOffTheGroundOrDoesNotStep) {
  for (const LegPhase last : {LegPhase::lift, LegPhase::support}) {
    HandMadeWalk walk;
    walk.record.legs[2].phase = last;
    walk.record.legs[2].confirmed = false;
    walk.record.legs[2].retreats = 1;
    for (int k = 0; !walk.referee.summary().stuck && k < 10000; ++k) walk.tick();
    EXPECT_THAT(cause_in_words(walk.referee.summary().hindrance, HandMadeWalk::six_legs()),
                ::testing::MatchesRegex(
                    "leg .* has been off the ground for 10.0 s, after a try that failed: .*"));
  }
  HandMadeWalk all_stand;
  for (int k = 0; !all_stand.referee.summary().stuck && k < 10000; ++k) all_stand.tick();
  EXPECT_THAT(cause_in_words(all_stand.referee.summary().hindrance, HandMadeWalk::six_legs()),
              ::testing::MatchesRegex("leg .* has not stepped for .* s: a neighbour .*"));
}

TEST(Referee, SaysHowTheRobotFell) {
  HandMadeWalk hit, toppled;
  hit.tick(10);
  hit.truth.X_WB.R = rotation(Vector3(0.0, 0.05, 0.0));
  hit.truth.base_touches_ground = true;
  hit.tick();
  hit.truth.X_WB.R = rotation(Vector3(0.0, 0.5, 0.0));
  hit.tick();
  EXPECT_EQ(fall_in_words(hit.referee.summary()), "its body touched the ground, tilted by 3°")
      << "as it was at first";
  toppled.truth.X_WB.R = rotation(Vector3(-1.1, 0.0, 0.0));
  toppled.tick();
  EXPECT_EQ(fall_in_words(toppled.referee.summary()), "its body tilted by 63°");
  HandMadeWalk stands;
  stands.tick();
  EXPECT_TRUE(std::isnan(stands.referee.summary().fall_tilt));
}

TEST(Referee, SaysForHowLongTheGroundWasVeryRough) {
  HandMadeWalk walk;
  walk.tick(100);
  EXPECT_TRUE(found_in_words(walk.referee.summary(), HandMadeWalk::six_legs()).empty());
  walk.record.very_rough = true;
  walk.tick(700);
  walk.record.very_rough = false;
  walk.tick(100);
  EXPECT_THAT(found_in_words(walk.referee.summary(), HandMadeWalk::six_legs()),
              ::testing::ElementsAre(::testing::HasSubstr("for 1.4 s: the free gait is a wave")));
}

TEST(Referee, DoesNotCallProgressOrATurnOrARestStuck) {
  HandMadeWalk slow, turning, resting;
  turning.record.heading = Heading::spin(Turn::cw);
  resting.record.heading = Heading::stop();
  for (int k = 0; k < 5500; ++k) {
    slow.truth.X_WB.p.x() = 0.006 * kDt * k;
    turning.truth.X_WB.R = rotation_z(-0.01 * kDt * k);
    for (HandMadeWalk* walk : {&slow, &turning, &resting}) walk->tick();
  }
  EXPECT_FALSE(slow.referee.stuck());
  EXPECT_FALSE(turning.referee.stuck());
  EXPECT_FALSE(resting.referee.stuck());
}

// Two and a half times round, 0.2 rad/s for 80 s: half a turn is no limit to progress.
TEST(Referee, DoesNotCallATurnOfSeveralLapsStuck) {
  HandMadeWalk turning;
  turning.record.heading = Heading::spin(Turn::ccw);
  for (int k = 0; k < 40000; ++k) {
    turning.truth.X_WB.R = rotation_z(0.2 * kDt * k);
    turning.tick();
  }
  EXPECT_FALSE(turning.referee.stuck());
}

// 50 cm to the right of its line it is to go to the left, along a curve that begins on the line: it is
// behind the beginning, and makes progress all the same, 1 cm/s for 15 s.
TEST(Referee, DoesNotCallARobotStuckThatBeginsBehindTheNextCurve) {
  HandMadeWalk walk;
  walk.truth.X_WB.p.y() = -0.5;
  walk.tick();
  walk.record.heading = Heading::straight(0.5 * std::numbers::pi);
  for (int k = 0; k < 7500; ++k) {
    walk.truth.X_WB.p.y() = -0.5 + 0.01 * kDt * k;
    walk.tick();
  }
  EXPECT_FALSE(walk.referee.stuck());
  walk.tick(5500);
  EXPECT_TRUE(walk.referee.stuck()) << "now it stands";
}

// Odometry may take it beside its path, where it gets on all the same: 1 cm/s across it for 30 s.
TEST(Referee, CallsARobotOnAPathStuckOnlyIfItStands) {
  const path_following::PathTask line = {
      path_following::Path({{{0.0, 0.0}}, {{5.0, 0.0}}}, path_following::Shape::lines, false),
      {},
      1,
      0.2};
  HandMadeWalk walk;
  walk.referee.follow(line);
  walk.record.heading = Heading::straight(0.0);
  for (int k = 0; k < 15'000; ++k) {
    walk.truth.X_WB.p = {0.0, 0.01 * kDt * k, 0.3};
    walk.tick();
  }
  EXPECT_FALSE(walk.referee.stuck());
  for (int k = 0; k < 5500; ++k) {  // it rocks by 4 cm
    walk.truth.X_WB.p.x() = 0.02 * std::sin(0.01 * k);
    walk.tick();
  }
  EXPECT_TRUE(walk.referee.stuck());
}

// Rocking by 4 cm is no progress.
TEST(Referee, CallsARobotThatOnlyRocksStuck) {
  HandMadeWalk rocking;
  for (int k = 0; k < 5500; ++k) {
    rocking.truth.X_WB.p.x() = 0.04 * std::sin(0.01 * k);
    rocking.tick();
  }
  EXPECT_TRUE(rocking.referee.stuck());
}

// One bit of one joint at one tick is another hash.
TEST(Referee, HashesEveryJointAtEveryTick) {
  HandMadeWalk a, b, c;
  c.record.measurement.q[5].z() = std::nextafter(0.0, 1.0);
  for (HandMadeWalk* walk : {&a, &b, &c}) walk->tick();
  EXPECT_EQ(a.referee.summary().state_hash, b.referee.summary().state_hash);
  EXPECT_NE(a.referee.summary().state_hash, c.referee.summary().state_hash);
}

}  // namespace
}  // namespace hexagait::walk

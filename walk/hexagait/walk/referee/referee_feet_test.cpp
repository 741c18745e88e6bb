// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/walk/referee/detail/hand_made_walk.hpp>
#include <utility>

// What the referee sees of the feet: slip, contact, rule 1.
namespace hexagait::walk {
namespace {

using testing::kDt;

// 26 ticks are 52 ms: a foot that is off the ground for so long does not stand any more.
constexpr int kFlight = 26;

// Leg 2 slides 4 mm in its first stance. In the air the slip integral stands still. In the second
// stance it slides (3, 4) mm, so 5 mm. The five others stand, without slip: (4 + 5)/7 on average.
TEST(Referee, MeasuresTheSlipOfEachStance) {
  HandMadeWalk walk;
  EXPECT_EQ(walk.referee.summary().stances, 6) << "they have begun";
  walk.truth.feet[2].slip = {0.004, 0.0, 0.0};
  walk.tick();
  walk.lift(2);
  walk.tick(kFlight);
  EXPECT_EQ(walk.referee.summary().stances, 6);
  EXPECT_NEAR(walk.referee.summary().slip_mean, 0.004 / 6, 1e-12);
  walk.land(2);
  walk.tick(10);
  walk.truth.feet[2].slip += Vector3(0.003, 0.004, 0.0);
  walk.tick();
  walk.lift(2);
  walk.tick(kFlight);
  EXPECT_EQ(walk.referee.summary().stances, 7);
  EXPECT_NEAR(walk.referee.summary().slip_mean, 0.009 / 7, 1e-12);
  EXPECT_NEAR(walk.referee.summary().slip_p95, 0.005, 1e-12);
}

// A foot slides 2 mm when it touches, before its leg is told that it stands.
TEST(Referee, CountsTheSlipFromTheFirstTouchOn) {
  HandMadeWalk walk;
  walk.lift(2);
  walk.tick(kFlight);
  walk.truth.feet[2].in_contact = true;
  walk.truth.feet[2].slip = {0.002, 0.0, 0.0};
  walk.tick();
  walk.land(2);
  walk.tick(10);
  walk.lift(2);
  walk.tick(kFlight);
  EXPECT_NEAR(walk.referee.summary().slip_p95, 0.002, 1e-12);
}

// It slides while the walk ends, in a stance that has not ended.
TEST(Referee, CountsTheSlipOfStancesThatHaveNotEnded) {
  HandMadeWalk walk;
  walk.truth.feet[5].slip = {0.0, 0.006, 0.0};
  walk.tick();
  EXPECT_EQ(walk.referee.summary().stances, 6);
  EXPECT_NEAR(walk.referee.summary().slip_mean, 0.001, 1e-12);
}

// A foot that bounces at touchdown, for 10 ms, slides in one stance, not in two.
TEST(Referee, TakesABounceForPartOfTheStance) {
  HandMadeWalk walk;
  walk.lift(2);
  walk.tick(kFlight);
  walk.land(2);
  walk.truth.feet[2].slip.x() += 0.001;
  walk.tick();
  walk.truth.feet[2].in_contact = false;
  walk.tick(5);
  walk.truth.feet[2].in_contact = true;
  walk.truth.feet[2].slip.x() += 0.001;
  walk.tick();
  EXPECT_EQ(walk.referee.summary().stances, 7);
  EXPECT_NEAR(walk.referee.summary().slip_p95, 0.002, 1e-12);
}

// A leg that has been told to lift, but still touches, still slides.
TEST(Referee, CountsTheSlipWhileAFootIsDraggedOffTheGround) {
  HandMadeWalk walk;
  walk.tick();
  walk.lift(2);
  walk.truth.feet[2].in_contact = true;
  walk.tick();
  walk.truth.feet[2].slip = {0.0, 0.002, 0.0};
  walk.tick();
  walk.truth.feet[2].in_contact = false;
  walk.tick(kFlight);
  EXPECT_NEAR(walk.referee.summary().slip_p95, 0.002, 1e-12);
}

// Feet come down at 0.1, 0.2 … 0.6 m/s and stop at the ground. What stands at first has not come down.
TEST(Referee, TellsHowFastFeetTouchDown) {
  HandMadeWalk walk;
  EXPECT_TRUE(std::isnan(walk.referee.summary().touchdown_p95));
  for (LegId i = 0; i < 6; ++i) {
    walk.lift(i);
    walk.tick(kFlight);
    const double z = walk.truth.feet[i].p_WF.z(), way = 0.1 * (i + 1) * kDt;
    walk.truth.feet[i].p_WF.z() = z + 2.0 * way;
    walk.tick();
    walk.truth.feet[i].p_WF.z() = z + way;
    walk.tick();
    walk.truth.feet[i].p_WF.z() = z;
    walk.land(i);
    walk.tick(3);
  }
  const Summary s = walk.referee.summary();
  EXPECT_NEAR(s.touchdown_median, 0.3, 1e-9);
  EXPECT_NEAR(s.touchdown_p95, 0.6, 1e-9);
}

// A foot that bounces at touchdown has touched down once.
TEST(Referee, TakesNoBounceForATouchdown) {
  HandMadeWalk walk;
  walk.lift(2);
  walk.tick(kFlight);
  walk.land(2);
  walk.tick();
  walk.truth.feet[2].in_contact = false;
  walk.truth.feet[2].p_WF.z() += 0.001;
  walk.tick(2);
  walk.truth.feet[2].p_WF.z() -= 0.001;
  walk.tick();
  walk.truth.feet[2].in_contact = true;
  walk.tick();
  EXPECT_DOUBLE_EQ(walk.referee.summary().touchdown_p95, 0.0);
}

TEST(Referee, HasNoSlipOfFeetThatNeverTouch) {
  HandMadeWalk walk;
  for (LegId i = 0; i < 6; ++i) walk.lift(i);
  walk.tick(kFlight);
  const Summary s = Referee(walk.model, walk.truth, kDt, testing::round_params().referee).summary();
  EXPECT_EQ(s.stances, 0);
  EXPECT_TRUE(std::isnan(s.slip_mean));
  EXPECT_TRUE(std::isnan(s.slip_p95));
}

TEST(Referee, TimesLegsThatTouchTheGround) {
  HandMadeWalk walk;
  walk.tick(5);
  walk.truth.leg_touches_ground = true;
  walk.tick(50);
  EXPECT_NEAR(walk.referee.summary().leg_touch_time, 50 * kDt, 1e-12);
  EXPECT_FALSE(walk.referee.fell());
}

// The ring is 0 1 3 5 4 2: legs 0 and 2 are neighbours, 0 and 3 are not.
TEST(Referee, TimesTheFlightOfNeighbours) {
  HandMadeWalk walk;
  walk.lift(0);
  walk.lift(3);
  walk.tick(50);
  EXPECT_EQ(walk.referee.summary().neighbour_flight, 0.0);
  walk.land(3);
  walk.truth.feet[2].in_contact = false;
  walk.tick(50);
  EXPECT_NEAR(walk.referee.summary().neighbour_flight, 50 * kDt, 1e-12);
}

// Legs 0 and 3 are no neighbours; 1 is one of both.
TEST(Referee, CountsLiftsBesideALegThatIsOffTheGroundAsViolationsOfRule1) {
  HandMadeWalk walk;
  walk.lift(0);
  walk.lift(3);
  walk.tick(2);
  EXPECT_EQ(walk.referee.summary().rule1_violations, 0);
  walk.lift(1);
  walk.tick(2);
  EXPECT_EQ(walk.referee.summary().steps, 3);
  EXPECT_EQ(walk.referee.summary().rule1_violations, 1);
}

// The controller takes leg 2 for support and sees no violation; in truth its foot is in the air.
TEST(Referee, DoesNotAskTheControllerWhetherItBrokeRule1) {
  HandMadeWalk walk;
  walk.truth.feet[2].in_contact = false;
  walk.lift(0);
  walk.tick();
  EXPECT_EQ(walk.referee.summary().rule1_violations, 1);

  HandMadeWalk confessing;
  confessing.lift(0);
  confessing.record.rule1_violations.insert(0);
  confessing.tick();
  EXPECT_EQ(confessing.referee.summary().rule1_violations, 0);
}

// Both still touch when they are told to lift.
TEST(Referee, CountsNeighboursThatAreLiftedTogether) {
  HandMadeWalk walk;
  for (const LegId leg : {0, 2}) {
    walk.lift(leg);
    walk.truth.feet[leg].in_contact = true;
  }
  walk.tick();
  EXPECT_EQ(walk.referee.summary().rule1_violations, 2);
}

// A loss counts once, however long; the first 20 ms of a stance do not count.
TEST(Referee, CountsEachLossOfContactOnce) {
  HandMadeWalk walk;
  walk.truth.feet[4].in_contact = false;
  walk.tick(9);
  EXPECT_EQ(walk.referee.summary().contact_losses, 0);
  walk.truth.feet[4].in_contact = true;
  walk.tick(20);
  for (int k = 0; k < 2; ++k) {
    walk.truth.feet[4].in_contact = false;
    walk.tick(30);
    walk.truth.feet[4].in_contact = true;
    walk.tick(30);
  }
  EXPECT_EQ(walk.referee.summary().contact_losses, 2);
}

// Of losses, 10 ticks of 2 ms in place are a bounce; 11 are none, nor is a tick in which the
// foot goes 6 mm; 4 mm are.
TEST(Referee, ALossOfContactIsRealIfItLastsOrGoesFar) {
  HandMadeWalk walk;
  walk.tick(20);
  const auto lose = [&walk](int ticks, double distance) {
    FootTruth& foot = walk.truth.feet[4];
    foot.in_contact = false;
    foot.p_WF.z() -= distance;
    walk.tick(ticks);
    foot.in_contact = true;
    foot.p_WF.z() += distance;
    walk.tick(5);
    return std::pair(walk.referee.summary().contact_losses,
                     walk.referee.summary().real_contact_losses);
  };
  walk.land(4);
  walk.tick(20);
  walk.record.legs[4].confirmed = true;
  EXPECT_EQ(lose(10, 0.0), std::pair(1, 0));
  EXPECT_EQ(lose(11, 0.0), std::pair(2, 1));
  EXPECT_EQ(lose(1, 0.006), std::pair(3, 2));
  EXPECT_EQ(lose(1, 0.004), std::pair(4, 2));
  EXPECT_EQ(lose(100, 0.1), std::pair(5, 3));
}

}  // namespace
}  // namespace hexagait::walk

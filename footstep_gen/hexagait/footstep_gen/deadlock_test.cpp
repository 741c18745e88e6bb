// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/footstep_gen/deadlock.hpp>
#include <hexagait/footstep_gen/walker.hpp>
#include <testing/argos.hpp>
#include <testing/control_period.hpp>
#include <testing/kinematic_plant.hpp>

namespace hexagait::footstep_gen {
namespace {

using heading_control::Heading;
using hexagait::testing::argos;
using hexagait::testing::kDt;

constexpr LegId kRightFront = 1, kLeftFront = 0, kRightMiddle = 3;

// Argos, which walks straight on, with all feet displaced from their centres.
DeadlockInput standing(const Vector3& off) {
  const int n = argos().num_legs();
  DeadlockInput in;
  in.walks = true;
  in.path.v = {1.0, 0.0};
  in.p_BC = nominal_stance(argos()).p_BC;
  in.p_BF = in.p_BC;
  for (Vector3& p_BF : in.p_BF) p_BF += off;
  in.standing = LegSet::all(n);
  in.progress = 0.1;
  in.patience = 2.0;
  in.arm = 0.6;
  return in;
}

Escape after(Deadlock& deadlock, DeadlockInput& in, double seconds) {
  in.time += seconds;
  return deadlock.update(in);
}

TEST(Deadlock, IsARobotThatDoesNotGetOnForLongEnough) {
  Deadlock deadlock;
  DeadlockInput in = standing(Vector3(0.0, 0.04, 0.0));
  EXPECT_EQ(deadlock.update(in).phase, EscapePhase::none);
  EXPECT_EQ(after(deadlock, in, 1.9).phase, EscapePhase::none);
  in.X_OB.p.x() = 0.11;  // it has got on
  EXPECT_EQ(after(deadlock, in, 0.2).phase, EscapePhase::none);
  EXPECT_EQ(after(deadlock, in, 1.9).phase, EscapePhase::none);
  in.X_OB.p.x() = 0.20;  // less than progress
  EXPECT_EQ(after(deadlock, in, 0.2).phase, EscapePhase::moves);
}

TEST(Deadlock, IsNoneOfARobotThatStands) {
  Deadlock deadlock;
  DeadlockInput in = standing(Vector3::Zero());
  in.walks = false;
  EXPECT_EQ(after(deadlock, in, 100.0).phase, EscapePhase::none);
  in.walks = true;
  EXPECT_EQ(after(deadlock, in, 100.0).phase, EscapePhase::none) << "it has just started";
}

// [PC04] 4: to the posture that fits the feet best; what it has gained along its path it keeps.
TEST(Deadlock, MovesTheBodyOverItsFeetButNotBack) {
  Deadlock deadlock;
  DeadlockInput in = standing(Vector3(-0.05, 0.04, 0.0));
  deadlock.update(in);
  const Escape escape = after(deadlock, in, 2.1);
  EXPECT_EQ(escape.phase, EscapePhase::moves);
  EXPECT_EQ(escape.tries, 1);
  EXPECT_LT((escape.way.v - Vector2(0.0, 0.04)).norm(), 1e-12);
  EXPECT_NEAR(escape.way.w, 0.0, 1e-12);

  in.X_OB.p.y() = 0.03;
  EXPECT_NEAR(after(deadlock, in, 0.1).left.v.y(), 0.01, 1e-12);
  in.X_OB.p.y() = 0.0399;
  const Escape there = after(deadlock, in, 0.1);
  EXPECT_EQ(there.phase, EscapePhase::steps);
  EXPECT_EQ(there.left.v.norm(), 0.0);
}

// A body that a standing foot keeps where it is does not wait for all of its patience. One that comes nearer does.
TEST(Deadlock, StepsFromWhereTheBodyCannotMoveOn) {
  Deadlock deadlock;
  DeadlockInput in = standing(Vector3(0.0, 0.2, 0.0));
  deadlock.update(in);
  EXPECT_EQ(after(deadlock, in, 2.1).phase, EscapePhase::moves);
  for (int k = 0; k < 5; ++k) {
    in.X_OB.p.y() += 0.011;
    EXPECT_EQ(after(deadlock, in, 0.29).phase, EscapePhase::moves) << k;
  }
  EXPECT_EQ(after(deadlock, in, 0.29).phase, EscapePhase::moves);
  EXPECT_EQ(after(deadlock, in, 0.02).phase, EscapePhase::steps);
}

TEST(Deadlock, LegsThatAreOffTheGroundDoNotMoveTheBody) {
  Deadlock deadlock;
  DeadlockInput in = standing(Vector3(0.0, 0.04, 0.0));
  in.p_BF[kRightFront].y() += 0.3;
  in.standing.erase(kRightFront);
  deadlock.update(in);
  EXPECT_NEAR(after(deadlock, in, 2.1).way.v.y(), 0.04, 1e-12);
}

// A leg without foothold lags the most. It would try again at once, and its neighbours never step.
TEST(Deadlock, NeighboursOfAFailingLegStepFirst) {
  Deadlock deadlock;
  DeadlockInput in = standing(Vector3::Zero());
  in.failing.insert(kRightFront);
  deadlock.update(in);
  EXPECT_EQ(after(deadlock, in, 2.1).phase, EscapePhase::moves);
  EXPECT_EQ(after(deadlock, in, 0.1).phase, EscapePhase::steps);
  for (const LegId leg : {kLeftFront, kRightMiddle}) {
    EXPECT_TRUE(after(deadlock, in, 0.1).held.contains(kRightFront)) << leg;
    in.standing.erase(leg);
    EXPECT_TRUE(after(deadlock, in, 0.1).held.contains(kRightFront)) << leg;
    in.standing.insert(leg);
  }
  // It steps again: neighbours that step in turn never stand all at once.
  in.standing.erase(kLeftFront);
  const Escape escape = after(deadlock, in, 0.1);
  EXPECT_EQ(escape.phase, EscapePhase::steps);
  EXPECT_TRUE(escape.held.empty());

  gait_state::GaitInput legs;
  legs.lag = LegArray<double>(6, 0.02);
  legs.lag[kRightFront] = 0.3;
  legs.urgent.insert(kRightFront);
  hold_back(legs, escape.held);
  EXPECT_EQ(legs.lag[kRightFront], 0.3) << "no longer held";
  Escape holds;
  holds.held.insert(kRightFront);
  hold_back(legs, holds.held);
  EXPECT_LT(legs.lag[kRightFront], 0.0);
  EXPECT_TRUE(legs.urgent.empty());
}

TEST(Deadlock, EndsWithProgress) {
  Deadlock deadlock;
  DeadlockInput in = standing(Vector3::Zero());
  deadlock.update(in);
  after(deadlock, in, 2.1);
  EXPECT_EQ(after(deadlock, in, 0.1).phase, EscapePhase::steps);
  in.X_OB.p.x() = 0.11;
  const Escape escape = after(deadlock, in, 0.1);
  EXPECT_EQ(escape.phase, EscapePhase::none);
  EXPECT_EQ(escape.tries, 0);
}

TEST(Deadlock, GivesUpAfterSomeTriesUntilTheCommandIsAnother) {
  Deadlock deadlock;
  DeadlockInput in = standing(Vector3::Zero());
  deadlock.update(in);
  Escape escape;
  for (int k = 0; k < 300; ++k) escape = after(deadlock, in, 0.1);
  EXPECT_EQ(escape.phase, EscapePhase::gave_up);
  EXPECT_EQ(escape.tries, Deadlock::kTries);
  BaseAutoCommand base;
  keep_out(base, escape);
  EXPECT_EQ(base.max_advance, 0.0);
  EXPECT_EQ(base.min_advance, 0.0);

  in.path.v = {0.95, 0.3};
  EXPECT_EQ(after(deadlock, in, 0.1).phase, EscapePhase::gave_up);
  in.path.v = {0.0, 1.0};
  EXPECT_EQ(after(deadlock, in, 0.1).phase, EscapePhase::none);
}

// 2 m deep, from 0.6 m to `end` ahead of the body's start, under the legs of the right side.
template <int end_cm>
double hole(const Vector2& p_O) {
  return p_O.x() > 0.6 && p_O.x() < 0.01 * end_cm && p_O.y() < 0.0 ? -2.0 : 0.0;
}

struct Result {
  double advance = 0.0;
  bool rule_1 = true;
  TickRecord last;
};

Result walk(double (*ground)(const Vector2&), bool resolves, double seconds) {
  WalkerParams params;
  params.resolves_deadlocks = resolves;
  Walker walker(argos(), params);
  testing::KinematicPlant plant(argos(), 0.0, {});
  plant.ground = ground;
  walker.start(plant.measurement);
  Result result;
  for (int k = 0; k < std::lround(seconds / kDt); ++k) {
    const TickRecord& record =
        walker.tick(PlantStatus::fresh, plant.measurement, Heading::straight(0.0));
    plant.follow(record, kDt);
    result.rule_1 = result.rule_1 && record.rule1_violations.empty();
  }
  result.advance = plant.X_OB.p.x();
  result.last = walker.record();
  return result;
}

// A leg of argos reaches 0.63 m. Without, the front leg tries for ever while its neighbours are at the end
// of their reach: they may not step beside a leg that is up.
TEST(DeadlockScene, AHoleUnderOneSideIsCrossedWithItAndNotWithout) {
  const Result without = walk(hole<100>, false, 120.0), with = walk(hole<100>, true, 60.0);
  EXPECT_LT(without.advance, 0.8) << "before the middle of the hole";
  EXPECT_GT(with.advance, 2.0);
  EXPECT_TRUE(with.rule_1);
  EXPECT_EQ(with.last.escape.phase, EscapePhase::none) << "it has left the hole behind";
  EXPECT_LT(with.last.deviation.v.norm(), 0.01) << "it is back on its path";
  EXPECT_LT(std::abs(with.last.deviation.w), 0.01);
}

TEST(DeadlockScene, WhereItCannotGoOnItStands) {
  const auto stands = [](double seconds) { return walk(hole<900>, true, seconds); };
  const Result before = stands(60.0), then = stands(70.0);
  EXPECT_EQ(before.last.escape.phase, EscapePhase::gave_up);
  EXPECT_TRUE(before.last.escape.failing.contains(kRightFront));
  EXPECT_NEAR(then.advance, before.advance, 1e-3);
  int standing = 0;
  for (const LegLane& lane : then.last.legs) standing += lane.phase == LegPhase::support ? 1 : 0;
  EXPECT_GE(standing, 5);
}

}  // namespace
}  // namespace hexagait::footstep_gen

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/balance/support_polygon.hpp>
#include <hexagait/footstep_gen/lift_gate.hpp>
#include <hexagait/sim/random.hpp>

namespace hexagait::footstep_gen {
namespace {

constexpr LegId kLeftFore = 0, kRightFore = 1, kLeftHind = 2;

/// A quadruped, its centre of mass over the crossing of its diagonals; all legs stand and may step.
LiftGateInput quadruped() {
  LiftGateInput in;
  in.feet = LegArray<Vector3>(4);
  in.lag = in.along = LegArray<double>(4, 0.0);
  for (LegId i = 0; i < 4; ++i) {
    in.feet[i] = {i < 2 ? 0.3 : -0.3, i % 2 == 0 ? 0.2 : -0.2, -0.4};
    in.along[i] = in.feet[i].x();
  }
  in.support = in.may_step = LegSet::all(4);
  in.margin = 0.03;
  return in;
}

double margin_without(const LiftGateInput& in, LegId leg, const Vector2& p_M) {
  LegSet rest = in.support;
  rest.erase(leg);
  return stability_margin(support_polygon(in.feet, rest), p_M);
}

// On the diagonal no leg may lift; after the sway that it asks for, the one that is next may.
TEST(LiftGate, OpensWhenTheCentreOfMassIsOverTheFeetThatStay) {
  LiftGateInput in = quadruped();
  LiftGate gate;
  const LiftGateDecision closed = gate.update(in);
  EXPECT_TRUE(closed.open.empty());
  EXPECT_EQ(gate.next, kLeftHind) << "a rear leg first, of equals";
  EXPECT_NEAR(closed.sway.norm(), 1.2 * in.margin, 1e-9);
  in.p_M += closed.sway;
  const LiftGateDecision open = gate.update(in);
  EXPECT_EQ(open.open, LegSet(1U << kLeftHind));
  EXPECT_GE(margin_without(in, kLeftHind, in.p_M), in.margin);
  EXPECT_NEAR(open.sway.norm(), 0.0, 1e-9);
}

// The least sway, of all places and polygons: none that is shorter brings the margin.
TEST(LiftGate, SwaysAsFarAsTheMarginAsks) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    RandomSequence random{.seed = seed};
    LiftGateInput in = quadruped();
    for (Vector3& foot : in.feet)
      foot += Vector3(random.uniform(-0.08, 0.08), random.uniform(-0.08, 0.08), 0.0);
    in.p_M = {random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1)};
    for (double& lag : in.lag) lag = random.uniform(0.0, 0.1);
    LiftGate gate;
    const LiftGateDecision decision = gate.update(in);
    ASSERT_GE(gate.next, 0) << seed;
    const double before = margin_without(in, gate.next, in.p_M);
    EXPECT_EQ(decision.open.contains(gate.next), before >= in.margin) << seed;
    EXPECT_GE(margin_without(in, gate.next, in.p_M + decision.sway), 1.2 * in.margin - 1e-4)
        << seed;
    const double least = std::max(0.0, 1.2 * in.margin - before);
    EXPECT_GE(decision.sway.norm(), least - 1e-9) << seed;
  }
}

// While one leg is in the air the others leave two feet behind.
TEST(LiftGate, LiftsOneLegOfFourAtATime) {
  LiftGateInput in = quadruped();
  in.support.erase(kLeftFore);
  LiftGate gate;
  const LiftGateDecision decision = gate.update(in);
  EXPECT_TRUE(decision.open.empty());
  EXPECT_EQ(gate.next, -1);
  EXPECT_EQ(decision.sway, Vector2::Zero());
}

// The base does not turn round because another leg falls back a little more.
TEST(LiftGate, KeepsTheLegThatIsNext) {
  LiftGateInput in = quadruped();
  LiftGate gate;
  in.lag[kRightFore] = 0.05;
  (void)gate.update(in);
  ASSERT_EQ(gate.next, kRightFore);
  in.lag[kLeftHind] = 0.06;
  (void)gate.update(in);
  EXPECT_EQ(gate.next, kRightFore);
  in.may_step.erase(kRightFore);
  (void)gate.update(in);
  EXPECT_EQ(gate.next, kLeftHind);
}

// The base neither moves back along its path nor goes on for it.
TEST(LiftGate, SwaysBesideTheAdvance) {
  BaseAutoCommand base;
  base.path.v = {1.0, 0.0};
  sway(base, {0.02, 0.03});
  EXPECT_EQ(base.sway, Vector2(0.02, 0.03));
  EXPECT_EQ(base.min_advance, 0.0);
  EXPECT_GT(base.max_advance, 0.0);
  base = {};
  base.path.v = {1.0, 0.0};
  sway(base, {-0.02, 0.03});
  EXPECT_EQ(base.max_advance, 0.0);
  base = {};
  base.path.v = {1.0, 0.0};
  sway(base, {0.0, 0.0});
  EXPECT_EQ(base.min_advance, 0.0)
      << "with a leg in the air the body would go off the feet that stay";
  EXPECT_GT(base.max_advance, 0.0);
}

TEST(LiftGate, IsForRobotsThatWouldStandOnTwoFeet) {
  EXPECT_TRUE(must_crawl(4));
  EXPECT_FALSE(must_crawl(5)) << "two may lift, three stay";
  EXPECT_FALSE(must_crawl(6));
}

constexpr LegId kRF = 1, kRR = 5, kLR = 4;

// Argos without its right middle leg; its right hind leg waits.
BalanceWaitInput five_legs() {
  BalanceWaitInput in;
  in.patience = 2.0;
  in.waits.insert(kRR);
  in.ring = {6, LegSet(1U << 3U)};
  in.support = in.ring.present();
  return in;
}

TEST(BalanceWait, HoldsALegThatWaitsInVainUntilBothNeighboursHaveStepped) {
  BalanceWaitInput in = five_legs();
  BalanceWait wait;
  in.time = 1.9;
  EXPECT_TRUE(wait.update(in).empty());
  in.time = 2.1;
  EXPECT_EQ(wait.update(in), LegSet(1U << kRR));
  in.waits = {};
  // One after the other: they need not stand at the same time.
  in.support.erase(kRF);
  EXPECT_EQ(wait.update(in), LegSet(1U << kRR));
  in.support.insert(kRF);
  in.support.erase(kLR);
  EXPECT_EQ(wait.update(in), LegSet(1U << kRR));
  in.support.insert(kLR);
  EXPECT_TRUE(wait.update(in).empty());
}

TEST(BalanceWait, CountsFromTheLastLift) {
  BalanceWaitInput in = five_legs();
  BalanceWait wait;
  in.time = 2.1;
  in.last_lift = 0.2;
  EXPECT_TRUE(wait.update(in).empty());
  in.time = 2.3;
  EXPECT_FALSE(wait.update(in).empty());
}

TEST(BalanceWait, NeverHoldsAllLegsThatStand) {
  BalanceWaitInput in = five_legs();
  BalanceWait wait;
  in.waits = in.ring.present();
  in.time = 2.1;
  EXPECT_TRUE(wait.update(in).empty());
}

TEST(BalanceWait, ForgetsALegThatIsLostMeanwhile) {
  BalanceWaitInput in = five_legs();
  BalanceWait wait;
  in.time = 2.1;
  EXPECT_FALSE(wait.update(in).empty());
  in.waits = {};
  in.ring.lost.insert(kRR);
  in.support.erase(kRR);
  EXPECT_TRUE(wait.update(in).empty());
}

TEST(LiftSpacing, IsALittleLessThanThatOfEvenlySpacedLifts) {
  LegArray<double> step_time(6, 0.5);
  step_time[0] = 0.6;
  step_time[2] = 0.1;  // of the lost one
  const double spacing = lift_spacing(step_time, LegSet(1U << 2U), 2);
  EXPECT_LT(spacing, 0.5 * 0.5);
  EXPECT_GT(spacing, 0.3 * 0.5);
}

}  // namespace
}  // namespace hexagait::footstep_gen

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/footstep_gen/holes.hpp>
#include <limits>

namespace hexagait::footstep_gen {
namespace {

// Steps from 0 to 0.4 m ahead, with a workspace that ends at 0.6 m.
const Vector2 kFrom(0.0, 0.5), kTo(0.4, 0.5), kEnd(0.6, 0.5);
constexpr double kRadius = 0.09;

Vector2 foothold(const Holes& holes) { return clear_of(holes, kFrom, kTo, kEnd, kRadius).p_O; }

TEST(Holes, ChangeNoStepThatIsClearOfThem) {
  Holes holes;
  EXPECT_EQ(foothold(holes), kTo);
  EXPECT_EQ(holes.distance(kTo, Vector2::UnitX()), std::numeric_limits<double>::infinity());
  holes.add({0.15, 0.5});
  EXPECT_EQ(foothold(holes), kTo);
}

TEST(Holes, AreSteppedOverOrElseTheFootComesDownBeforeThem) {
  Holes holes;
  holes.add(kTo);
  EXPECT_EQ(foothold(holes), kEnd);
  holes.add(kEnd);
  EXPECT_LT((foothold(holes) - Vector2(0.3, 0.5)).norm(), 1e-12) << "three quarters of the way";
  holes.add(foothold(holes));
  EXPECT_LT((foothold(holes) - Vector2(0.2, 0.5)).norm(), 1e-12) << "half of it";
}

// A step that ends just off a hole ends on its edge: the far side is better, but no place behind it is.
TEST(Holes, AreSteppedOverWhereAFootWouldStandAtTheirEdge) {
  Holes holes;
  holes.add({kTo.x() - 1.2 * kRadius, 0.5});
  EXPECT_EQ(foothold(holes), kEnd);
  holes.add({kEnd.x() + 0.5 * kRadius, 0.5});
  EXPECT_EQ(foothold(holes), kTo) << "outside the radius of both";
}

// What the left front leg has learnt, the right one expects.
TEST(Holes, AreTakenToBeAsWideAsTheRobot) {
  Holes holes;
  holes.add({0.4, -0.5});
  EXPECT_EQ(foothold(holes), kEnd);
  EXPECT_NEAR(holes.distance({0.4, 0.5}, Vector2::UnitX()), 0.05, 1e-12);
  EXPECT_NEAR(holes.distance({0.4, 0.5}, Vector2::UnitY()), 1.0, 1e-12);
}

// All places are holes: the one farthest from all of them is tried, then another one.
TEST(Holes, AreTriedOneAfterTheOtherWhereThereIsNothingElse) {
  Holes holes;
  for (const double x : {0.4, 0.52, 0.3, 0.2, 0.14, 0.08, 0.0}) holes.add({x, 0.5});
  EXPECT_EQ(foothold(holes), kEnd);
  holes.add(kEnd);
  EXPECT_NE(foothold(holes), kEnd);
}

TEST(Holes, ForgetTheOldest) {
  Holes holes;
  holes.add(kTo);
  for (int k = 0; k < 15; ++k) holes.add({-9.0, 0.5});
  EXPECT_EQ(foothold(holes), kEnd);
  holes.add({-9.0, 0.5});
  EXPECT_EQ(foothold(holes), kTo);
}

TEST(Holes, MatterAlsoToAFootThatStaysWhereItIs) {
  Holes holes;
  holes.add(kFrom);
  EXPECT_EQ(clear_of(holes, kFrom, kFrom, kEnd, kRadius).p_O, kEnd);
}

TEST(Holes, BetweenSteppingStonesEndBesideThem) {
  Holes holes;
  holes.add(kTo);
  holes.set_half_width(0.04);
  EXPECT_EQ(clear_of(holes, kFrom, kTo, kEnd, kRadius).p_O, kEnd);
  const Vector2 aside(0.0, 0.05);
  EXPECT_EQ(clear_of(holes, kFrom, kTo + aside, kEnd + aside, kRadius).p_O, kTo + aside);
}

TEST(Holes, AreForgottenFarAway) {
  Holes holes;
  holes.set_half_width(0.04);
  for (int k = 0; k < 20; ++k) holes.add({0.1 * k, 0.5});
  holes.forget_beyond({1.9, 0.5}, 0.55);
  EXPECT_NEAR(holes.distance({1.2, 0.5}, Vector2::UnitX()), 0.2, 1e-12)
      << "from 1.4 on they are known";
  EXPECT_EQ(holes.distance({1.9, 0.6}, Vector2::UnitX()), std::numeric_limits<double>::infinity());
  for (int k = 0; k < 16; ++k) holes.add({9.0, 0.5});
  EXPECT_GT(holes.distance({1.9, 0.5}, Vector2::UnitX()), 7.0) << "the oldest went first";
  holes.forget_beyond({0.0, 0.0}, 1.0);
  EXPECT_TRUE(holes.empty());
}

// The far side of a ditch has holes behind it only, and the near side ahead.
TEST(Holes, LieBesideAStoneBothAheadAndBehind) {
  const Vector2 along = Vector2::UnitX();
  Holes holes;
  holes.add({0.40, 0.5});
  EXPECT_FALSE(holes.beside({0.42, 0.6}, along, 0.05)) << "behind";
  EXPECT_FALSE(holes.beside({0.35, 0.6}, along, 0.05)) << "ahead";
  holes.add({0.50, 0.5});
  EXPECT_TRUE(holes.beside({0.42, 0.6}, along, 0.05));
  EXPECT_TRUE(holes.beside({0.42, 0.4}, along, 0.05));
  EXPECT_FALSE(holes.beside({0.42, 0.52}, along, 0.05)) << "on their line";
  EXPECT_FALSE(holes.beside({0.42, 0.9}, along, 0.05)) << "too far away";
}

TEST(Holes, AreNoReasonToLeaveTheWorkspace) {
  Holes holes;
  holes.add(kTo);
  holes.add(kEnd);
  const Disc workspace{{0.5, 0.5}, 0.22};
  const Vector2 closer(0.3, 0.5);
  EXPECT_LT((clear_of(holes, kFrom, kTo, kEnd, kRadius, workspace).p_O - closer).norm(), 1e-12);
  holes.add(closer);
  const Vector2 there = clear_of(holes, kFrom, kTo, kEnd, kRadius, workspace).p_O;
  EXPECT_LT((there - workspace.centre).norm(), workspace.radius) << "not where it stands";
}

// One step in place is no reason to be bold. A step that gets on makes a leg cautious again, and that leg alone.
TEST(StepsInPlace, TakeTheCautionFromALegBitByBit) {
  StepsInPlace steps(6);
  const auto after_landing_at = [&steps](double x) {
    steps.landed(2, {x, 0.5}, 0.05);
    return steps.caution(2);
  };
  EXPECT_EQ(steps.caution(2), 1.0);
  EXPECT_EQ(after_landing_at(1.0), 1.0);
  EXPECT_EQ(after_landing_at(1.04), 1.0);
  EXPECT_EQ(after_landing_at(1.0), 0.75);
  EXPECT_EQ(after_landing_at(0.96), 0.5);
  for (int k = 0; k < 5; ++k) after_landing_at(0.96);
  EXPECT_EQ(steps.caution(2), 0.3);
  EXPECT_EQ(steps.caution(3), 1.0);
  EXPECT_EQ(after_landing_at(1.2), 1.0);
}

}  // namespace
}  // namespace hexagait::footstep_gen

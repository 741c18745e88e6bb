// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/footstep_gen/steps_beside.hpp>

namespace hexagait::footstep_gen {
namespace {

constexpr LegId kLeg = 1, kOther = 3;  // of the right side
constexpr double kWay = 4.0;
const Vector2 kHere = Vector2::Zero();

class Side {
 public:
  void fails(int times, LegId leg = kLeg) {
    for (int k = 0; k < times; ++k) steps_.failed(leg, false, kHere);
  }
  void lands(bool beside_holes) { steps_.landed(kLeg, false, beside_holes); }
  void forget_at(double x) { steps_.forget({x, 0.0}, kWay); }
  [[nodiscard]] double outwards() const { return steps_.outwards(false); }
  [[nodiscard]] bool any() const { return steps_.any(); }
  [[nodiscard]] double of_the_left() const { return steps_.outwards(true); }

 private:
  StepsBeside steps_{6};
};

TEST(StepsBeside, BeginWhenALegHasFailedTwice) {
  Side side;
  side.fails(1);
  side.fails(1, kOther);
  EXPECT_FALSE(side.any());
  side.lands(true);
  side.fails(1);
  EXPECT_FALSE(side.any()) << "it has landed in between";
  side.fails(1);
  EXPECT_TRUE(side.any());
  EXPECT_GT(side.outwards(), 0.0);
  EXPECT_EQ(side.of_the_left(), 0.0);
}

TEST(StepsBeside, AreOverWhereTheGroundIsNoStone) {
  Side side;
  side.fails(2);
  side.lands(false);
  EXPECT_FALSE(side.any());
}

// On stones the side stays where it is; where there is a hole too it goes elsewhere, and at last back to its path.
TEST(StepsBeside, GoOnOnSteppingStones) {
  Side side;
  side.fails(2);
  const double first = side.outwards();
  side.lands(true);
  side.lands(false);
  EXPECT_EQ(side.outwards(), first);
  side.fails(2);
  EXPECT_LT(side.outwards(), 0.0);
  side.fails(6);
  EXPECT_EQ(side.outwards(), 0.0);
  side.fails(2);
  EXPECT_EQ(side.outwards(), first);
  side.forget_at(0.0);
  EXPECT_FALSE(side.any());
}

TEST(StepsBeside, OfADitchEndAndAreNotTriedAtTheNextOne) {
  Side side;
  side.fails(4);
  EXPECT_LT(side.outwards(), 0.0);
  side.fails(2);
  EXPECT_FALSE(side.any());
  side.forget_at(0.9 * kWay);
  side.fails(8);
  EXPECT_FALSE(side.any());
  side.forget_at(1.1 * kWay);
  side.fails(2);
  EXPECT_TRUE(side.any());
}

}  // namespace
}  // namespace hexagait::footstep_gen

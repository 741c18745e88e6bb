// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <testing/swing.hpp>

// What a foot does about holes, their walls and their edges.

namespace hexagait {
namespace {

using testing::ahead;
using testing::kBody;
using testing::kStart;
using testing::kStride;
using testing::kTarget;
using testing::planar_distance;
using testing::Swing;

// A hole deeper than the leg: straight up, without a wall in the way, and to the next foothold that is asked for.
TEST(Swing, ClimbsStraightOutOfAHole) {
  Swing swing;
  swing.params.max_rise = 1.0;
  swing.touches = [](const Vector3& p) {
    return p.z() <= (ahead(p) > 0.15 && ahead(p) < 0.5 ? -1.0 : 0.0);
  };
  FootstepCommand step{0, kTarget, 0.1};
  step.depth.at_end = 0.2;
  command(swing.lane, step, kBody);
  const auto tick = [&] {
    swing.reachable = swing.foot().z() > -0.3;
    swing.tick();
  };
  for (int k = 0; k < 5000 && !swing.lane.found_no_ground; ++k) tick();
  ASSERT_TRUE(swing.lane.found_no_ground);
  EXPECT_LT(swing.foot().z(), -0.3);
  EXPECT_EQ(swing.lane.phase, LegPhase::lift);
  const Vector3 bottom = swing.foot();
  step.p_OT = kStart + 0.55 * (kTarget - kStart) / kStride;
  command(swing.lane, step, kBody);
  for (int k = 0; k < 5000 && swing.lane.phase != LegPhase::transfer; ++k) {
    tick();
    EXPECT_FALSE(swing.lane.found_no_ground) << "of one tick";
    if (swing.foot().z() < 0.0) {
      EXPECT_LT(planar_distance(swing.foot(), bottom), 1e-3);
    }
    EXPECT_LT(swing.lane.v_O.z(), 1.1 * swing.params.max_rise);
  }
  swing.land();
  EXPECT_NEAR(ahead(swing.foot()), 0.55, 0.005);
  EXPECT_FALSE(swing.lane.found_no_ground);
}

// Beside a hole, ground is not looked for as deep, and its wall is no ground.
TEST(Swing, DoesNotStandOnTheWallOfAHole) {
  for (const double wall : {-0.06, -9.0}) {
    Swing swing;
    swing.touches = [&](const Vector3& p) { return p.z() <= (ahead(p) > 0.15 ? wall : 0.0); };
    FootstepCommand step{0, kTarget, 0.1};
    step.depth.beside_hole = 0.1;
    command(swing.lane, step, kBody);
    for (int k = 0; k < 5000 && !swing.lane.found_no_ground; ++k) swing.tick();
    ASSERT_TRUE(swing.lane.found_no_ground);
    EXPECT_NEAR(swing.foot().z(), std::max(wall, -0.1), 0.005);
    swing.lane.retreats = swing.params.max_retreats;  // then it takes what there is
    if (wall > -1.0) swing.land();
  }
}

// (step 11) A round foot on an edge touches by up to its radius lower than on the ground beside it. It tries closer, twice
// at most; what is lower by more is ground, and so is all of it for who was told of no edge.
TEST(Swing, TriesCloserWhereItTouchesAnEdge) {
  struct Case {
    double depth;  // of what it touches [m]
    double from;   // way from the start to where it begins [m]
    bool knows;    // the step has SearchDepth::edge
    int retreats;
    double stands_at;  // of the way
  };
  for (const Case& c : {Case{0.005, kStride - 0.05, true, 1, 0.6},
                        {0.005, 0.0, true, 2, 0.36},
                        {0.03, kStride - 0.05, true, 0, 1.0},
                        {0.002, kStride - 0.05, true, 0, 1.0},
                        {0.005, kStride - 0.05, false, 0, 1.0}}) {
    Swing swing;
    swing.touches = [&c](const Vector3& p) {
      return p.z() <= (ahead(p) > c.from ? -c.depth : 0.0);
    };
    FootstepCommand step{0, kTarget, 0.1};
    if (c.knows) step.depth.edge = 0.0025, step.depth.edge_end = 0.02, step.depth.presses = true;
    if (c.depth > 0.02) swing.floor = -c.depth;
    command(swing.lane, step, kBody);
    if (c.retreats > 1) swing.until(LegPhase::retreat);
    swing.land();
    EXPECT_EQ(swing.lane.retreats, c.retreats) << c.depth;
    EXPECT_NEAR(ahead(swing.foot()), c.stands_at * kStride, 0.01) << c.depth;
  }
}

// Where a hole is known an edge is the hole's: no ground, at any try, and straight up again.
TEST(Swing, ClimbsOffTheEdgeOfAHoleThatIsKnown) {
  Swing swing;
  swing.touches = [](const Vector3& p) { return p.z() <= -0.005; };
  FootstepCommand step{0, kTarget, 0.1};
  step.depth.edge = 0.0025, step.depth.edge_end = 0.02, step.depth.beside_hole = 0.1;
  command(swing.lane, step, kBody);
  for (int tries = 1; tries <= 6; ++tries) {
    swing.until(LegPhase::descend);
    swing.until(LegPhase::lift);
    EXPECT_EQ(swing.lane.retreats, tries);
    EXPECT_TRUE(swing.lane.found_no_ground);
    EXPECT_EQ(swing.lane.reach_fraction, 1.0);
  }
}

// (step 12) What a foot touches far below level ground may be the wall of a hole: it presses, and goes back if it sinks.
TEST(Swing, GoesBackFromWhatGivesWayFarBelowLevelGround) {
  struct Case {
    bool knows, holds;
    bool lands;
  };
  constexpr double kDepth = 0.06, kEdge = 0.0025;
  for (const Case& c : {Case{true, false, false}, {true, true, true}, {false, false, true}}) {
    Swing swing;
    swing.touches = [](const Vector3& p) { return p.z() <= (ahead(p) > 0.1 ? -kDepth : 0.0); };
    if (c.holds) swing.floor = -kDepth;
    FootstepCommand step{0, kTarget, 0.1};
    if (c.knows) step.depth.edge = kEdge, step.depth.edge_end = 0.02, step.depth.presses = true;
    command(swing.lane, step, kBody);
    double lowest = 0.0;
    for (int k = 0; k < 1500 && !swing.lane.found_no_ground; ++k) {
      swing.tick();
      lowest = std::min(lowest, swing.foot().z());
      if (swing.lane.phase == LegPhase::support) break;
    }
    EXPECT_EQ(swing.lane.phase == LegPhase::support, c.lands);
    EXPECT_EQ(swing.lane.found_no_ground, !c.lands);
    if (!c.knows) continue;
    EXPECT_LT(lowest, -kDepth - (c.holds ? 0.0005 : kEdge)) << "it presses";
    EXPECT_GT(lowest, -kDepth - 0.005);
  }
}

// When no try is left, a foot stands on what gives way, too.
TEST(Swing, StandsOnWhatGivesWayWhenNothingIsLeftToTry) {
  Swing swing;
  swing.touches = [](const Vector3& p) { return p.z() <= (ahead(p) > 0.1 ? -0.06 : 0.0); };
  FootstepCommand step{0, kTarget, 0.1};
  step.depth.edge = 0.0025, step.depth.edge_end = 0.02, step.depth.presses = true;
  command(swing.lane, step, kBody);
  swing.lane.retreats = swing.params.max_retreats;
  swing.land();
  EXPECT_GT(swing.foot().z(), -0.065);
}

}  // namespace
}  // namespace hexagait

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <testing/swing.hpp>

// What a foot does about what is in its way, and where it finds no hold. Holes and edges: leg_lane_hole_test.cpp.

namespace hexagait {
namespace {

using testing::ahead;
using testing::kBody;
using testing::kDt;
using testing::kStart;
using testing::kStride;
using testing::kTarget;
using testing::planar_distance;
using testing::Swing;

/// A wall across the way, 10 cm from the start and 12 cm high.
bool touches_wall(const Vector3& p_OF) { return p_OF.z() <= (ahead(p_OF) > 0.1 ? 0.12 : 0.0); }

// [FG16]: what hits something goes back and up, and tries again higher: over a wall 2 cm higher
// than its first apex it gets at the second try, apex 15 cm.
TEST(Swing, GoesBackAndUpWhenItHitsSomethingAndOverItAtTheNextTry) {
  Swing swing;
  swing.touches = touches_wall;
  swing.command(kTarget);
  swing.until(LegPhase::retreat);
  const Vector3 hit = swing.foot();
  EXPECT_GT(planar_distance(hit, kStart), 0.09);
  EXPECT_LT(planar_distance(hit, kStart), 0.13);
  swing.until(LegPhase::transfer);
  EXPECT_LT(planar_distance(swing.foot(), kStart), planar_distance(hit, kStart) - 0.015) << "back";
  EXPECT_GT(swing.foot().z(), hit.z() + 0.02) << "up";
  swing.land();
  EXPECT_EQ(swing.lane.retreats, 1);
  EXPECT_LT(planar_distance(swing.foot(), kTarget), 0.01);
  EXPECT_NEAR(swing.foot().z(), 0.12, 1e-3);
}

// The foot stands against a wall, and its set point is 1 cm inside. Once it has risen along it, it is pushed no more.
TEST(Swing, StopsPushingAgainstAWallThatItRisesAlong) {
  const Pose tilted{rotation(Vector3(0.1, -0.5, 0.7)), {1.0, -2.0, 0.6}};
  const Vector3 stands(1.3, -1.6, 0.0), inside = stands + Vector3(0.006, -0.008, -0.004);
  for (const bool wall : {true, false}) {
    const SwingParams params = testing::round_params().swing;
    LegLane lane;
    lane.p_BF = tilted.inverse() * inside;
    command(lane, {0, stands + Vector3(0.2, 0.0, 0.0), 0.1}, tilted);
    for (int k = 0; k < 500 && lane.phase != LegPhase::transfer; ++k) {
      const Vector3 set_point = tilted * lane.p_BF;
      const double z = std::max(0.0, set_point.z()), risen = z - stands.z();
      const Vector3 foot(stands.x(), stands.y(), z);
      const double push = (set_point - foot).head<2>().norm();
      if (risen < params.touchdown_margin) {
        EXPECT_NEAR(push, 0.01, 1e-9) << "as it stood";
      }
      if (wall && risen > params.touchdown_margin + 0.002) {
        EXPECT_LT(push, 1e-9) << risen;
      }
      const Vector3 off = tilted.R.transpose() * (foot - set_point);
      const bool contact = wall ? risen < 0.02 : risen <= 0.0;
      advance(lane, {.contact = contact, .off = off}, tilted, kDt, params);
    }
    ASSERT_EQ(lane.phase, LegPhase::transfer);
  }
}

// A wall behind the foot as well: where it can't go back it goes up, and does not push. Where it can't go up either, since
// its shin is caught, it does not pull.
TEST(Swing, NeitherPushesNorPullsWhatHoldsItAsItGoesBack) {
  const SwingParams params = testing::round_params().swing;
  const Vector3 hit = kStart + 0.1 * (kTarget - kStart) / kStride + Vector3(0.0, 0.0, 0.05);
  for (const bool rises : {true, false}) {
    LegLane lane;
    lane.p_BF = kBody.inverse() * kStart;
    command(lane, {0, kTarget, 0.1}, kBody);
    lane.phase = LegPhase::retreat;
    lane.time = 0.0;
    lane.p_BF = kBody.inverse() * hit;
    lane.back_O = (hit - params.retreat_back * (kTarget - kStart) / kStride).head<2>();
    lane.apex_z = 0.15;
    double most = 0.0, pushes = 0.0;
    for (int k = 0; k < 500 && lane.phase == LegPhase::retreat; ++k) {
      const Vector3 set_point = kBody * lane.p_BF;
      const Vector3 foot(hit.x(), hit.y(), rises ? set_point.z() : hit.z());
      const Vector3 off = kBody.R.transpose() * (foot - set_point);
      most = std::max(most, off.norm());
      pushes = planar_distance(foot, set_point);
      advance(lane, {.tracking_error = off.norm(), .off = off}, kBody, kDt, params);
    }
    ASSERT_EQ(lane.phase, LegPhase::transfer);
    EXPECT_LT(pushes, 1e-9) << "it has let go";
    EXPECT_LT(most, 1.2 * params.blocked_error) << rises;
    EXPECT_LT(most, 0.5 * params.retreat_back) << rises;
    const double z = (kBody * lane.p_BF).z();
    EXPECT_NEAR(z, rises ? 0.15 : hit.z(), rises ? 1e-3 : 1.2 * params.blocked_error) << rises;
  }
}

// The third and fourth retreat take the apex up by twice as much: a wall so high may be higher still.
TEST(Swing, RisesByMoreFromTheThirdCollisionOn) {
  Swing swing;
  swing.touches = [](const Vector3& p_OF) { return p_OF.z() <= 0.0 || ahead(p_OF) > 0.1; };
  swing.command(kTarget);
  swing.until(LegPhase::transfer);
  std::vector<double> apex = {swing.lane.apex_z};
  for (int k = 0; k < 5000 && apex.size() < 5; ++k) {
    swing.tick();
    if (swing.lane.retreats == static_cast<int>(apex.size())) apex.push_back(swing.lane.apex_z);
  }
  ASSERT_EQ(apex.size(), 5U);
  EXPECT_EQ(swing.lane.reach_fraction, 1.0) << "it keeps aiming at its foothold";
  const double up = swing.params.retreat_up;
  const double rises[] = {up, up, 2.0 * up, 2.0 * up};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(apex[k + 1] - apex[k], rises[k], 1e-12) << k;
}

TEST(Swing, TriesAgainWithoutHaste) {
  Swing swing;
  swing.touches = touches_wall;
  command(swing.lane, {0, kTarget, 0.1, 1.6}, kBody);
  swing.until(LegPhase::transfer);
  EXPECT_EQ(swing.lane.haste, 1.6);
  swing.until(LegPhase::retreat);
  EXPECT_EQ(swing.lane.haste, 1.0);
}

// A wall without end: after two tries the foot aims less far each time, 60 % of the way, until it
// comes down before the wall. 0.35 · 0.6³ = 0.076 m.
TEST(Swing, GivesWayToAWallWithoutEnd) {
  Swing swing;
  swing.touches = [](const Vector3& p_OF) { return p_OF.z() <= 0.0 || ahead(p_OF) > 0.1; };
  swing.command(kTarget);
  for (int k = 0; k < 5000 && (k < 1 || swing.lane.phase != LegPhase::support); ++k) swing.tick();
  ASSERT_EQ(swing.lane.phase, LegPhase::support);
  EXPECT_LE(swing.foot().z(), 1e-3);
  EXPECT_LT(planar_distance(swing.foot(), kStart), 0.1);
}

// Out of reach on the way down (a hole): up again and down nearer to where it came from, at 60 % of
// the way, and so on.
TEST(Swing, StepsLessFarWhenTheGroundIsOutOfReach) {
  Swing swing;
  swing.touches = [](const Vector3& p) {
    return p.z() <= (planar_distance(p, kStart) > 0.15 ? -1.0 : 0.0);
  };
  swing.command(kTarget);
  for (int k = 0; k < 5000 && (k < 1 || swing.lane.phase != LegPhase::support); ++k) {
    swing.reachable = swing.foot().z() > -0.05;
    swing.tick();
  }
  ASSERT_EQ(swing.lane.phase, LegPhase::support);
  EXPECT_NEAR(planar_distance(swing.foot(), kStart), 0.36 * kStride, 0.005);
}

// It stands against the wall, and rises along it with its contact closed all the time. That contact is not
// the ground: before it moves on, it moves away from the wall.
TEST(Swing, LetsGoOfAWallThatItRisesAlong) {
  Swing swing;
  swing.touches = [](const Vector3& p) {
    return p.z() <= 0.0 || (ahead(p) > -1e-9 && p.z() < 0.12);
  };
  swing.command(kTarget);
  swing.until(LegPhase::retreat);
  const double pushed = ahead(swing.foot());
  EXPECT_LT(pushed, 0.01) << "it pushes the wall";
  swing.until(LegPhase::transfer);
  EXPECT_LT(ahead(swing.foot()), pushed - 0.5 * swing.params.retreat_back);
  swing.land();
  EXPECT_LT(planar_distance(swing.foot(), kTarget), 0.01);
}

// In a corner where it touches something wherever it goes: after the last try it stands.
TEST(Swing, StandsOnWhatItTouchesWhenNothingIsLeftToTry) {
  Swing swing;
  swing.touches = [](const Vector3&) { return true; };
  swing.command(kTarget);
  int ticks = 0;
  for (; ticks < 5000 && (ticks < 1 || swing.lane.phase != LegPhase::support); ++ticks)
    swing.tick();
  EXPECT_EQ(swing.lane.phase, LegPhase::support);
  EXPECT_EQ(swing.lane.retreats, swing.params.max_retreats);
}

// Contacts of an instant: a foot that finds no hold where it comes down tries closer, after three of them.
TEST(Swing, TriesCloserWhereItFindsNoHold) {
  Swing swing;
  int contacts = 0;
  double crumbles_at = 0.0;  // what holds for an instant, and then breaks
  swing.touches = [&](const Vector3& p) {
    if (planar_distance(p, kStart) < 0.8 * kStride) return p.z() <= 0.0;
    if (p.z() > crumbles_at) return false;
    ++contacts;
    crumbles_at -= 0.005;
    return true;
  };
  swing.command(kTarget);
  swing.until(LegPhase::retreat);
  EXPECT_EQ(contacts, swing.params.max_bounces);
  EXPECT_EQ(swing.lane.retreats, 1);
  for (int k = 0; k < 3000 && !swing.lane.supports(swing.params); ++k) swing.tick();
  EXPECT_TRUE(swing.lane.supports(swing.params));
  EXPECT_LT(planar_distance(swing.foot(), kStart), 0.7 * kStride);
}

// The shin is on an edge: the foot feels nothing, and does not get down. When no try is left, it does not
// push, or the robot would stand on its shin, but tries elsewhere.
TEST(Swing, DoesNotPushWhatItCantGetPast) {
  Swing swing;
  swing.touches = [](const Vector3& p) { return p == kStart; };
  swing.command(kTarget);
  swing.until(LegPhase::descend);
  swing.lane.retreats = swing.params.max_retreats;
  swing.blocked = true;
  swing.tick();
  EXPECT_EQ(swing.lane.phase, LegPhase::retreat);
  const double there = swing.foot().z();
  double lowest = there;
  for (int k = 0; k < 3000; ++k) {
    swing.blocked = swing.lane.phase == LegPhase::descend;
    swing.tick();
    lowest = std::min(lowest, swing.foot().z());
  }
  EXPECT_GT(swing.lane.retreats, swing.params.max_retreats + 3);
  EXPECT_GT(lowest, there - 0.01);
  swing.blocked = false;
  swing.touches = [](const Vector3& p) { return p.z() <= 0.0; };
  swing.land();
}

// The body has gone on: where the foot stood is out of reach, and so is its foothold. It comes down in
// between, or beside.
TEST(Swing, SearchesForAFootholdThatIsWithinReach) {
  for (const double side : {0.0, 1.0, -1.0}) {
    Swing swing;
    const Vector3 way = (kTarget - kStart) / kStride;
    const Vector3 left(-way.y(), way.x(), 0.0);
    const double beside = side * 2.0 * swing.params.retreat_back;
    const Vector3 place = kStart + (side == 0.0 ? 0.5 : 0.75) * kStride * way + beside * left;
    swing.touches = [&](const Vector3& p) {
      return p == kStart || (p.z() <= 0.0 && planar_distance(p, place) < 0.01);
    };
    swing.command(kTarget);
    swing.until(LegPhase::transfer);
    for (int k = 0; k < 20000 && swing.lane.phase != LegPhase::support; ++k) {
      swing.reachable = swing.foot().z() > -0.01;
      swing.tick();
    }
    ASSERT_EQ(swing.lane.phase, LegPhase::support) << side;
    EXPECT_LT(planar_distance(swing.foot(), place), 0.01);
    EXPECT_GT(swing.lane.retreats, swing.params.max_retreats);
  }
}

}  // namespace
}  // namespace hexagait

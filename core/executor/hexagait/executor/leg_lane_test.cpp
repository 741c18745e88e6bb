// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/sim/random.hpp>
#include <testing/swing.hpp>

namespace hexagait {
namespace {

using testing::kBody;
using testing::kDt;
using testing::kStart;
using testing::kStride;
using testing::kTarget;
using testing::planar_distance;
using testing::Swing;

// Committed within the last 3 cm, of which the descent takes some 0.15 s; the minimum-jerk motion
// has only its tail left then. On the ground within the way of one tick.
TEST(Swing, LandsOnItsFootholdWithinTwoMillimetres) {
  Swing swing;
  swing.command(kTarget);
  swing.land();
  EXPECT_LT(planar_distance(swing.foot(), kTarget), 0.002);
  EXPECT_LE(swing.foot().z(), 0.0);
  EXPECT_GT(swing.foot().z(), -swing.params.touchdown_speed * kDt * 1.01);
}

// Support from 20 ms of unbroken contact on: a foot that bounces for 3 ms starts to count again.
TEST(Swing, CountsAsSupportOnceItHasKeptContact) {
  Swing swing;
  swing.command(kTarget);
  swing.land();
  EXPECT_FALSE(swing.lane.supports(swing.params));
  const auto ticks = std::lround(swing.params.confirm_time / kDt);
  const auto on_ground = swing.touches;
  for (long k = 0; k < ticks - 1; ++k) swing.tick();
  swing.touches = [](const Vector3&) { return false; };
  swing.tick();
  swing.touches = on_ground;
  for (long k = 0; k < ticks - 1; ++k) {
    swing.tick();
    EXPECT_FALSE(swing.lane.supports(swing.params));
  }
  for (int k = 0; k < 2; ++k) swing.tick();
  EXPECT_TRUE(swing.lane.supports(swing.params));
}

// A target that moves at v = 0.15 m/s, as it does when the body's speed is other than predicted.
// The law knows only where it is now: at rest relative to it, 60 e/T³ = 36 v/T², it trails by 0.6 v
// T = 4.5 mm at the shortest T = 0.05 s, and is near there when it commits itself.
TEST(Swing, FollowsATargetThatMoves) {
  Swing swing;
  Vector3 target = kTarget, committed = kTarget;
  swing.command(target);
  swing.land([&] {
    target += Vector3(0.0, 0.15 * kDt, 0.0);
    if (swing.lane.phase == LegPhase::support) return;
    if (swing.lane.phase != LegPhase::descend || swing.foot().z() > swing.params.commit_height)
      committed = target;
    swing.command(target);
  });
  EXPECT_LT(planar_distance(swing.foot(), committed), 0.6 * 0.15 * 0.05 + 1e-3);
  EXPECT_GT(planar_distance(committed, kTarget), 0.06) << "it did move";
}

// The descent begins where 30 % of the clearance are left or less, so 70 % are reached, and the
// minimum-jerk law doesn't pass its goal.
TEST(Swing, GoesUpToItsClearance) {
  for (const double ground : {0.0, 0.1, -0.1}) {
    Swing swing;
    double apex = 0.0;
    swing.touches = [&](const Vector3& p) {
      return p.z() <= (planar_distance(p, kTarget) < 0.1 ? ground : 0.0);
    };
    swing.command(kTarget + Vector3(0.0, 0.0, ground));
    swing.land([&] { apex = std::max(apex, swing.foot().z()); });
    EXPECT_GE(apex, std::max(0.0, ground) + 0.07) << ground;
    EXPECT_LE(apex, std::max(0.0, ground) + 0.101) << ground;
    EXPECT_NEAR(swing.foot().z(), ground, 1e-3);
  }
}

// The set point is the integral of v_O, without a jump: in a tick it moves by the mean velocity, but
// for at most dt³/12 of its jerk, 60 D/T³ of each motion. v_O is the integral of a_O, but for the
// touchdown, where the ground stops it. Minimum jerk over D in T: peak speed 1.875 D/T, peak acceleration
// 5.774 D/T². A quarter on top, for T is of the mean, the phases overlap, and there are two axes.
TEST(Swing, MovesContinuouslyWithinTheMinimumJerkLawsBounds) {
  Swing swing;
  swing.command(kTarget);
  const double T = swing.params.transfer_time;
  Vector3 p = swing.foot(), v = Vector3::Zero();
  double fastest = 0.0;
  swing.land([&] {
    const Vector3 p_now = swing.foot(), v_now = swing.lane.v_O;
    if (swing.lane.phase == LegPhase::support) {
      EXPECT_LE(v.norm(), 1.1 * swing.params.touchdown_speed) << "touchdown";
      return;
    }
    const double jerk = 60.0 * (kStride / std::pow(T, 3) + 0.1 / std::pow(0.2, 3));
    ASSERT_LT((p_now - p - 0.5 * kDt * (v + v_now)).norm(), std::pow(kDt, 3) / 12.0 * jerk);
    ASSERT_LT((v_now - v).head<2>().norm(), 1.25 * 5.774 * kStride / (T * T) * kDt);
    ASSERT_LT(std::abs((v_now - v).z()), 1.25 * 5.774 * 0.1 / std::pow(0.2, 2) * kDt);
    fastest = std::max(fastest, v_now.head<2>().norm());
    p = p_now, v = v_now;
  });
  EXPECT_LT(fastest, 1.05 * 1.875 * kStride / T);
}

// Where T would be too short for max_speed, it grows.
TEST(Swing, KeepsToItsSpeedOverLongWays) {
  Swing swing;
  swing.params.max_speed = 0.8;
  swing.command(kStart + Vector3(0.0, 0.6, 0.0));
  double fastest = 0.0;
  swing.land([&] { fastest = std::max(fastest, swing.lane.v_O.head<2>().norm()); });
  EXPECT_LT(fastest, 1.05 * swing.params.max_speed);
  EXPECT_LT(planar_distance(swing.foot(), kStart + Vector3(0.0, 0.6, 0.0)), 0.003);
}

// (swing 4) Twice as fast, in half the period: the same places tick for tick, until the foot searches for
// ground. The floor of the time to go, 50 ms, stays.
TEST(Swing, InHasteIsTheSameMotionInLessTime) {
  Swing at_ease, hasty;
  at_ease.params.unload_time = kDt;  // one tick of each
  at_ease.params.hasty_speed = 2.0 * at_ease.params.max_speed;
  hasty.params = at_ease.params;
  const FootstepCommand step{0, kTarget, 0.1};
  command(at_ease.lane, step, kBody);
  command(hasty.lane, {0, kTarget, 0.1, 2.0}, kBody);
  double passed = 0.0;
  for (int k = 0; k < 300 && at_ease.foot().z() > -1e-3; ++k) {
    const LegSensed in_the_air{.contact = k < 5};
    for (auto& [swing, dt] : {std::pair(&at_ease, 2.0 * kDt), std::pair(&hasty, kDt)}) {
      sense(swing->lane, in_the_air.contact, dt, swing->params);
      advance(swing->lane, in_the_air, kBody, dt, swing->params);
    }
    ASSERT_LT((hasty.foot() - at_ease.foot()).norm(), 0.004) << k << ": " << at_ease.foot();
    passed = std::max(passed, planar_distance(hasty.foot(), kStart));
  }
  EXPECT_NEAR(passed, kStride, 0.003);
  EXPECT_LT(at_ease.foot().z(), 0.0) << "it has come down again";
}

// A command while the foot is in the air changes the target only.
TEST(Swing, KeepsTheHasteThatItBeganWith) {
  Swing swing;
  command(swing.lane, {0, kTarget, 0.1, 1.6}, kBody);
  swing.until(LegPhase::transfer);
  command(swing.lane, {0, kTarget, 0.1, 1.0}, kBody);
  EXPECT_EQ(swing.lane.haste, 1.6);
  swing.land();
  swing.command(kStart);
  EXPECT_EQ(swing.lane.haste, 1.0) << "the next step";
}

// Nothing sideways before 40 % of the clearance; below commit_height only the tail of the motion,
// whose speed at the time-to-go of overlap/3 is a few percent of its peak.
TEST(Swing, LeavesAndMeetsTheGroundVertically) {
  Swing swing;
  swing.command(kTarget);
  Vector3 committed = Vector3::Zero();
  swing.land([&] {
    const bool rising = swing.lane.phase == LegPhase::unload || swing.lane.phase == LegPhase::lift;
    if (rising && swing.foot().z() < 0.4 * 0.1) {
      ASSERT_LT(planar_distance(swing.foot(), kStart), 1e-12);
    }
    if (swing.lane.phase == LegPhase::descend && swing.foot().z() > swing.params.commit_height)
      committed = swing.foot();
  });
  EXPECT_LT(planar_distance(swing.foot(), committed), 0.003);
}

TEST(Swing, UnloadsBeforeItLiftsAndLoadsAfterItLands) {
  Swing swing;
  swing.command(kTarget);
  EXPECT_FALSE(swing.lane.supports(swing.params)) << "counts as off the ground from the command on";
  EXPECT_TRUE(swing.lane.on_ground());
  double t = 0.0;
  while (swing.lane.phase == LegPhase::unload) {
    const double load = swing.lane.load;
    swing.tick();
    t += kDt;
    ASSERT_NEAR(load - swing.lane.load, kDt / swing.params.unload_time, 1e-12);
    ASSERT_LT(planar_distance(swing.foot(), kStart), 1e-12);
  }
  EXPECT_NEAR(t, swing.params.unload_time, kDt);
  swing.land([&] {
    if (swing.lane.phase != LegPhase::support) {
      ASSERT_EQ(swing.lane.load, 0.0);
    }
  });
  for (int k = 1; swing.lane.load < 1.0; ++k) {
    if (k > 1) swing.tick();  // it takes load from the tick on in which it lands
    ASSERT_NEAR(swing.lane.load, std::min(1.0, k * kDt / swing.params.load_time), 1e-9);
  }
}

// `lifted` and `touched_down` are events of one tick.
TEST(Swing, SaysOnceThatItLiftsAndOnceThatItTouchesDown) {
  Swing swing;
  for (int k = 0; k < 5; ++k) swing.tick();
  EXPECT_FALSE(swing.lane.lifted);
  swing.command(kTarget);
  int lifted = 0, touched = 0;
  swing.land([&] { lifted += swing.lane.lifted, touched += swing.lane.touched_down; });
  for (int k = 0; k < 50; ++k, lifted += swing.lane.lifted, touched += swing.lane.touched_down)
    swing.tick();
  EXPECT_EQ(lifted, 1);
  EXPECT_EQ(touched, 1);
}

// Ground 4 cm higher than thought is found on the way down; ground 6 cm deeper is searched for, at
// no more than search_speed.
TEST(Swing, TouchesDownWhereTheGroundIs) {
  for (const double ground : {0.04, -0.06}) {
    Swing swing;
    swing.command(kTarget);
    double fastest = 0.0;
    swing.touches = [&](const Vector3& p) {
      return p.z() <= (planar_distance(p, kTarget) < 0.05 ? ground : -1.0) || p == kStart;
    };
    swing.land([&] {
      if (swing.foot().z() < 0.0) fastest = std::max(fastest, -swing.lane.v_O.z());
    });
    EXPECT_NEAR(swing.foot().z(), ground, swing.params.descent_speed * kDt) << ground;
    EXPECT_LE(fastest, swing.params.search_speed + 1e-12);
  }
}

// (step 9) Above the ground so many times as fast, also in haste, but no faster than a foot may rise.
TEST(Swing, DescendsFasterWhereTheHeightIsAGuess) {
  const auto fastest = [](double times, double haste, double max_rise) {
    Swing swing;
    swing.params.max_rise = max_rise;
    FootstepCommand step{0, kTarget, 0.1};
    step.descent = times;
    step.haste = haste;
    command(swing.lane, step, kBody);
    swing.touches = [](const Vector3& p) { return p.z() <= -0.05 || p == kStart; };
    double down = 0.0;
    swing.land([&] {
      if (swing.foot().z() > 0.0) down = std::max(down, -swing.lane.v_O.z());
    });
    return down;
  };
  const double speed = Swing().params.descent_speed;
  EXPECT_NEAR(fastest(1.0, 1.0, 10.0), speed, 1e-9);
  EXPECT_NEAR(fastest(1.2, 1.0, 10.0), 1.2 * speed, 1e-9);
  EXPECT_NEAR(fastest(1.2, 1.2, 10.0), 1.44 * speed, 1e-9);
  EXPECT_NEAR(fastest(1.2, 1.0, 1.1 * speed), 1.1 * speed, 1e-9);
}

// (step 6) The speed at the height that is expected, and that of the search below, so many times as fast; neither
// faster than the descent. Deeper than the clearance the search is as slow as ever.
TEST(Swing, TouchesDownFasterWhereTheHeightIsAGuess) {
  for (const double times : {1.0, 1.5, 2.5}) {
    Swing swing;
    FootstepCommand step{0, kTarget, 0.1};
    step.touchdown = times;
    command(swing.lane, step, kBody);
    double there = 0.0, below = 0.0, deep = 0.0;
    swing.touches = [&](const Vector3& p) { return p.z() <= -0.16 || p == kStart; };
    swing.land([&] {
      const double z = swing.foot().z(), down = -swing.lane.v_O.z();
      if (std::abs(z) < 0.5 * swing.params.touchdown_margin) there = std::max(there, down);
      if (z < -0.07 && z > -0.1) below = std::max(below, down);
      if (z < -0.14) deep = std::max(deep, down);
    });
    const double most = swing.params.descent_speed;
    EXPECT_NEAR(there, std::min(times * swing.params.touchdown_speed, most), 1e-9) << times;
    EXPECT_NEAR(below, std::min(times * swing.params.search_speed, most), 1e-9) << times;
    EXPECT_NEAR(deep, swing.params.search_speed, 1e-9) << times;
  }
}

// (step 10) Slow from touchdown_margin above the ground on, or from that share of it.
TEST(Swing, IsSlowOverAShareOfTheMargin) {
  for (const double share : {1.0, 0.3}) {
    Swing swing;
    FootstepCommand step{0, kTarget, 0.1};
    step.slow_way = share;
    command(swing.lane, step, kBody);
    double slow_from = 0.0;
    swing.touches = [&](const Vector3& p) { return p.z() <= 0.0; };
    swing.land([&] {
      const double v = -swing.lane.v_O.z();
      if (std::abs(v - swing.params.touchdown_speed) < 1e-6)
        slow_from = std::max(slow_from, swing.foot().z());
    });
    EXPECT_NEAR(slow_from, share * swing.params.touchdown_margin,
                2.0 * swing.params.touchdown_speed * kDt)
        << share;
  }
}

// The ground is gone: off the ground after lost_time, unloaded, and after regain_time the foot goes
// down for it, straight.
TEST(LostContact, CountsAsOffTheGroundAndThenGoesDownToFindIt) {
  Swing swing;
  for (int k = 0; k < 10; ++k) swing.tick();
  EXPECT_TRUE(swing.lane.supports(swing.params));
  swing.touches = [](const Vector3& p) { return p.z() <= -0.04; };

  double t = 0.0;
  for (; swing.lane.supports(swing.params) && t < 1.0; t += kDt) swing.tick();
  EXPECT_NEAR(t, swing.params.lost_time, 1.5 * kDt);
  EXPECT_EQ(swing.lane.phase, LegPhase::support);
  for (; swing.lane.phase == LegPhase::support && t < 1.0; t += kDt) swing.tick();
  EXPECT_NEAR(t, swing.params.regain_time, 1.5 * kDt);
  EXPECT_EQ(swing.lane.phase, LegPhase::descend);
  EXPECT_LT(swing.lane.load, 0.5);
  swing.land();
  EXPECT_NEAR(swing.foot().z(), -0.04, 1e-3);
  EXPECT_LT(planar_distance(swing.foot(), kStart), 1e-9);
}

TEST(LostContact, IsForgivenIfItComesBackInTime) {
  Swing swing;
  swing.touches = [](const Vector3&) { return false; };
  for (double t = 0.0; t < 0.04; t += kDt) swing.tick();
  EXPECT_FALSE(swing.lane.supports(swing.params));
  swing.touches = [](const Vector3&) { return true; };
  swing.tick();
  EXPECT_TRUE(swing.lane.supports(swing.params));
  for (int k = 0; k < 30; ++k) swing.tick();
  EXPECT_EQ(swing.lane.load, 1.0);
}

// A hole under a leg that stands, deeper than the leg: after the retreat it tries where it stood,
// from the height of a step above, whatever it did in the step before, 2 m lower.
TEST(LostContact, StartsAfreshWhateverTheStepBeforeWas) {
  Swing swing;
  swing.lane.p_OL = {-7.0, 3.0, -2.0};
  swing.lane.apex_z = -1.9;
  swing.lane.retreats = 5;
  swing.lane.reach_fraction = 0.2;
  swing.lane.step.profile_height = 0.1;
  swing.touches = [](const Vector3&) { return false; };
  swing.until(LegPhase::descend);
  swing.reachable = false;
  swing.tick();
  swing.reachable = true;
  ASSERT_EQ(swing.lane.phase, LegPhase::retreat);
  swing.until(LegPhase::transfer);
  EXPECT_GT(swing.foot().z(), 0.01);
  EXPECT_LT(planar_distance(swing.foot(), kStart), 1e-6);
}

// A step is the same step for whatever the yaw and place of odom.
TEST(Swing, IsTheSameWhereverOdomIs) {
  const Pose moved{rotation_z(-1.1), {3.0, 5.0, 0.0}};
  const Pose body = moved * kBody;
  LegLane a, b;
  a.p_BF = b.p_BF = kBody.inverse() * kStart;
  a.time = b.time = 1.0;
  command(a, {0, kTarget, 0.1}, kBody);
  command(b, {0, moved * kTarget, 0.1}, body);
  for (int k = 0; k < 400; ++k) {
    const bool contact = (kBody * a.p_BF).z() <= 0.0;
    advance(a, {.contact = contact}, kBody, kDt, testing::round_params().swing);
    advance(b, {.contact = contact}, body, kDt, testing::round_params().swing);
    ASSERT_EQ(a.phase, b.phase);
    ASSERT_LT((a.p_BF - b.p_BF).norm(), 1e-11);
  }
}

}  // namespace
}  // namespace hexagait

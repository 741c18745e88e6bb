// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <hexagait/balance/support_polygon.hpp>
#include <hexagait/footstep_gen/detail/kinematic_walk.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <limits>
#include <testing/argos.hpp>
#include <testing/control_period.hpp>
#include <vector>

namespace hexagait::footstep_gen::walker_test {
namespace {

// A walker keeps a pointer to the model: made from a temporary one, it would dangle.
static_assert(!std::is_constructible_v<Walker, RobotModel>);
static_assert(!std::is_constructible_v<Walker, const RobotModel, WalkerParams>);

using heading_control::Heading;
using heading_control::Turn;
using hexagait::testing::argos;
using hexagait::testing::kDt;

using Walk = KinematicWalk;

Heading random_heading(RandomSequence& random) {
  const double kind = random.u01(), alpha = random.uniform(-std::numbers::pi, std::numbers::pi);
  if (kind < 0.1) return Heading::straight(alpha);
  if (kind < 0.2) return Heading::spin(alpha < 0.0 ? Turn::cw : Turn::ccw);
  const double r = std::exp(random.uniform(std::log(0.05), std::log(20.0)));
  return Heading::arc(kind < 0.6 ? r : -r, alpha);
}

const std::vector<Heading> kHeadings = {Heading::straight(0.0),
                                        Heading::straight(std::numbers::pi),
                                        Heading::straight(0.5 * std::numbers::pi),
                                        Heading::arc(1.0, 0.0),
                                        Heading::arc(-0.7, 1.0),
                                        Heading::spin(Turn::ccw),
                                        Heading::spin(Turn::cw),
                                        Heading::arc(0.3, 0.0)};

// The first index from which on the lifts come in threes that are alternately the one and the other
// tripod, to the end; their number if they don't.
std::size_t tripod_from(const std::vector<Lift>& lifts) {
  const auto tripod = [&](std::size_t k) {
    LegSet legs;
    for (std::size_t i = k; i < k + 3; ++i) legs.insert(lifts[i].leg);
    return legs.bits();
  };
  constexpr std::uint32_t kFirst = 0b011001, kSecond = 0b100110;  // 0 3 4 and 1 2 5
  std::size_t from = lifts.size();
  for (std::size_t start = 0; start < 3; ++start) {
    std::size_t k = start + (lifts.size() - start) / 3 * 3, good = lifts.size();
    for (std::uint32_t after = 0; k >= start + 3; k -= 3) {
      const std::uint32_t now = tripod(k - 3);
      if ((now != kFirst && now != kSecond) || now == after) break;
      after = now;
      good = k - 3;
    }
    from = std::min(from, good);
  }
  return from;
}

// [PC04] 3.2: from every start. The transient of the model is below n/2 step times, in each of
// which at most n/2 legs lift: 9 lifts; in continuous time and with feet anywhere, 25 is the claim.
TEST(WalkerGait, BecomesTheTripodWithinTwentyFiveLiftsFromAnyPosture) {
  for (std::uint32_t trial = 0; trial < 20; ++trial) {
    Walk walk(argos(), 0.8, trial);
    const Heading heading = kHeadings[trial % kHeadings.size()];
    walk.walk(heading, 30.0);
    ASSERT_GT(walk.lifts.size(), 60U) << trial;
    EXPECT_LE(tripod_from(walk.lifts), 25U) << "trial " << trial;
  }
}

// Two rings beside six: rule 1 is checked at every tick. With n legs, n/2 in the air at a time,
// each leg lifts every 2 T, T < 1.2 s. After a change of heading the gait reorders itself; even then
// each leg lifts every n T, T < 0.9 s, as if one leg were in the air at a time.
TEST(WalkerGait, WalksOnAnyEvenNumberOfLegs) {
  for (const int n : {6, 8, 10, 12}) {
    const RobotModel model = testing::robot_of(n);
    for (std::uint32_t trial = 0; trial < 3; ++trial) {
      Walk walk(model, 0.7, trial);
      walk.walk(Heading::straight(0.0), 20.0);
      EXPECT_GT(walk.place().x(), 2.0) << n << " legs";
      EXPECT_LT(std::abs(walk.place().y()), 0.05) << n << " legs";
      walk.longest_wait = LegArray<double>(n, 0.0);
      walk.walk(Heading::arc(1.0, 0.3), 6.0);
      for (LegId i = 0; i < n; ++i) EXPECT_LT(walk.longest_wait[i], n * 0.9) << n << " " << i;
      walk.longest_wait = LegArray<double>(n, 0.0);
      for (LegId i = 0; i < n; ++i) walk.last_lift[i] = walk.walker.record().state.time;
      walk.walk(Heading::arc(1.0, 0.3), 14.0);
      for (LegId i = 0; i < n; ++i) EXPECT_LT(walk.longest_wait[i], 2.0 * 2.4) << n << " " << i;
    }
  }
}

// One leg in the air at a time, and only over three others: in every tick the centre of mass is
// inside the feet that stand. A round is four steps of T < 0.9 s and two sways of a second; a change of
// heading reorders it, and no leg waits for two.
TEST(WalkerGait, FourLegsCrawl) {
  constexpr double kRound = 4 * 0.9 + 2 * 1.0;
  const RobotModel model = testing::robot_of(4);
  for (std::uint32_t trial = 0; trial < 3; ++trial) {
    Walk walk(model, 0.7, trial);
    walk.walk(Heading::straight(0.0), 20.0);
    EXPECT_GT(walk.place().x(), 0.8);
    walk.longest_wait = LegArray<double>(4, 0.0);
    for (LegId i = 0; i < 4; ++i) walk.last_lift[i] = walk.walker.record().state.time;
    for (const Heading& heading :
         {Heading::arc(1.0, 0.3), Heading::spin(heading_control::Turn::cw)}) {
      for (int k = 0; k < 5000; ++k) {
        const TickRecord& record = walk.tick(heading);
        const LegSet airborne = record.gait_input.airborne | record.lifts;
        ASSERT_LE(airborne.size(), 1);
        LegArray<Vector3> feet(4);
        for (LegId i = 0; i < 4; ++i) feet[i] = record.legs[i].p_BF;
        const SupportPolygon polygon = support_polygon(feet, without(LegSet::all(4), airborne));
        ASSERT_GT(stability_margin(polygon, model.p_BM.head<2>()), 0.0) << k;
      }
    }
    for (LegId i = 0; i < 4; ++i) EXPECT_LT(walk.longest_wait[i], 2 * kRound) << i;
  }
}

// The centre of mass beside the tripod that would stand: legs wait that the gait state lets step. On
// the robot that is modelled as it is, nobody waits.
TEST(WalkerGait, LiftsNoLegThatTheCentreOfMassNeeds) {
  for (const double aside : {0.0, 0.3}) {
    RobotModel model = testing::robot_of(6);
    model.p_BM += Vector3(aside, aside, 0.0);
    Walk walk(model, 0.0);
    int unsteady = 0, waits = 0;
    for (int k = 0; k < 2000; ++k) {
      const TickRecord& record = walk.tick(Heading::straight(0.0));
      waits += record.waits.size();
      if (record.lifts.empty()) continue;
      LegArray<Vector3> feet(6);
      for (LegId i = 0; i < 6; ++i) feet[i] = record.legs[i].p_BF;
      const LegSet rest = without(LegSet::all(6), record.gait_input.airborne | record.lifts);
      unsteady += stability_margin(support_polygon(feet, rest), model.p_BM.head<2>()) < 0.0;
    }
    EXPECT_EQ(unsteady, 0) << aside;
    EXPECT_EQ(walk.lifts.size() > 10, aside == 0.0) << walk.lifts.size();
    EXPECT_EQ(waits > 0, aside > 0.0) << waits;
  }
}

// With one leg in the air at a time, the slowest of all gaits, each of n legs lifts every n T,
// T ≈ 0.85 s for a step in the air and its ramps of load: 5.1 s.
constexpr double kLongestWait = 6 * 0.85;

// r = cot χ: from a spin over all arcs to the left, the straight line, all arcs to the right, the
// other spin, and backwards round to the first: every r, each twice, with o passing through the
// stance of both sides' middle legs.
// While it walks: the body sinks to the height of the new stance, feet step where it has them, and no set
// point jumps (KinematicPlant's ticks check joint speeds), and the next start keeps it.
TEST(WalkerStance, ChangesBetweenTwoTicks) {
  Walk walk(argos(), 0.0);
  const double own = argos().foot_radius - argos().legs[0].p_BC.z();
  for (int k = 0; k < 2000; ++k) walk.tick(Heading::straight(0.0));
  EXPECT_NEAR(walk.plant.X_OB.p.z(), own, 0.01);

  walk.walker.set_stance(stance_at(argos(), {.height = own - 0.06, .splay = 0.03}));
  for (int k = 0; k < 10000; ++k) walk.tick(Heading::straight(0.0));
  EXPECT_NEAR(walk.plant.X_OB.p.z(), own - 0.06, 0.01);
  EXPECT_GT(walk.lifts.size(), 20u);

  Stance absurd = walk.walker.stance();
  absurd.p_BC[2].z() = -5.0;
  EXPECT_THROW(walk.walker.set_stance(absurd), InvalidInput);
  EXPECT_NEAR(walk.walker.stance().p_BC[2].z(), argos().foot_radius + 0.06 - own, 1e-12);
  walk.walker.start(walk.plant.measurement);
  EXPECT_NEAR(walk.walker.stance().p_BC[0].z(), argos().foot_radius + 0.06 - own, 1e-12);
}

// On a slope of 0.2 the feet go back by 0.2 H in the body frame: the centre of mass stays over their middle. Down
// again the stance is level.
TEST(WalkerStance, LeansUphill) {
  Walk walk(argos(), 0.0);
  const Vector2 level = walk.walker.stance().p_BC[0].head<2>();
  walk.plant.ground = [](const Vector2& p_O) { return 0.2 * std::clamp(p_O.x() - 0.8, 0.0, 3.0); };
  const double height = argos().p_BM.z() - argos().legs[0].p_BC.z();
  walk.walk(Heading::straight(0.0), 12.0);
  EXPECT_LT(walk.plant.X_OB.R(0, 2), -0.17) << "it is not on the slope";
  Vector2 lean = walk.walker.stance().p_BC[0].head<2>() - level;
  EXPECT_NEAR(lean.x(), -0.2 * height, 0.2 * 0.2 * height);
  EXPECT_NEAR(lean.y(), 0.0, 0.005);
  walk.walker.start(walk.plant.measurement);
  EXPECT_EQ(walk.walker.stance().p_BC[0].head<2>(), level);
}

TEST(WalkerGait, LetsNoLegStarveWhileTheRadiusSweepsThroughAllValues) {
  Walk walk(argos());
  walk.walk(Heading::spin(Turn::ccw), 5.0);
  walk.longest_wait = LegArray<double>(6, 0.0);
  for (int k = 0; k < 60000; ++k) {
    const double chi = 0.5 * std::numbers::pi - 2.0 * std::numbers::pi * k / 60000.0;
    walk.tick(Heading::along({0.5 * std::cos(chi), 0.0}, std::sin(chi)));
    if (HasFatalFailure()) return;
  }
  for (LegId i = 0; i < 6; ++i) EXPECT_LT(walk.longest_wait[i], kLongestWait) << "leg " << i;
}

// From r = 2 m to 0.1 m, across the spin to −0.1 m, and on to −2 m: 60 s a sweep, for three crab
// angles. The turning centre goes straight through the legs' stance.
TEST(WalkerGait, LetsNoLegStarveWhileTheTurningCentreCrossesTheWorkspaces) {
  for (const double alpha : {0.0, 0.5 * std::numbers::pi, 2.0}) {
    Walk walk(argos());
    walk.walk(Heading::arc(2.0, alpha), 5.0);
    walk.longest_wait = LegArray<double>(6, 0.0);
    for (int k = 0; k < 30000; ++k) {
      const double r = 2.0 * std::pow(0.05, std::min(1.0, k / 15000.0));
      const double back = -0.1 * std::pow(20.0, (k - 15000) / 15000.0);
      walk.tick(Heading::arc(k < 15000 ? r : back, alpha));
      if (HasFatalFailure()) return;
    }
    for (LegId i = 0; i < 6; ++i) EXPECT_LT(walk.longest_wait[i], kLongestWait) << "leg " << i;
  }
}

// [PC04] 5: as fast as a joystick is moved. Rule 1 and no fault: at each tick, by Walk.
TEST(WalkerGait, ObeysAnyHeadingEverySecondForTwoMinutes) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    RandomSequence random{.seed = seed, .stream = RandomStream::commands};
    Walk walk(argos());
    for (int second = 0; second < 120; ++second) {
      walk.walk(random_heading(random), 1.0);
      if (HasFatalFailure()) return;
      const double tilt = std::acos(std::min(1.0, walk.plant.X_OB.R(2, 2)));
      ASSERT_LT(tilt, 0.02) << seed;
      ASSERT_NEAR(walk.plant.X_OB.p.z(), 0.32, 0.01) << seed;
    }
    for (LegId i = 0; i < 6; ++i) EXPECT_LT(walk.longest_wait[i], 2.0 * kLongestWait) << seed;
  }
}

// The plant is the executor's own idea of the world, so that what is left is the integration of
// odometry, with feet that roll, lift and land 0.16 mm deep at most: 2 % of a step of 20 cm would
// be 4 mm per step.
TEST(WalkerOdometry, KnowsWhereTheRobotIsAfterAMinute) {
  for (const Heading& heading : kHeadings) {
    Walk walk(argos());
    walk.walk(heading, 60.0);
    EXPECT_LT(walk.odometry_error(), 0.02);
  }
}

TEST(WalkerSteering, TakesEffectInTheSameTick) {
  Walk walk(argos());
  walk.walk(Heading::straight(0.0), 3.0);
  const Heading left = Heading::arc(0.8, 0.4);
  const PlanarTwist before = walk.walker.record().base_auto.path;
  const TickRecord& record = walk.tick(left);
  EXPECT_EQ(record.heading, left);
  const auto arc = path_arc(left, nominal_stance(argos()));
  EXPECT_EQ(record.arc.per_metre.v, arc.per_metre.v);
  EXPECT_EQ(record.base_auto.path.v, arc.per_metre.v);
  EXPECT_EQ(record.base_auto.path.w, arc.per_metre.w);
  EXPECT_NE(record.base_auto.path.w, before.w);
  for (LegId i = 0; i < 6; ++i)
    EXPECT_EQ(record.gait_input.lag[i] == 0.0, false) << "lags are along the new arc";
}

// The body goes where it is told: along α, round to the left for r > 0, on the spot.
TEST(WalkerSteering, GoesWhereTheHeadingPoints) {
  for (const double alpha : {0.0, 0.8, std::numbers::pi, -2.0}) {
    Walk walk(argos(), 0.0);
    walk.walk(Heading::straight(alpha), 20.0);
    const Vector2 ahead(std::cos(alpha), std::sin(alpha));
    EXPECT_GT(walk.place().dot(ahead), 1.5) << alpha;
    EXPECT_LT(std::abs(cross(ahead, walk.place())), 0.02) << alpha;
  }
  for (const double r : {0.8, -0.8}) {  // never off the circle about (0, r)
    Walk walk(argos(), 0.0);
    for (int second = 0; second < 20; ++second) {
      walk.walk(Heading::arc(r, 0.0), 1.0);
      ASSERT_NEAR((walk.place() - Vector2(0.0, r)).norm(), std::abs(r), 0.02);
    }
    EXPECT_GT(walk.plant.X_OB.R(1, 0) * r, -1.0);
  }
  Walk walk(argos(), 0.0);
  walk.walk(Heading::spin(Turn::ccw), 3.0);
  EXPECT_LT(walk.place().norm(), 0.02);
  EXPECT_GT(walk.plant.X_OB.R(1, 0), 0.2);
}

// Steps under way are ended within one step time, then the body settles over its feet.
TEST(WalkerStop, ComesToRestWithAllFeetDown) {
  for (const Heading& heading : kHeadings) {
    Walk walk(argos());
    walk.walk(heading, 7.3);
    walk.walk(heading.stopped(), 4.0);
    const TickRecord& record = walk.walker.record();
    for (LegId i = 0; i < 6; ++i) {
      EXPECT_EQ(record.legs[i].phase, LegPhase::support);
      EXPECT_TRUE(record.measurement.contact[i]);
      EXPECT_LT(record.targets.qd[i].norm(), 1e-3);
    }
    EXPECT_LT(record.base.planar.v.norm(), 1e-3);
    EXPECT_LT(std::abs(record.base.planar.w), 1e-3);
    EXPECT_TRUE(record.lifts.empty());
  }
}

TEST(WalkerStop, DoesNotStepBeforeItIsToldToGo) {
  Walk walk(argos());
  walk.walk(Heading::stop(), 3.0);
  EXPECT_TRUE(walk.lifts.empty());
}

// What is not measured is taken to go as planned, which in this world it does: the robot gets
// within 20 % as far.
TEST(WalkerSensors, AreNotNeededToWalk) {
  Walk complete(argos());
  complete.walk(Heading::arc(2.0, 0.0), 20.0);
  for (const SensorMask mask : {SensorMask{true, false}, {false, true}, {false, false}}) {
    WalkerParams params;
    params.sensors = mask;
    Walk walk(argos(), 0.8, 0, params);
    walk.walk(Heading::arc(2.0, 0.0), 20.0);
    EXPECT_GT(walk.lifts.size(), 40U);
    EXPECT_LT((walk.place() - complete.place()).norm(), 0.2 * complete.place().norm());
  }
}

}  // namespace
}  // namespace hexagait::footstep_gen::walker_test

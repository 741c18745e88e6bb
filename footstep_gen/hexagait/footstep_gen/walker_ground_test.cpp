// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <hexagait/balance/support_polygon.hpp>
#include <hexagait/footstep_gen/detail/kinematic_walk.hpp>
#include <hexagait/model/leg_weight.hpp>
#include <limits>
#include <testing/argos.hpp>
#include <testing/control_period.hpp>

// Balance and gait on the rough ground that the feet have found.

namespace hexagait::footstep_gen::walker_ground_test {
namespace {

using heading_control::Heading;
using hexagait::testing::argos;
using hexagait::testing::kDt;
using Walk = KinematicWalk;

// (step 8) Up a slope of 25° the prints of its feet differ in height by 0.37 m, more than 2.3 steps are high: rear
// legs wait for each other, and feet touch down as slowly as on level ground. Who asks for the tripod gets it.
TEST(Walker, WalksAWaveWhereItsPrintsDifferMuch) {
  const auto slope = [](const Vector2& p_O) { return std::max(0.0, 0.47 * (p_O.x() - 1.5)); };
  Walk walk(argos(), 0.0);
  walk.plant.ground = slope;
  walk.plant.lift_off = 1e-3;  // no foot holds its body, which tilts by 1 mm/s while a leg waits
  double touchdown = 0.0;
  const auto rear_legs_wait = [&](double to) {
    int ticks = 0;
    for (int k = 0; k < 30000 && walk.place().x() < to; ++k) {
      const TickRecord& record = walk.tick(Heading::straight(0.0));
      if (record.waits.contains(4) || record.waits.contains(5)) ++ticks;
      if (walk.place().x() > 2.6 && !record.lifts.empty())
        for (LegId leg = 0; leg < 6; ++leg)
          touchdown = std::max(touchdown, record.footsteps[leg].touchdown);
    }
    return ticks * kDt;
  };
  EXPECT_EQ(rear_legs_wait(1.0), 0.0) << "a free gait";
  EXPECT_FALSE(walk.walker.record().very_rough);
  (void)rear_legs_wait(2.6);
  EXPECT_GT(rear_legs_wait(3.2), 0.01) << "s of waiting";
  EXPECT_TRUE(walk.walker.record().very_rough);
  EXPECT_EQ(touchdown, 1.0);

  WalkerParams params;
  params.stepper.stepping = gait_state::Stepping::tripod;
  Walk tripod(argos(), 0.0, 0, params);
  tripod.plant.ground = slope;
  for (int k = 0; k < 10000 && tripod.place().x() < 2.6; ++k) {
    const TickRecord& record =
        tripod.walker.tick(PlantStatus::fresh, tripod.plant.measurement, Heading::straight(0.0));
    ASSERT_FALSE(record.very_rough);
    tripod.plant.follow(record, kDt);
  }
  EXPECT_GT(tripod.place().x(), 2.5);
}

/// Height of hills of up to 36 cm, from x = 0.75 m on, some 0.8 to 1.3 m from top to top [m]. Feet stand on them, not on
/// their sides as on those of boxes, which this plant doesn't know.
template <int Kx, int Ky>
double hills(const Vector2& p_O) {
  const double x = std::max(0.0, p_O.x() - 0.75);
  return 0.18 * (1.0 - std::cos(Kx * x) * std::cos(Ky * p_O.y() + x));
}

constexpr std::array kHills = {hills<6, 5>, hills<6, 7>, hills<8, 5>, hills<8, 7>};

/// Lifts of walks over very rough ground by a robot whose load is 8 cm behind its middle.
struct RoughLifts {
  int all = 0;
  int unsteady = 0;        ///< that leave the centre of mass less than 2.8 times the margin inside
  int scant = 0;           ///< less than 4 times
  int ticks_of_waits = 0;  ///< in which the body moves for a leg that waits
  double descent = 0.0;    ///< fastest of all steps on the hills, of FootstepCommand::descent
};

RobotModel with_load_behind() {
  RobotModel loaded = argos();
  loaded.base.p_LM.x() -= 0.08 * loaded.mass / loaded.base.mass;
  weigh(loaded);
  return loaded;
}

/// @param asked  stability margin, of the robot's
/// @param late  the joints of legs in the air are measured so many periods after the fact: feet lose hold as they land
/// @param way   of each walk [m]
RoughLifts rough_lifts(double asked, std::size_t late = 0, double way = 4.0) {
  const RobotModel loaded = with_load_behind();
  const double margin = Walk(loaded, 0.0).walker.params().step.stability_margin;
  WalkerParams params;
  params.step.stability_margin = asked * margin;
  RoughLifts found;
  for (const auto ground : kHills) {
    Walk walk(loaded, 0.0, 0, params);
    walk.plant.ground = ground;
    // A foot that is measured 6 ms late as it lands at 0.5 m/s is set down 3 mm above the ground.
    if (late > 0) walk.plant.lift_off = 4e-3;
    std::deque<LegArray<LegJoints>> targets;
    for (int k = 0; k < 60000 && walk.place().x() < way; ++k) {
      LegSet stood;
      for (LegId i = 0; i < 6; ++i)
        stood.set(i, walk.walker.record().legs[i].phase == LegPhase::support);
      const TickRecord& record =
          walk.walker.tick(PlantStatus::fresh, walk.plant.measurement, Heading::straight(0.0));
      EXPECT_TRUE(record.rule1_violations.empty());
      walk.plant.follow(record, kDt);
      targets.push_back(record.targets.q);
      if (targets.size() > late + 1) targets.pop_front();
      for (LegId i = 0; i < 6; ++i)
        if (!record.legs[i].on_ground()) walk.plant.measurement.q[i] = targets.front()[i];
      for (LegId i = 0; i < 6; ++i)
        if (walk.place().x() > 0.75 && record.lifts.contains(i))
          found.descent = std::max(found.descent, record.footsteps[i].descent);
      if (!record.very_rough) continue;
      if (!record.waits.empty() && record.base_auto.correction.v.norm() > 0.005)
        ++found.ticks_of_waits;
      if (record.lifts.empty()) continue;
      const Matrix3& R_OB = record.state.X_OB.R;
      LegArray<Vector3> feet(6);
      for (LegId i = 0; i < 6; ++i) feet[i] = R_OB * record.legs[i].p_BF;
      const SupportPolygon stay = support_polygon(feet, without(stood, record.lifts));
      ++found.all;
      const double left = stability_margin(stay, (R_OB * loaded.p_BM).head<2>());
      if (left < 2.8 * margin) ++found.unsteady;
      if (left < 4.0 * margin) ++found.scant;
    }
    EXPECT_GT(walk.place().x(), way - 0.1);
  }
  return found;
}

// (balance 1)
TEST(Walker, WaitsForItsBalanceWhereItsPrintsDifferMuch) {
  const RoughLifts unasked = rough_lifts(0.0), asked = rough_lifts(1.0);
  EXPECT_GT(6 * unasked.unsteady, unasked.all);
  EXPECT_LT(20 * asked.unsteady, asked.all);
  EXPECT_GT(asked.all, 80);
  EXPECT_GT(asked.ticks_of_waits, 10 * unasked.ticks_of_waits);
}

// Legs that are ahead already step where they stand, while one that is behind waits for balance: it waits for four
// times a step, of about a second, all the same. Three times the margin is more than this robot can have.
TEST(Walker, WaitsNoLongerIfLegsThatAreAheadStepMeanwhile) {
  const RobotModel loaded = with_load_behind();
  WalkerParams params;
  params.step.stability_margin = 3.0 * Walk(loaded, 0.0).walker.params().step.stability_margin;
  int in_place = 0;
  for (const auto ground : kHills) {
    Walk walk(loaded, 0.0, 0, params);
    walk.plant.ground = ground;
    double last = 0.0, longest = 0.0;
    for (int k = 0; k < 20000; ++k) {
      const TickRecord& record =
          walk.walker.tick(PlantStatus::fresh, walk.plant.measurement, Heading::straight(0.0));
      walk.plant.follow(record, kDt);
      if (!record.very_rough) last = record.state.time;
      for (LegId i = 0; i < 6; ++i) {
        if (!record.lifts.contains(i)) continue;
        if (record.gait_input.lag[i] > 0.0)
          last = record.state.time;
        else
          ++in_place;
      }
      longest = std::max(longest, record.state.time - last);
    }
    EXPECT_LT(longest, 6.0);
  }
  EXPECT_GT(in_place, 10);
}

/// Height of stairs of 17 × 29 cm, from x = 0.75 m on, up (1) or down (−1) [m].
template <int Sense>
double stairs(const Vector2& p_O) {
  return Sense * 0.17 * std::max(0.0, std::floor((p_O.x() - 0.75) / 0.29) + 1.0);
}

/// Height of the ground with a single step of 17 cm at x = 0.75 m, up (1) or down (−1) [m].
template <int Sense>
double single_step(const Vector2& p_O) {
  return p_O.x() > 0.75 ? Sense * 0.17 : 0.0;
}

// Without measured joints nobody knows whether a foot sinks: it stands on what it touches, (step 12).
TEST(Walker, StepsDownWithoutJointFeedback) {
  WalkerParams params;
  params.sensors.joint_feedback = false;
  Walk walk(argos(), 0.0, 0, params);
  walk.plant.ground = [](const Vector2& p_O) { return p_O.x() < 1.0 ? 0.0 : -0.06; };
  for (int k = 0; k < 10000 && walk.place().x() < 2.0; ++k)
    walk.plant.follow(
        walk.walker.tick(PlantStatus::fresh, walk.plant.measurement, Heading::straight(0.0)), kDt);
  EXPECT_GE(walk.place().x(), 2.0);
}

// (step 9) The prints differ as much before the body is tilted as after.
TEST(Walker, DescendsFasterUntilItsPathIsSteep) {
  int level = 0, steep = 0;
  for (const auto ground : {single_step<1>, single_step<-1>}) {
    Walk walk(argos(), 0.0);
    walk.plant.ground = ground;
    const double height = walk.walker.params().step.height;
    for (int k = 0; k < 20000 && walk.place().x() < 2.0; ++k) {
      const TickRecord& record =
          walk.walker.tick(PlantStatus::fresh, walk.plant.measurement, Heading::straight(0.0));
      walk.plant.follow(record, kDt);
      if (height_spread(record.state.print_O) < 1.2 * height) continue;
      const double sine = std::abs(record.state.X_OB.R(2, 0));
      for (LegId i = 0; i < 6; ++i) {
        if (!record.lifts.contains(i)) continue;
        if (sine < 0.10) ++level;
        if (sine > 0.15) ++steep;
        const double descent = record.footsteps[i].descent;
        EXPECT_TRUE(sine > 0.10 || descent > 1.1) << descent;
        EXPECT_TRUE(sine < 0.15 || descent == 1.0) << descent;
      }
    }
    EXPECT_GE(walk.place().x(), 2.0);
  }
  EXPECT_GT(level, 4);
  EXPECT_GT(steep, 4);
}

/// How far inside the support polygon the centre of mass is left by the base that goes on over stairs, at least; of
/// the stability margin.
double least_inside(double (*ground)(const Vector2&), bool inertial_unit) {
  Walk walk(argos(), 0.0);
  walk.plant.ground = ground;
  const double margin = walk.walker.params().step.stability_margin;
  const auto support = [&](const LegArray<LegLane>& legs) {
    LegSet set;
    for (LegId i = 0; i < 6; ++i) set.set(i, legs[i].supports(walk.walker.params().executor.swing));
    return set;
  };
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 60000 && walk.place().x() < 3.0; ++k) {
    const LegArray<LegLane> before = walk.walker.record().legs;
    if (inertial_unit)
      walk.plant.measurement.imu = {walk.plant.X_OB.R.transpose() * Vector3(0.0, 0.0, 9.81),
                                    walk.walker.record().base.twist().w};
    const TickRecord& record =
        walk.walker.tick(PlantStatus::fresh, walk.plant.measurement, Heading::straight(0.0));
    walk.plant.follow(record, kDt);
    const double advance = record.base_auto.max_advance;
    const bool steep = record.very_rough && std::abs(record.state.X_OB.R(2, 0)) > 0.4;
    if (!steep || support(before) != support(record.legs) || advance < 1e-3) continue;
    const Matrix3& R_OB = record.state.X_OB.R;
    LegArray<Vector3> feet(6);
    for (LegId i = 0; i < 6; ++i) feet[i] = R_OB * before[i].p_BF;
    const SupportPolygon polygon = support_polygon(feet, support(before));
    const Vector3 p_BM = centre_of_mass(argos(), record.state.q);
    const Vector2 there = (R_OB * (p_BM + Vector3(advance, 0.0, 0.0))).head<2>();
    if (polygon.size > 2) least = std::min(least, stability_margin(polygon, there) / margin);
  }
  EXPECT_GT(walk.place().x(), 2.9);
  return least;
}

// (balance 2)
TEST(Walker, KeepsItsBaseInsideOnStairs) {
  EXPECT_NEAR(least_inside(stairs<-1>, false), 3.0, 1e-6) << "down";
  EXPECT_NEAR(least_inside(stairs<-1>, true), 2.0, 1e-6) << "down, with an inertial unit";
  EXPECT_NEAR(least_inside(stairs<1>, false), 1.0, 1e-6) << "up";
}

// (balance 1) Twice as much with drives that are late by 6 ms.
TEST(Walker, WaitsForMoreBalanceIfItsDrivesAreLate) {
  const RoughLifts prompt = rough_lifts(1.0, 0, 2.4), late = rough_lifts(1.0, 3, 2.4);
  EXPECT_GT(late.all, 80);
  EXPECT_GT(4 * prompt.scant, prompt.all);
  EXPECT_LT(20 * late.scant, late.all);
  EXPECT_GT(prompt.descent, 1.05) << "(step 9)";
  EXPECT_EQ(late.descent, 1.0) << "(step 9)";
}

// Rule 1. While RF is up, LF beside it loses its contact and is held where it is, as a foot on the edge of a stair's tread.
// In the middle of a walk, where the four others carry the robot.
TEST(Walker, BeginsNoStepForLostContactBesideAStep) {
  constexpr LegId kLF = 0, kRF = 1;
  WalkerParams params;
  params.stepper = {.stepping = gait_state::Stepping::wave, .duty_factor = 0.8};
  params.finds_faults = false;  // it would take the contact sensor for broken
  Walk walk(argos(), 0.0, 0, params);
  // On level ground RF would be put down: LF may be gone.
  walk.plant.ground = [](const Vector2& p_O) { return p_O.y() > 0.0 ? 0.05 : 0.0; };
  bool held = false;
  int waits = 0, begins_after = 0;
  LegJoints stuck;
  for (int k = 0; k < 20000 && begins_after == 0; ++k) {
    if (held) {
      walk.plant.measurement.contact[kLF] = false;
      walk.plant.measurement.q[kLF] = stuck;
    }
    const TickRecord& record =
        walk.walker.tick(PlantStatus::fresh, walk.plant.measurement, Heading::straight(0.0));
    const LegLane &lost = record.legs[kLF], &lifted = record.legs[kRF];
    if (!held && record.state.time > 6.0 && record.lifts.contains(kRF)) {
      held = true;
      stuck = record.measurement.q[kLF];
      stuck[1] += 0.08;  // 4 cm off: blocked as soon as it looks for the ground
    }
    walk.plant.follow(record, kDt);
    if (!held || !lost.regains) continue;
    if (is_up(lifted.phase)) {
      ASSERT_EQ(lost.phase, LegPhase::descend) << record.state.time;
      ++waits;
    } else if (lost.phase == LegPhase::retreat) {
      ++begins_after;
    }
  }
  EXPECT_GT(waits * kDt, 0.1);
  EXPECT_EQ(begins_after, 1);
}

}  // namespace
}  // namespace hexagait::footstep_gen::walker_ground_test

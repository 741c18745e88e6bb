// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <hexagait/footstep_gen/walker.hpp>
#include <hexagait/gait_state/ring.hpp>
#include <testing/argos.hpp>
#include <testing/control_period.hpp>
#include <testing/kinematic_plant.hpp>
#include <vector>

// Which gait the walker walks: free, wave by duty factor, waiting tripod, and the readings of
// [PC04] that are kept to compare with.

namespace hexagait::footstep_gen {
namespace {

using gait_state::Adjustment;
using gait_state::Stepping;
using heading_control::Heading;
using heading_control::Turn;
using hexagait::testing::kDt;

struct Step {
  double lift = 0.0, land = 0.0;  // [s]
};

WalkerParams params_of(Stepping stepping, double duty_factor = 0.5,
                       Adjustment adjustment = Adjustment::latched) {
  WalkerParams params;
  params.stepper = {.stepping = stepping, .duty_factor = duty_factor};
  params.gait.adjustment = adjustment;
  return params;
}

/// A walker in the kinematic world, and the steps of each leg.
struct Walk {
  RobotModel model;  // which must outlive the walker
  int n;
  Walker walker;
  testing::KinematicPlant plant;
  std::vector<std::vector<Step>> steps;
  LegArray<double> longest_wait;       ///< between two lifts [s]
  LegArray<double> landed_lag, sweep;  ///< of the last stance [m of path]
  double time = 0.0;

  Walk(const RobotModel& robot, const WalkerParams& params, std::uint32_t trial = 0)
      : model(robot),
        n(model.num_legs()),
        walker(model, params),
        plant(model, 0.7, {.seed = 21, .stream = RandomStream::posture, .trial = trial}),
        steps(static_cast<std::size_t>(n), std::vector<Step>(1)),
        longest_wait(n, 0.0),
        landed_lag(n, 0.0),
        sweep(n, 0.0) {
    walker.start(plant.measurement);
  }

  std::vector<Step>& steps_of(LegId leg) { return steps[static_cast<std::size_t>(leg)]; }

  /// No two neighbours off the ground, none that lifts beside one, none that lifts unasked.
  const TickRecord& tick(const Heading& heading) {
    const TickRecord& record = walker.tick(PlantStatus::fresh, plant.measurement, heading);
    plant.follow(record, kDt);
    time += kDt;
    LegSet off_ground;
    for (LegId i = 0; i < n; ++i) {
      off_ground.set(i, !record.legs[i].supports(walker.params().executor.swing));
      const double lag = record.gait_input.lag[i];
      if (record.legs[i].lifted) {
        steps_of(i).push_back({time, 0.0});
        sweep[i] = lag - landed_lag[i];
      }
      if (record.legs[i].touched_down) {
        steps_of(i).back().land = time;
        landed_lag[i] = lag;
      }
      longest_wait[i] = std::max(longest_wait[i], time - steps_of(i).back().lift);
    }
    EXPECT_FALSE(gait_state::breaks_rule_1(off_ground, n));
    EXPECT_TRUE(record.rule1_violations.empty());
    EXPECT_EQ(record.waits & record.lifts, LegSet());
    return record;
  }

  void walk(const Heading& heading, double seconds) {
    for (int k = 0; k < std::lround(seconds / kDt); ++k) tick(heading);
  }
};

// The gait of the last whole periods, seen from the first rear leg: where in the period each leg
// lifts, by ring position from that leg on, and how long it stands.
struct Measured {
  double period = 0.0;
  std::vector<double> phase, duty_factor;
};

Measured measured(Walk& walk, int rear_edge, int periods) {
  Measured result;
  const auto& rear = walk.steps_of(gait_state::leg_at(rear_edge, walk.n));
  if (static_cast<int>(rear.size()) < periods + 3) return result;
  const double end = rear[rear.size() - 2].lift;
  const double begin = rear[rear.size() - 2 - static_cast<std::size_t>(periods)].lift;
  result.period = (end - begin) / periods;
  for (int k = 0; k < walk.n; ++k) {
    const LegId leg = gait_state::leg_at((rear_edge + k) % walk.n, walk.n);
    double air = 0.0, phase = 0.0;
    int count = 0;
    for (const Step& step : walk.steps_of(leg)) {
      if (step.lift < begin - 0.01 * result.period || step.lift > end - 0.01 * result.period)
        continue;
      air += step.land - step.lift;
      phase = (step.lift - begin) / result.period;
      ++count;
    }
    EXPECT_EQ(count, periods) << "leg " << leg << " steps once in a period";
    result.duty_factor.push_back(1.0 - air / (end - begin));
    result.phase.push_back(phase);
  }
  return result;
}

double between(double a, double b) { return std::abs(a - b - std::round(a - b)); }

// (gait 5): along either side from the rear forwards one step time apart, the sides half a period
// apart. Ticks of 2 ms, a step of T = 0.85 s and its rounding to the one that was longest leave
// 2 % of a period; a leg starts up to 30 ms after the one before it landed, three in a row.
void expect_wave(Walk& walk, int rear_edge, double duty_factor) {
  const Measured gait = measured(walk, rear_edge, 3);
  ASSERT_GT(gait.period, 0.0) << "it walks";
  const double step = 1.0 - duty_factor;  // T / P
  for (int k = 0; k < walk.n; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const bool first_side = k == 0 || k > walk.n / 2;
    const int place = first_side ? (walk.n - k) % walk.n : k - 1;  // from the rear
    const double due = (first_side ? 0.0 : 0.5) + place * step;
    EXPECT_LT(between(gait.phase[i], due), 0.03 + 0.01 * place)
        << "position " << k << " of " << walk.n;
    EXPECT_NEAR(gait.duty_factor[i], duty_factor, 0.02) << "position " << k;
  }
}

TEST(WaveGait, RunsFromTheRearForwardsOnBothSidesHalfAPeriodApart) {
  for (const int n : {6, 8}) {
    const RobotModel model = testing::robot_of(n);
    for (const double duty_factor : {0.5, 0.625, 0.75, 5.0 / 6.0}) {
      Walk walk(model, params_of(Stepping::wave, duty_factor), static_cast<std::uint32_t>(n));
      walk.walk(Heading::straight(0.0), 40.0);
      SCOPED_TRACE(::testing::Message() << n << " legs, duty factor " << duty_factor);
      expect_wave(walk, gait_state::hindmost_edge(n), duty_factor);
    }
  }
}

TEST(WaveGait, RunsForwardsWhereverForwardsIs) {
  const RobotModel model = testing::robot_of(6);
  for (const Heading& heading :
       {Heading::straight(std::numbers::pi), Heading::straight(0.5 * std::numbers::pi),
        Heading::arc(3.0, 0.0), Heading::arc(-3.0, -0.5 * std::numbers::pi)}) {
    for (const double duty_factor : {0.625, 0.75}) {
      Walk walk(model, params_of(Stepping::wave, duty_factor));
      walk.walk(heading, 40.0);
      SCOPED_TRACE(::testing::Message() << heading.radius() << " m, " << heading.crab_angle());
      expect_wave(walk, walk.walker.record().rear_edge, duty_factor);
    }
  }
}

// The knob from 1/2 up and back to the tripod, while walking.
TEST(WaveGait, FollowsTheDutyFactorUpAndDownWhileWalking) {
  Walk walk(testing::robot_of(6), {});
  for (const double duty_factor : {0.5, 2.0 / 3.0, 5.0 / 6.0, 0.6, 0.5}) {
    walk.walker.set_stepping({.stepping = Stepping::wave, .duty_factor = duty_factor});
    walk.walk(Heading::straight(0.0), 30.0);
    SCOPED_TRACE(duty_factor);
    expect_wave(walk, gait_state::hindmost_edge(6), duty_factor);
  }
}

// While a rear leg waits it is inside `< a >`, so its neighbours stay down, the other rear leg
// among them: what it waits for is past, and the wait at most a period, here 6 T. Then a free
// gait's longest wait, 6 T for each change of the heading's order: T = 0.85 s. Headings last 2 s on
// average, so that two such changes fall into one wait (measured over six seeds: 8 to 15 s).
TEST(WaveGait, StarvesNoLegHoweverTheDutyFactorAndTheHeadingChange) {
  const RobotModel model = testing::robot_of(6);
  RandomSequence random{.seed = 22, .stream = RandomStream::commands};
  Walk walk(model, {});
  while (walk.time < 200.0) {
    const double duty_factor = random.uniform(0.5, 5.0 / 6.0),
                 curvature = random.uniform(-2.0, 2.0);
    walk.walker.set_stepping({.stepping = Stepping::wave, .duty_factor = duty_factor});
    const Heading heading =
        random.u01() < 0.1
            ? Heading::spin(Turn::cw)
            : Heading::arc(1.0 / curvature, random.uniform(-std::numbers::pi, std::numbers::pi));
    walk.walk(heading, random.uniform(0.1, 4.0));
    if (HasFailure()) return;
  }
  for (LegId i = 0; i < 6; ++i) EXPECT_LT(walk.longest_wait[i], 18.0 * 0.9) << "leg " << i;
}

// The stroke is 0.20 m: so much path passes while a foot stands, and speed is S (1 − β)/(β T). A
// leg that stands for a little more than β P, because it waited for a neighbour, sweeps as much
// more.
TEST(WaveGait, SweepsTheStrokeAtEveryDutyFactor) {
  const RobotModel model = hexagait::testing::argos();
  for (const double duty_factor : {0.5, 0.6, 0.625, 0.75, 5.0 / 6.0}) {
    Walk walk(model, params_of(Stepping::wave, duty_factor));
    walk.walk(Heading::straight(0.0), 30.0);
    double mean = 0.0;
    for (const double sweep : walk.sweep) {
      EXPECT_NEAR(sweep, 0.20, 0.06) << duty_factor;
      mean += sweep / 6.0;
    }
    EXPECT_NEAR(mean, 0.20, 0.016) << duty_factor;
  }
}

// "Why does leg 5 not step?"
TEST(WaveGait, RecordsWhoWaitsForTheRearLegRule) {
  Walk walk(testing::robot_of(6), params_of(Stepping::wave, 5.0 / 6.0));
  walk.walk(Heading::straight(0.0), 20.0);
  int waits = 0;
  for (int k = 0; k < 5000; ++k) {
    const TickRecord& record = walk.tick(Heading::straight(0.0));
    EXPECT_EQ(record.lifts | record.waits, record.gait.may_step);
    EXPECT_EQ(record.waits.bits() & ~0b110000U, 0U) << "only the rear legs wait";
    waits += record.waits.size();
  }
  EXPECT_GT(waits, 500);
}

// A pause is no step: T of (gait 5) does not learn from it.
TEST(WaveGait, GoesOnAfterAStopAsBefore) {
  Walk walk(testing::robot_of(6), params_of(Stepping::wave, 0.75));
  walk.walk(Heading::straight(0.0), 20.4);
  walk.walk(Heading::straight(0.0).stopped(), 60.0);
  const std::size_t before = walk.steps_of(5).size();
  walk.walk(Heading::straight(0.0), 30.0);
  EXPECT_GE(walk.steps_of(5).size(), before + 8U) << "a period of 3.5 s";
  expect_wave(walk, gait_state::hindmost_edge(6), 0.75);
}

TEST(TripodGait, LiftsOneWholeTripodThenTheOtherAndOnlyWhenAllLegsStand) {
  for (const int n : {6, 8}) {
    Walk walk(testing::robot_of(n), params_of(Stepping::tripod), 3);
    LegSet last;
    int lifts = 0;
    for (int k = 0; k < 10000; ++k) {
      const TickRecord& record = walk.tick(Heading::arc(2.0, 0.3));
      if (record.lifts.empty()) continue;
      EXPECT_TRUE(record.gait_input.airborne.empty());
      EXPECT_TRUE(record.lifts == gait_state::first_tripod(n) ||
                  record.lifts == gait_state::second_tripod(n));
      EXPECT_NE(record.lifts, last);
      last = record.lifts;
      ++lifts;
    }
    EXPECT_GT(lifts, 20) << "20 s of steps that take 0.85 s";
  }
}

TEST(TripodGait, IsNoneForFourLegs) {
  Walk walk(testing::robot_of(4), params_of(Stepping::tripod), 3);
  for (int k = 0; k < 5000; ++k) {
    const TickRecord& record = walk.tick(Heading::arc(2.0, 0.3));
    ASSERT_LE((record.lifts | record.gait_input.airborne).size(), 1);
  }
}

TEST(TripodGait, StandsWhenToldTo) {
  Walk walk(testing::robot_of(6), params_of(Stepping::tripod));
  walk.walk(Heading::stop(), 3.0);
  for (LegId i = 0; i < 6; ++i) EXPECT_EQ(walk.steps_of(i).size(), 1U);
}

// The trap of docs/theory.md 1, in the whole controller: the paper's adjustment taken literally
// lets the same legs step at every tick, so that nothing ever differs; the latch does better.
TEST(Readings, ThePapersWordsTakenLiterallyWalkToTheLastBitAsWithoutAdjustment) {
  const RobotModel model = hexagait::testing::argos();
  int differs = 0;
  for (std::uint32_t trial = 0; trial < 8; ++trial) {
    Walk literal(model, params_of(Stepping::free, 0.5, Adjustment::literal), trial);
    Walk none(model, params_of(Stepping::free, 0.5, Adjustment::none), trial);
    Walk free(model, params_of(Stepping::free), trial);
    for (int k = 0; k < 4000; ++k) {
      const JointTargets& a = literal.tick(Heading::straight(0.0)).targets;
      const JointTargets& b = none.tick(Heading::straight(0.0)).targets;
      for (LegId i = 0; i < 6; ++i) ASSERT_EQ(a.q[i], b.q[i]) << "tick " << k;
      free.tick(Heading::straight(0.0));
    }
    differs += free.plant.X_OB.p != none.plant.X_OB.p;
  }
  EXPECT_GE(differs, 3) << "starts whose CCN is not 3";
}

}  // namespace
}  // namespace hexagait::footstep_gen

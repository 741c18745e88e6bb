// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/executor/leg_lane.hpp>
#include <hexagait/sim/random.hpp>
#include <testing/round_params.hpp>

/// A step is the same step at every control period from 1 to 20 ms.

namespace hexagait::leg_lane_period_test {
namespace {

constexpr double kPeriods[] = {0.001, 0.002, 0.003, 0.005, 0.008, 0.0125, 0.010, 0.020};
constexpr double kGround = 0.0;

/// A step over the plane z = 0 under a body at rest. Contact is latched over the period, as a
/// plant does: it is known one period after the foot was there.
struct Step {
  double dt;
  SwingParams params = testing::round_params().swing;
  LegLane lane;
  Vector3 target;
  double t = 0.0;
  double apex = 0.0, fastest_change = 0.0, fastest = 0.0, hardest = 0.0;
  bool contact = true;
  Vector3 committed = Vector3::Zero();

  Step(double period, const Vector3& way, double height) : dt(period), target(way) {
    lane.time = 1.0;
    command(lane, {0, target, height}, {});
  }
  void tick() {
    const Vector3 v = lane.v_O;
    if (lane.phase != LegPhase::descend || lane.p_BF.z() > params.commit_height)
      committed = lane.p_BF;
    sense(lane, contact, dt, params);
    advance(lane, {.contact = contact, .turn = turning_time(lane, {}, params)}, {}, dt, params);
    t += dt;
    contact = lane.p_BF.z() <= kGround;
    apex = std::max(apex, lane.p_BF.z());
    fastest = std::max(fastest, lane.v_O.head<2>().norm());
    if (lane.phase != LegPhase::support) hardest = std::max(hardest, (lane.v_O - v).norm() / dt);
  }
  void retarget(const Vector3& to) {
    target = to;
    command(lane, {0, target, lane.step.profile_height}, {});
  }
  bool ended() const { return t > 0.1 && lane.supports(params); }
};

Vector3 along(double distance, double angle) {
  return {distance * std::cos(angle), distance * std::sin(angle), 0.0};
}

// Lands where it should, after the same time. Events count in the tick nearest to them, so each of
// the four that follow one another (unloaded, clear, over the foothold, on the ground) shifts the
// step by half a period at most; contact is seen up to one period late, and confirmed up to one
// period late.
TEST(SwingPeriod, LandsAtTheSamePlaceAfterTheSameTime) {
  for (const double distance : {0.05, 0.2, 0.4}) {
    for (const double height : {0.05, 0.1, 0.2}) {
      Step reference(0.001, along(distance, 0.7), height);
      while (!reference.ended() && reference.t < 5.0) reference.tick();
      for (const double dt : kPeriods) {
        Step step(dt, along(distance, 0.7), height);
        while (!step.ended() && step.t < 5.0) step.tick();
        ASSERT_TRUE(step.ended()) << dt << " s, " << distance << " m, " << height << " m";
        EXPECT_NEAR(step.t, reference.t, 4.0 * dt) << distance << " m, " << height << " m";
        EXPECT_LT((step.lane.p_BF - reference.lane.p_BF).head<2>().norm(), 0.003) << dt;
        EXPECT_LT((step.lane.p_BF - step.target).head<2>().norm(), 0.004) << dt;
        EXPECT_NEAR(step.apex, reference.apex, 0.02 * height + 0.002) << dt;
        EXPECT_GE(step.lane.p_BF.z(), -step.params.touchdown_speed * 2.0 * dt) << dt;
      }
    }
  }
}

// A foot goes down in the first tick that its time is up: half a period later on average.
TEST(SwingPeriod, DescendsHalfAPeriodLateOnAverage) {
  constexpr int kSteps = 50;
  const auto until_descent = [](double dt) {
    double sum = 0.0;
    for (int k = 0; k < kSteps; ++k) {
      Step step(dt, along(0.5 + 0.3 * k / kSteps, 0.7), 0.1);
      double moves_from = 0.0;
      while (step.lane.phase != LegPhase::descend && step.t < 5.0) {
        if (step.lane.v_O.head<2>().isZero()) moves_from = step.t;
        step.tick();
      }
      sum += step.t - moves_from;
    }
    return sum / kSteps;
  };
  constexpr double kFine = 0.0005;
  const double reference = until_descent(kFine);
  for (const double dt : kPeriods)
    EXPECT_NEAR(until_descent(dt) - reference, 0.5 * (dt - kFine), 0.2 * dt) << dt;
}

// (swing 7) In the middle of its way, at full speed, a foot is told to go elsewhere: farther along, across, or back. It is
// accelerated at most 1.5 times as hard as in the hardest of ordinary steps, 5.774 D/T² with D = v T/1.875 (2.4 times if its
// time were not set back), and gets there.
TEST(SwingPeriod, TurnsInTheAirNoHarderThanItSwings) {
  for (const double dt : kPeriods) {
    for (const double to : {0.0, 0.5, 1.0, 2.0, 3.1}) {
      Step step(dt, along(0.35, 0.0), 0.1);
      const SwingParams& p = step.params;
      const double hardest = 5.774 * p.max_speed / (1.875 * p.transfer_time);
      while (step.lane.v_O.x() < 0.7 * p.max_speed && step.t < 5.0) step.tick();
      ASSERT_EQ(step.lane.phase, LegPhase::transfer);
      Vector3 target = step.lane.p_BF + along(0.15, to);
      target.z() = kGround;
      step.retarget(target);
      double most = 0.0;
      while (!step.ended() && step.t < 5.0) {
        const Vector2 v = step.lane.v_O.head<2>();
        step.tick();
        most = std::max(most, (step.lane.v_O.head<2>() - v).norm() / dt);
      }
      ASSERT_TRUE(step.ended());
      EXPECT_LT(most, 1.5 * hardest) << dt << " s, turned by " << to;
      EXPECT_LT((step.lane.p_BF - step.target).head<2>().norm(), 1e-3) << dt;
    }
  }
}

// Whatever happens to the foot on the way: the target jumps by up to 5 cm and drifts, and something
// knocks the set point by up to 3 mm. Minimum jerk over D in T has a peak speed of 1.875 D/T and a
// peak acceleration of 5.774 D/T² per axis; a jump e of the target, or of the foot, with T left adds
// at most (60 e/T³)(T/3) = 20 e/T²; the vertical axis adds its own.
TEST(SwingPeriod, ConvergesWithoutOvershootWhateverHappensOnTheWay) {
  RandomSequence random{.seed = 11};
  for (int run = 0; run < 3000; ++run) {
    const double dt = run % 2 == 0 ? random.uniform(0.001, 0.020) : kPeriods[run / 2 % 8];
    const double distance = random.uniform(0.02, 0.4), height = random.uniform(0.04, 0.22);
    Step step(dt, along(distance, random.uniform(-3.1, 3.1)), height);
    const bool jumps = random.u01() < 0.5, knocked = random.u01() < 0.5;
    const Vector3 drift = along(random.uniform(0.0, 0.1), random.uniform(-3.1, 3.1));
    double farthest = distance, largest_jump = 0.0;
    while (!step.ended() && step.t < 4.0) {
      const bool aims =
          step.lane.phase != LegPhase::descend && step.lane.phase != LegPhase::support;
      if (aims) {
        Vector3 to = step.target + drift * dt;
        if (jumps && random.u01() < 2.0 * dt) {
          const Vector3 jump = along(random.uniform(0.0, 0.05), random.uniform(-3.1, 3.1));
          to += jump, largest_jump = 0.05;
        }
        step.retarget(to);
        if (knocked && step.lane.phase == LegPhase::transfer) {
          step.lane.p_BF +=
              along(random.uniform(0.0, 0.003) * std::sqrt(dt / 0.02), random.uniform(-3.1, 3.1));
        }
      }
      farthest = std::max(farthest, step.target.norm());
      step.tick();
      // Past the target by no more than 2.4 % of the way, a jump of the target and what the knocks
      // sum up to.
      ASSERT_LT(step.lane.p_BF.head<2>().norm(), 1.024 * farthest + 2.0 * largest_jump + 0.01)
          << dt << ", run " << run;
      ASSERT_LT(step.apex, step.lane.apex_z + 0.024 * height + 1e-6) << dt << ", run " << run;
      ASSERT_TRUE(step.lane.v_O.allFinite() && step.lane.a_O.allFinite());
    }
    ASSERT_TRUE(step.ended()) << dt << ", run " << run << ", " << to_string(step.lane.phase);
    ASSERT_LT((step.lane.p_BF - step.target).head<2>().norm(), 0.03 + largest_jump) << dt;
    const double T = step.params.transfer_time, T_least = 0.05;
    const double way = farthest + largest_jump;
    ASSERT_LT(step.hardest, 1.25 * 5.774 * way / (T * T) +
                                20.0 * (largest_jump + 0.01) / (T_least * T_least) +
                                1.25 * 5.774 * height / 0.04 + step.params.vertical_acceleration);
  }
}

// Two samples that are confirm_time apart, with contact in all between: never one alone.
TEST(SwingPeriod, NeedsMoreThanOneInstantToConfirmAFoothold) {
  for (const double dt : kPeriods) {
    SwingParams params = testing::round_params().swing;
    LegLane lane;
    lane.confirmed = false;
    int ticks = 0;
    while (!lane.supports(params) && ticks < 100) {
      sense(lane, true, dt, params);
      advance(lane, {.contact = true}, {}, dt, params);
      ++ticks;
    }
    EXPECT_EQ(ticks, std::ceil(params.confirm_time / dt - 1e-9)) << dt;
  }
}

// A scripted search keeps to its speed and its acceleration, and finds the ground a centimetre
// below at the same time.
TEST(SwingPeriod, SearchesAtTheSameSpeed) {
  for (const double dt : kPeriods) {
    LegLane lane;
    lane.phase = LegPhase::search;
    lane.cleared = true;
    lane.v_O = {0.2, 0.0, 0.1};
    SwingParams params = testing::round_params().swing;
    params.reflexes = false;
    double t = 0.0;
    while (lane.phase == LegPhase::search && t < 2.0) {
      const Vector3 v = lane.v_O;
      const bool contact = lane.p_BF.z() < -0.05;
      sense(lane, contact, dt, params);
      advance(lane, {.contact = contact, .turn = turning_time(lane, {}, params)}, {}, dt, params);
      if (lane.phase != LegPhase::search) break;
      t += dt;
      ASSERT_LE((lane.v_O - v).norm(), params.vertical_acceleration * dt * (1.0 + 1e-9));
      ASSERT_GE(lane.v_O.z(), -params.search_speed - 1e-12);
    }
    // v from 0.1 to that near the expected ground, 1 mm a period, at 6 m/s² along the change of
    // velocity; that for six periods; then 0.15 m/s. Either change of speed, and the contact, come
    // within a period of their time.
    const double slow = std::min(0.15, 0.001 / dt), first = std::hypot(0.2, 0.1 + slow) / 6.0;
    const double there = std::max(0.0, 6.0 * dt - first), second = (0.15 - slow) / 6.0;
    const double risen = 0.5 * (0.1 - slow) * first - slow * there - 0.5 * (slow + 0.15) * second;
    EXPECT_NEAR(t, first + there + second + (0.05 + risen) / 0.15, 2.0 * dt) << dt;
  }
}

}  // namespace
}  // namespace hexagait::leg_lane_period_test

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <functional>
#include <hexagait/executor/leg_lane.hpp>
#include <testing/round_params.hpp>

/// What robots do to a step: contacts that lie, walls without end, ticks without a measurement.

namespace hexagait {
namespace {

/// A step over the plane z = 0 under a body at rest.
struct Step {
  double dt = 0.002;
  SwingParams params = testing::round_params().swing;
  LegLane lane;
  Vector3 measured = Vector3::Zero();
  bool lies = false;  ///< the contact says what is not
  double t = 0.0;

  explicit Step(const Vector3& way = {0.3, 0.0, 0.0}) {
    lane.time = 1.0;
    command(lane, {0, way, 0.1}, {});
  }
  double pursuit = 0.05;  // [m/s]
  bool contact() const { return (lane.p_BF.z() <= 0.0) != lies; }
  void tick() {
    measured = lane.p_BF;
    sense(lane, contact(), dt, params);
    advance(lane, {.contact = contact(), .pursuit = pursuit}, {}, dt, params);
    t += dt;
  }
  bool ended() const { return t > 0.1 && lane.supports(params); }
};

double duration(double dt, const std::function<bool(const Step&)>& lies) {
  Step step;
  step.dt = dt;
  while (!step.ended() && step.t < 4.0) {
    step.lies = lies(step);
    step.tick();
    EXPECT_EQ(step.lane.retreats, 0);
  }
  EXPECT_NEAR(step.lane.p_BF.x(), 0.3, 0.005);
  EXPECT_NEAR(step.lane.p_BF.z(), 0.0, 0.003);
  return step.t;
}

// One sample of contact on the way, whenever: no retreat and no foothold in the air. On the way
// over it costs nothing; on the way down the foot waits for lost_time and a tick, and gains its
// speed of at most 0.3 m/s anew at 6 m/s², 50 ms in which it makes half the way.
TEST(FalseContact, CostsNextToNothingAtAnyInstant) {
  for (const double dt : {0.002, 0.005}) {
    const double plain = duration(dt, [](const Step&) { return false; });
    for (double at = 0.1; at < plain - 0.05; at += 0.017) {
      const double t = duration(dt, [&](const Step& s) {
        return s.t >= at && s.t < at + 0.99 * dt && s.lane.p_BF.z() > 0.01;
      });
      EXPECT_LE(t, plain + 0.03 + 0.025 + 2.0 * dt) << "at " << at << " s, period " << dt;
    }
  }
}

// A foot that has landed and bounces for 4 ms stands on: it goes after its ground by 0.05 mm each time.
TEST(FalseContact, ABounceIsNoReasonToGoDownAgain) {
  Step step;
  while (step.lane.phase != LegPhase::descend) step.tick();
  while (step.lane.phase != LegPhase::support) step.tick();
  const double z = step.lane.p_BF.z();
  for (int k = 0; k < 20; ++k) {
    step.lies = k % 4 < 2;  // 4 ms off, 4 ms on
    step.tick();
    EXPECT_EQ(step.lane.phase, LegPhase::support);
    EXPECT_NEAR(step.lane.p_BF.z(), z, 0.3e-3);
    EXPECT_FALSE(step.lane.supports(step.params));
  }
}

// (swing 6) For 20 ms: at 6 m/s² to 0.05 m/s, v (t − v/(2 a)). Not beyond the end of the leg, nor if it carries load.
TEST(LostContact, IsPursuedByTheFoot) {
  for (const double dt : {0.001, 0.002, 0.005}) {
    const auto sunk = [dt](LegSensed sensed) {
      Step step;
      LegLane lane;
      const Pose tilted{rotation(Vector3(0.0, 0.5, 0.0)), Vector3::Zero()};
      for (int k = 0; k < std::lround(0.02 / dt); ++k) {
        sense(lane, sensed.contact, dt, step.params);
        advance(lane, sensed, tilted, dt, step.params);
      }
      EXPECT_EQ(lane.phase, LegPhase::support);
      return Vector3(tilted.R * lane.p_BF);
    };
    const Vector3 down = sunk({.pursuit = 0.05});
    EXPECT_NEAR(down.z(), -0.05 * (0.02 - 0.05 / (2.0 * 6.0)), 1e-6) << dt;
    EXPECT_LT(down.head<2>().norm(), 1e-12) << "along gravity";
    EXPECT_EQ(sunk({.contact = true, .pursuit = 0.05}).norm(), 0.0);
    EXPECT_EQ(sunk({.reachable = false, .pursuit = 0.05}).norm(), 0.0);
    EXPECT_EQ(sunk({.off = {0.0, 0.0, 0.005}, .pursuit = 0.05}).norm(), 0.0);
    EXPECT_EQ(sunk({}).norm(), 0.0) << "late drives";
  }
}

// Support has the full load, so that no neighbour lifts before.
TEST(Foothold, CountsWhenItCarriesItsFullLoad) {
  for (const double load_time : {0.02, 0.04, 0.1}) {
    Step step;
    step.params.load_time = load_time;
    double landed = -1.0;
    while (!step.ended() && step.t < 4.0) {
      step.tick();
      if (landed < 0.0 && step.t > 0.2 && step.lane.phase == LegPhase::support) landed = step.t;
    }
    EXPECT_EQ(step.lane.load, 1.0);
    EXPECT_NEAR(step.t - landed, std::max(load_time, step.params.confirm_time), 1.5 * step.dt);
  }
}

// The leg is stopped in the air, at x = 0.1, at any height: shin against a pole. Its set point
// comes back to it, without velocity.
TEST(Retreat, LetsGoOfWhatBlocksTheFoot) {
  Step step;
  while (step.lane.phase != LegPhase::retreat && step.t < 2.0) {
    const Vector3 foot(std::min(0.1, step.lane.p_BF.x()), 0.0, step.lane.p_BF.z());
    const Vector3 off = foot - step.lane.p_BF;
    advance(step.lane, {.tracking_error = off.norm(), .off = off}, {}, step.dt, step.params);
    step.t += step.dt;
  }
  ASSERT_EQ(step.lane.phase, LegPhase::retreat);
  EXPECT_NEAR(step.lane.p_BF.x(), 0.1, 1e-9);
  EXPECT_EQ(step.lane.v_O.norm(), 0.0);
  for (int k = 0; k < 75; ++k) advance(step.lane, {}, {}, step.dt, step.params);
  EXPECT_NEAR(step.lane.p_BF.x(), 0.1 - step.params.retreat_back, 2e-3);
  EXPECT_LT(step.lane.v_O.head<2>().norm(), 0.05) << "it stops there";
}

// A pole all round: after max_retreats it goes back to where it stood, and the step ends.
TEST(Retreat, HasAnEnd) {
  Step step;
  double highest = 0.0;
  while (!step.ended() && step.t < 10.0) {
    const Vector3 foot(std::clamp(step.lane.p_BF.x(), -0.02, 0.02), 0.0, step.lane.p_BF.z());
    const Vector3 off = foot - step.lane.p_BF;
    const bool contact = step.lane.p_BF.z() <= 0.0;
    sense(step.lane, contact, step.dt, step.params);
    advance(step.lane, {.contact = contact, .tracking_error = off.norm(), .off = off}, {}, step.dt,
            step.params);
    step.t += step.dt;
    highest = std::max(highest, step.lane.p_BF.z());
  }
  EXPECT_TRUE(step.ended());
  EXPECT_LE(step.lane.retreats, step.params.max_retreats);
  EXPECT_LE(highest, 0.1 + 6.0 * step.params.retreat_up + 0.01) << "two rises, two of twice that";
  EXPECT_NEAR(step.lane.p_BF.x(), 0.0, 0.02);
}

// An apex out of reach is lowered to where the leg ends; it is not pushed up with every try.
TEST(Retreat, LowersAnApexThatTheLegCannotReach) {
  Step step;
  step.params.max_rise = 1.2;
  command(step.lane, {0, {0.3, 0.0, 0.0}, 0.5}, {});
  bool reachable = true;
  while (!step.ended() && step.t < 5.0) {
    sense(step.lane, step.contact(), step.dt, step.params);
    advance(step.lane, {.contact = step.contact(), .reachable = reachable}, {}, step.dt,
            step.params);
    step.t += step.dt;
    reachable = step.lane.p_BF.z() <= 0.2;
    if (!reachable) step.lane.p_BF.z() = 0.2, step.lane.v_O.z() = 0.0;  // as the executor does
  }
  EXPECT_TRUE(step.ended());
  EXPECT_EQ(step.lane.retreats, 0);
  EXPECT_LE(step.lane.apex_z, 0.2);
  EXPECT_NEAR(step.lane.p_BF.x(), 0.3, 0.005);
}

// 1.875 h/T within the bound; a low step takes the usual time.
TEST(Lift, TakesLongerWhereTheJointsAreTooSlow) {
  for (const double height : {0.05, 0.1, 0.2, 0.3}) {
    Step step;
    step.params.max_rise = 1.2;
    command(step.lane, {0, {0.3, 0.0, 0.0}, height}, {});
    double fastest = 0.0;
    while (!step.ended() && step.t < 5.0) {
      step.tick();
      fastest = std::max(fastest, step.lane.v_O.z());
    }
    EXPECT_LT(fastest, std::min(1.2, 1.875 * height / step.params.lift_time) * 1.02) << height;
    EXPECT_GT(fastest, 0.6 * std::min(1.2, 1.875 * height / step.params.lift_time)) << height;
  }
}

// Without a measurement a foot goes on and brakes with 12 m/s²; nothing jumps, and at the next
// measurement the step goes on to the same foothold.
TEST(Coasting, ChangesNoVelocityFasterThanTheBrakeAndEndsAtRest) {
  for (const double dt : {0.001, 0.002, 0.01, 0.02}) {
    for (double at = 0.06; at < 0.8; at += 0.05) {
      Step step;
      step.dt = dt;
      while (step.t < at) step.tick();
      const LegPhase phase = step.lane.phase;
      if (step.lane.on_ground()) continue;
      for (int k = 0; k * dt < 0.5; ++k) {
        const Vector3 p = step.lane.p_BF, v = step.lane.v_O;
        coast(step.lane, {}, dt, step.params);
        const double most = 2.0 * step.params.vertical_acceleration * dt * (1.0 + 1e-9);
        ASSERT_LE((step.lane.v_O - v).norm(), most);
        ASSERT_LE((step.lane.p_BF - p - 0.5 * dt * (v + step.lane.v_O)).norm(), 0.5 * most * dt);
        ASSERT_EQ(step.lane.phase, phase);
      }
      ASSERT_EQ(step.lane.v_O.norm(), 0.0);
      if (phase == LegPhase::descend) continue;  // it may have coasted into the ground
      while (!step.ended() && step.t < 5.0) step.tick();
      EXPECT_NEAR(step.lane.p_BF.x(), 0.3, 0.005) << at;
    }
  }
}

/// A leg that stands on its shin: no contact, and its foot is held `up` above its set point.
struct Leaning {
  SwingParams params = testing::round_params().swing;
  LegLane lane;
  bool needed = true, reachable = true;
  double up = 0.0;              // [m]
  double tracking_error = 0.0;  // [m]

  Leaning() { lane.time = 1.0; }
  void tick(double seconds) {
    constexpr double kDt = 0.002;
    for (int k = 0; k * kDt < seconds; ++k) {
      sense(lane, false, kDt, params);
      advance(lane,
              {.tracking_error = tracking_error,
               .reachable = reachable,
               .off = {0.0, 0.0, up},
               .needed = needed},
              {}, kDt, params);
    }
  }
};

// [PC04] says nothing of shins. A robot that would fall without the leg keeps its load on it.
TEST(LostContact, KeepsTheLoadOfALegThatTheRobotNeeds) {
  Leaning leg, other;
  other.needed = false;
  leg.up = other.up = 0.5 * leg.params.blocked_error;
  for (Leaning* one : {&leg, &other}) one->tick(1.2 * one->params.regain_time);
  EXPECT_EQ(leg.lane.load, 1.0);
  EXPECT_EQ(other.lane.load, 0.0);
  leg.tick(0.5);
  EXPECT_EQ(leg.lane.phase, LegPhase::descend);
  EXPECT_EQ(leg.lane.load, 1.0);
  EXPECT_GT(leg.lane.p_BF.z(), -0.2 * leg.params.blocked_error) << "it pushes";
}

// A foot without load goes down to find the ground, whoever needs it.
TEST(LostContact, GoesDownWhereNothingCarries) {
  Leaning leg;
  leg.tick(0.5);
  EXPECT_EQ(leg.lane.phase, LegPhase::descend);
  EXPECT_LT(leg.lane.p_BF.z(), -0.03);
}

// Held up and blocked, it would retreat, and the robot fall over it; it may once others carry the robot.
TEST(LostContact, DoesNotRetreatWhileTheRobotNeedsTheLeg) {
  Leaning leg;
  leg.tracking_error = 2.0 * leg.params.blocked_error;
  leg.tick(0.5);
  EXPECT_EQ(leg.lane.retreats, 0);
  leg.needed = false;
  leg.tick(0.1);
  EXPECT_EQ(leg.lane.retreats, 1);
}

// At the end of the leg it carries nothing and will not.
TEST(LostContact, EndsInAHoleWhoeverNeedsTheLeg) {
  Leaning leg;
  leg.tick(1.2 * leg.params.regain_time);
  EXPECT_EQ(leg.lane.retreats, 0);
  leg.reachable = false;
  leg.tick(0.1);
  EXPECT_GT(leg.lane.retreats, 0);
}

}  // namespace
}  // namespace hexagait

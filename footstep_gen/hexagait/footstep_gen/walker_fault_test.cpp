// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/footstep_gen/walker.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <limits>
#include <string>
#include <testing/argos.hpp>
#include <testing/control_period.hpp>
#include <testing/kinematic_plant.hpp>
#include <vector>

namespace hexagait::footstep_gen::walker_fault_test {
namespace {

using heading_control::Heading;
using hexagait::testing::argos;
using hexagait::testing::kDt;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

struct Walk {
  Walker walker{argos()};
  testing::KinematicPlant plant{argos(), 0.5, {.seed = 13}};

  Walk() { walker.start(plant.measurement); }
  const TickRecord& tick(const Heading& heading = Heading::arc(1.5, 0.2)) {
    const TickRecord& record = walker.tick(PlantStatus::fresh, plant.measurement, heading);
    plant.follow(record, kDt);
    return record;
  }
  void walk(int ticks) {
    for (int k = 0; k < ticks; ++k) tick();
  }
};

bool same(const JointTargets& a, const JointTargets& b) {
  for (LegId i = 0; i < 6; ++i)
    if (a.q[i] != b.q[i] || a.qd[i] != b.qd[i] || a.effort[i] != b.effort[i]) return false;
  return true;
}

bool finite(const JointTargets& targets) {
  for (LegId i = 0; i < 6; ++i)
    if (!targets.q[i].allFinite() || !targets.qd[i].allFinite() || !targets.effort[i].allFinite())
      return false;
  return true;
}

/// The targets stay as they are and finite, without velocity, whatever comes.
void expect_stopped_for_good(Walk walk, Fault fault) {
  EXPECT_EQ(walk.walker.record().fault, fault);
  const JointTargets targets = walk.walker.record().targets;
  EXPECT_TRUE(finite(targets));
  for (const LegJoints& qd : targets.qd) EXPECT_EQ(qd.norm(), 0.0);
  for (int k = 0; k < 200; ++k) {
    const TickRecord& record = walk.tick(k % 2 == 0 ? Heading::straight(0.0) : Heading::stop());
    ASSERT_EQ(record.fault, fault) << "the first fault stays";
    ASSERT_TRUE(same(record.targets, targets));
  }
}

// Wherever in a step it comes: set points are those of the tick before.
TEST(WalkerFault, StopsAtOnceAtANumberThatIsNone) {
  for (int ticks = 1; ticks < 800; ticks += 61) {
    for (const double bad : {kNan, std::numeric_limits<double>::infinity()}) {
      Walk walk;
      walk.walk(ticks);
      const LegArray<LegJoints> q = walk.walker.record().targets.q;
      walk.plant.measurement.q[ticks % 6][ticks % 3] = bad;
      walk.walker.tick(PlantStatus::fresh, walk.plant.measurement, Heading::straight(0.0));
      for (LegId i = 0; i < 6; ++i) ASSERT_EQ(walk.walker.record().targets.q[i], q[i]);
      walk.plant.measurement.q[ticks % 6][ticks % 3] = 0.0;
      expect_stopped_for_good(walk, Fault::bad_measurement);
    }
  }
}

TEST(WalkerFault, StopsAtAMeasurementOfAnotherRobot) {
  const RobotModel four_legged = testing::robot_of(4);
  const Measurement other = testing::KinematicPlant(four_legged, 0.0, {}).measurement;
  for (int spoilt = 0; spoilt < 4; ++spoilt) {
    Walk walk;
    walk.walk(300);
    Measurement measurement = walk.plant.measurement;
    if (spoilt == 0) measurement.q = other.q;
    if (spoilt == 1) measurement.contact = other.contact;
    if (spoilt == 2) measurement.contact = {};
    if (spoilt == 3) measurement.time = kNan;
    walk.walker.tick(PlantStatus::fresh, measurement, Heading::straight(0.0));
    expect_stopped_for_good(walk, Fault::bad_measurement);
  }
}

// Nothing has begun yet: the caller hears of it, and a walker that walks already goes on.
TEST(WalkerFault, RefusesToStartFromANumberThatIsNone) {
  Walk walk;
  walk.walk(300);
  Measurement measurement = walk.plant.measurement;
  measurement.q[4][1] = kNan;
  EXPECT_THROW(walk.walker.start(measurement), InvalidInput);
  measurement = walk.plant.measurement;
  measurement.contact = {};
  EXPECT_THROW(walk.walker.start(measurement), InvalidInput);
  walk.walk(300);
  EXPECT_EQ(walk.walker.record().fault, Fault::none);
}

// Only start() takes a fault away.
TEST(WalkerFault, IsClearedByANewStart) {
  Walk walk;
  walk.walker.emergency_stop();
  EXPECT_EQ(walk.tick().fault, Fault::emergency_stop);
  walk.walker.start(walk.plant.measurement);
  EXPECT_EQ(walk.tick().fault, Fault::none);
}

// A lift is an event of one tick: one in which nothing was decided has none, whatever was before.
TEST(WalkerFault, LiftsNothingWhileThePlantIsLate) {
  Walk walk;
  while (walk.tick().lifts.empty()) {
  }
  EXPECT_TRUE(walk.walker.tick(PlantStatus::late, walk.plant.measurement, Heading::straight(0.0))
                  .lifts.empty());
}

/// Largest change of any joint's velocity between two ticks [rad/s].
double jump(const JointTargets& a, const JointTargets& b) {
  double most = 0.0;
  for (LegId i = 0; i < a.qd.size(); ++i)
    most = std::max(most, (a.qd[i] - b.qd[i]).cwiseAbs().maxCoeff());
  return most;
}

double speed(const JointTargets& targets) {
  double most = 0.0;
  for (const LegJoints& qd : targets.qd) most = std::max(most, qd.cwiseAbs().maxCoeff());
  return most;
}

// The base brakes with 1.2 m/s², a foot in haste with 1.4² · 6 m/s², at a hip some 0.2 m away: 65 rad/s²,
// and 84 for the curvature of the legs' motions, (2.75 m/s)²/(0.3 m)². A stop in one tick would be
// 2.75 m/s / 0.3 m.
constexpr double kMostAcceleration = 149.0;  // [rad/s²]

// Late for 0.1 s, from any instant of a step on, with a plant that goes on with what it is told.
// Nothing stops at once, nothing starts at once, and the robot walks on.
TEST(WalkerFault, CoastsWhileThePlantIsLateAndGoesOn) {
  for (int ticks = 300; ticks < 800; ticks += 37) {
    Walk walk;
    walk.walk(ticks);
    for (int k = 0; k < 49; ++k) {
      const JointTargets before = walk.walker.record().targets;
      const TickRecord& record =
          walk.walker.tick(PlantStatus::late, walk.plant.measurement, Heading::straight(0.0));
      walk.plant.follow(record, kDt);
      ASSERT_TRUE(record.holding);
      ASSERT_EQ(record.fault, Fault::none);
      ASSERT_LT(jump(record.targets, before), kMostAcceleration * kDt) << ticks << " " << k;
      for (LegId i = 0; i < 6; ++i)
        ASSERT_LT((record.targets.q[i] - before.q[i] - kDt * record.targets.qd[i]).norm(), 1e-12);
    }
    const JointTargets before = walk.walker.record().targets;
    walk.tick();
    EXPECT_LT(jump(walk.walker.record().targets, before), 2.0 * kMostAcceleration * kDt) << ticks;
    const double x = walk.plant.X_OB.p.norm();
    for (int k = 0; k < 2000; ++k) ASSERT_FALSE(walk.tick().holding);
    EXPECT_EQ(walk.walker.record().fault, Fault::none);
    EXPECT_GT(std::abs(walk.plant.X_OB.p.norm() - x), 0.05) << "walks again";
  }
}

// From 0.6 m/s the base stops within 0.5 s, from 2 m/s a foot within 0.17 s.
TEST(WalkerFault, GivesUpWhenThePlantIsLateForTooLongAndComesToRest) {
  for (int ticks = 300; ticks < 800; ticks += 37) {
    Walk walk;
    walk.walk(ticks);
    int periods = 0;
    for (; walk.walker.record().fault == Fault::none && periods < 1000; ++periods)
      walk.walker.tick(PlantStatus::late, walk.plant.measurement, Heading::straight(0.0));
    EXPECT_NEAR(periods * kDt, walk.walker.params().late_limit, 1.5 * kDt);
    for (; periods * kDt < 0.55; ++periods) {
      const JointTargets before = walk.walker.record().targets;
      walk.walker.tick(PlantStatus::late, walk.plant.measurement, Heading::straight(0.0));
      ASSERT_LT(jump(walk.walker.record().targets, before), kMostAcceleration * kDt);
    }
    EXPECT_EQ(speed(walk.walker.record().targets), 0.0);
    expect_stopped_for_good(walk, Fault::plant_late);
  }
}

// It does not wait until the robot has come to rest.
TEST(WalkerFault, AnEmergencyStopEndsTheCoastingOfARobotThatWasLate) {
  for (int ticks = 300; ticks < 800; ticks += 111) {
    Walk walk;
    walk.walk(ticks);
    while (walk.walker.record().fault == Fault::none)
      walk.walker.tick(PlantStatus::late, walk.plant.measurement, Heading::straight(0.0));
    walk.walker.emergency_stop();
    expect_stopped_for_good(walk, Fault::emergency_stop);
  }
}

// The clocks go by the time that has passed, not by the ticks that were in time.
TEST(WalkerFault, CountsLatePeriodsAsTime) {
  Walk walk;
  for (int k = 0; k < 3000; ++k) {
    if (k % 4 == 3) {
      const TickRecord& record =
          walk.walker.tick(PlantStatus::late, walk.plant.measurement, Heading::straight(0.0));
      walk.plant.follow(record, kDt);
    } else {
      walk.tick(Heading::straight(0.0));
    }
  }
  EXPECT_EQ(walk.walker.record().fault, Fault::none);
  EXPECT_GT(walk.plant.X_OB.p.x(), 0.5 * 6.0 * 0.2) << "it walks";
  EXPECT_LT(walk.plant.X_OB.p.x(), 1.1 * 6.0 * 0.24) << "no faster than in time";
}

// Single late periods, half of them all, are no silence.
TEST(WalkerFault, ForgivesLatePeriodsThatAreNotInARow) {
  Walk walk;
  for (int k = 0; k < 1000; ++k) {
    walk.walker.tick(PlantStatus::late, walk.plant.measurement, Heading::straight(0.0));
    ASSERT_EQ(walk.tick().fault, Fault::none);
  }
}

TEST(WalkerFault, StopsWhenThePlantIsClosed) {
  Walk walk;
  walk.walk(333);
  walk.walker.tick(PlantStatus::closed, walk.plant.measurement, Heading::straight(0.0));
  expect_stopped_for_good(walk, Fault::plant_closed);
}

TEST(WalkerFault, StopsInAnEmergency) {
  Walk walk;
  walk.walk(333);
  walk.walker.emergency_stop();
  expect_stopped_for_good(walk, Fault::emergency_stop);
}

// A heading is checked when it is made, and a velocity that is none stops on the path; a limit of
// speed that is none can only be a mistake of the program. 0 and no limit are ones.
TEST(WalkerFault, StopsAtASpeedLimitThatIsNone) {
  for (const double bad : {-1.0, -1e-300, kNan, -std::numeric_limits<double>::infinity()}) {
    Walk walk;
    walk.walk(333);
    walk.walker.tick(PlantStatus::fresh, walk.plant.measurement, {Heading::straight(0.0), bad});
    expect_stopped_for_good(walk, Fault::bad_command);
  }
  for (const double good : {0.0, 0.1, std::numeric_limits<double>::infinity()}) {
    Walk walk;
    walk.walk(333);
    walk.walker.tick(PlantStatus::fresh, walk.plant.measurement, {Heading::straight(0.0), good});
    EXPECT_EQ(walk.walker.record().fault, Fault::none) << good;
  }
}

TEST(WalkerFault, TakesAVelocityThatIsNoneAsAStop) {
  Walk walk;
  walk.walk(333);
  const heading_control::HeadingCommand command = heading_control::from_twist(
      {{kNan, 0.1}, 0.0}, nominal_stance(argos()), walk.walker.record().heading);
  const TickRecord& record = walk.walker.tick(PlantStatus::fresh, walk.plant.measurement, command);
  EXPECT_EQ(record.fault, Fault::none);
  EXPECT_FALSE(record.heading.moving());
}

// Parameters that no range forbids, though nothing can be made of them: a swing higher than numbers
// go, a weight that is none. What was commanded last is held.
TEST(WalkerFault, StopsWhenParametersLeadToTargetsThatAreNone) {
  std::vector<WalkerParams> absurd(2);
  absurd[0].step.height = absurd[0].step.max_height = std::numeric_limits<double>::max();
  absurd[1].executor.gravity = std::numeric_limits<double>::max();
  for (const WalkerParams& params : absurd) {
    Walk walk;
    walk.walker = Walker(argos(), params);
    walk.walker.start(walk.plant.measurement);
    for (int k = 0; k < 1000 && walk.walker.record().fault == Fault::none; ++k) {
      ASSERT_TRUE(finite(walk.tick().targets)) << k;
    }
    expect_stopped_for_good(walk, Fault::bad_command);
  }
}

// The same bits from the same measurements, and from a copy made in the middle of a step.
TEST(WalkerDeterminism, GivesTheSameBitsTwiceAndFromACopy) {
  Walk one, other;
  RandomSequence random{.seed = 14, .stream = RandomStream::commands};
  Heading heading = Heading::straight(0.0);
  for (int k = 0; k < 5000; ++k) {
    if (k % 400 == 0) heading = Heading::arc(random.uniform(0.2, 3.0), random.uniform(-3.1, 3.1));
    if (k == 2345) other = one;
    ASSERT_TRUE(same(one.tick(heading).targets, other.tick(heading).targets)) << "tick " << k;
  }
}

TEST(WalkerDeterminism, StartsAfreshFromWhateverState) {
  Walk used, fresh;
  used.walk(1234);
  used.walker.start(fresh.plant.measurement);
  used.plant = fresh.plant;
  for (int k = 0; k < 2000; ++k) ASSERT_TRUE(same(used.tick().targets, fresh.tick().targets));
}

// A tick before start(): the joints are held where they are measured, whatever the heading.
TEST(WalkerFault, HoldsTheRobotWhereItIsBeforeItIsStarted) {
  Walker walker(argos());
  EXPECT_EQ(walker.record().fault, Fault::not_started);
  EXPECT_TRUE(finite(walker.record().targets));
  testing::KinematicPlant plant{argos(), 0.5, {.seed = 13}};
  Measurement spoilt = plant.measurement;
  spoilt.q[2][1] = kNan;
  for (const PlantStatus status : {PlantStatus::fresh, PlantStatus::late, PlantStatus::closed}) {
    const TickRecord& record = walker.tick(status, plant.measurement, Heading::straight(0.0));
    EXPECT_EQ(record.fault, Fault::not_started);
    for (LegId i = 0; i < 6; ++i) {
      EXPECT_EQ(record.targets.q[i], plant.measurement.q[i]);
      EXPECT_EQ(record.targets.qd[i].norm(), 0.0);
      EXPECT_EQ(record.targets.effort[i].norm(), 0.0);
    }
    walker.tick(status, spoilt, Heading::straight(0.0));
    EXPECT_TRUE(finite(walker.record().targets));
    walker.tick(status, {}, Heading::straight(0.0));
    EXPECT_EQ(walker.record().targets.q.size(), 6);
    EXPECT_TRUE(finite(walker.record().targets));
  }
  walker.start(plant.measurement);
  EXPECT_EQ(walker.record().fault, Fault::none);
  EXPECT_EQ(walker.tick(PlantStatus::fresh, plant.measurement, Heading::straight(0.0)).fault,
            Fault::none);
}

void refuses(const WalkerParams& params, const std::vector<std::string>& words) {
  try {
    const Walker walker(argos(), params);
    ADD_FAILURE() << "accepted, though it should name " << words.front();
  } catch (const InvalidInput& error) {
    for (const std::string& word : words)
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
  }
}

WalkerParams with_period(double dt) {
  WalkerParams params;
  params.control_dt = dt;
  return params;
}

// Name, value, unit and range; all of them at once.
TEST(WalkerParams, ThatAreOutOfRangeAreNamed) {
  for (const double dt :
       {0.0, -0.002, 0.0009, 0.021, 0.5, kNan, std::numeric_limits<double>::infinity()})
    refuses(with_period(dt), {"control_dt [s]", "1 to 20 ms"});
  refuses(with_period(0.5), {"0.5"});
  for (const double duty : {0.49, 1.0, -1.0, kNan}) {
    WalkerParams wave;
    wave.stepper = {gait_state::Stepping::wave, duty};
    refuses(wave, {"duty_factor", "at least 0.5 and less than 1"});
  }

  WalkerParams params;
  params.control_dt = 0.05;
  params.step.stroke = -0.1;
  params.executor.swing.transfer_time = 0.0;
  params.executor.base.acceleration = -1.0;
  params.late_limit = kNan;
  refuses(params, {"control_dt", "0.05", "stroke [m]", "transfer_time [s]", "acceleration [m/s²]",
                   "late_limit [s]"});

  for (const double dt : {0.001, 0.004, 0.02}) EXPECT_NO_THROW(Walker(argos(), with_period(dt)));
  Walk walk;
  EXPECT_THROW(walk.walker.set_stepping({gait_state::Stepping::wave, 1.0}), InvalidInput);
  walk.walk(10);
  EXPECT_EQ(walk.walker.params().stepper.duty_factor, 0.5);
}

}  // namespace
}  // namespace hexagait::footstep_gen::walker_fault_test

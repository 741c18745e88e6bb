// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <hexagait/sim3d/world.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/walk/faults/faults.hpp>
#include <hexagait/walk/trial.hpp>
#include <limits>
#include <testing/argos.hpp>
#include <testing/control_period.hpp>

// Each fault, measured on a plant whose truth is known.
namespace hexagait::walk {
namespace {

const LegArray<LegJoints> kZero(6, LegJoints::Zero());

using testing::argos;
using testing::kDt;

// Its joints turn at 1 rad/s, and its feet touch as told; it keeps all that is written to it.
class KnownPlant final : public Plant {
 public:
  PlantStatus read(Measurement& measurement) override {
    measurement = {time, LegArray<LegJoints>(6, LegJoints::Constant(time)), contact};
    time += kDt;
    return status;
  }
  void write(const JointTargets& targets) override { written.push_back(targets); }

  double time = 0.0;
  PlantStatus status = PlantStatus::fresh;
  LegArray<bool> contact = LegArray<bool>(6, false);
  std::vector<JointTargets> written;
};

// Targets of all joints, moving at a speed.
JointTargets targets_at(double q, double qd = 0.0) {
  return {LegArray<LegJoints>(6, LegJoints::Constant(q)),
          LegArray<LegJoints>(6, LegJoints::Constant(qd)),
          LegArray<LegJoints>(6, LegJoints::Constant(7.0)),
          LegArray<ControlMode>(6, ControlMode::effort)};
}

// Joint readings less the truth, of many control periods.
std::vector<double> errors_of(const PlantFaults& faults, int ticks, std::uint64_t seed = 1) {
  KnownPlant inner;
  FaultyPlant plant(inner, argos(), faults, kDt, seed);
  std::vector<double> errors;
  Measurement sensed;
  for (int k = 0; k < ticks; ++k) {
    plant.read(sensed);
    for (LegId leg = 0; leg < 6; ++leg)
      for (int j = 0; j < 3; ++j) errors.push_back(sensed.q[leg][j] - sensed.time);
  }
  return errors;
}

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double sd(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += (value - mean(values)) * (value - mean(values));
  return std::sqrt(sum / static_cast<double>(values.size()));
}

double largest(const std::vector<double>& values) {
  double most = 0.0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

// Of 18 000 values the mean is known to 1 mrad/√18000 = 7.5 µrad and the deviation to 0.5 %.
TEST(PlantFaults, JointNoiseHasItsStandardDeviationAndIsWhite) {
  const std::vector<double> errors = errors_of({.joint_noise = 1e-3}, 1000);
  EXPECT_NEAR(mean(errors), 0.0, 4 * 7.5e-6);
  EXPECT_NEAR(sd(errors), 1e-3, 2e-5);
  EXPECT_LE(largest(errors), 3.5e-3);
  double product = 0.0;  // of a joint's successive values, 18 apart
  for (std::size_t k = 18; k < errors.size(); ++k) product += errors[k] * errors[k - 18];
  EXPECT_NEAR(product / static_cast<double>(errors.size()), 0.0, 4 * 7.5e-9);
}

// Rounded to a step, an angle is off by up to half of it, uniformly: its deviation is step/√12.
TEST(PlantFaults, QuantisationRoundsToTheNearestStep) {
  const double step = 0.0071;
  const std::vector<double> errors = errors_of({.joint_quantisation = step}, 1000);
  EXPECT_LE(largest(errors), 0.5 * step + 1e-12);
  EXPECT_NEAR(sd(errors), step / std::sqrt(12.0), 0.05 * step);
  EXPECT_NEAR(mean(errors), 0.0, 0.02 * step);
}

// The sensor that is off is the servo's too: a joint that is sent where it reads stays there.
TEST(PlantFaults, ZeroErrorsStayAndShiftReadingsAndTargetsAlike) {
  KnownPlant inner;
  FaultyPlant plant(inner, argos(), {.joint_zero_error = 0.01}, kDt, 3);
  Measurement sensed;
  int up = 0;
  for (int k = 0; k < 5; ++k) {
    plant.read(sensed);
    JointTargets targets = targets_at(0.0);
    targets.q = sensed.q;
    plant.write(targets);
    for (LegId leg = 0; leg < 6; ++leg)
      for (int j = 0; j < 3; ++j) {
        const double error = sensed.q[leg][j] - sensed.time;
        EXPECT_NEAR(std::abs(error), 0.01, 1e-12);
        EXPECT_NEAR(inner.written.back().q[leg][j], sensed.time, 1e-12);
        up += k == 0 && error > 0.0 ? 1 : 0;
      }
  }
  EXPECT_GT(up, 3);
  EXPECT_LT(up, 15);
}

// Readings of a foot: the share that are closed.
double share_closed(const PlantFaults& faults, bool touches, int ticks = 10000) {
  KnownPlant inner;
  inner.contact = LegArray<bool>(6, touches);
  FaultyPlant plant(inner, argos(), faults, kDt, 1);
  Measurement sensed;
  int closed = 0;
  for (int k = 0; k < ticks; ++k) {
    plant.read(sensed);
    for (LegId leg = 0; leg < 6; ++leg) closed += sensed.contact[leg] ? 1 : 0;
  }
  return closed / (6.0 * ticks);
}

TEST(PlantFaults, ContactsAreFalseOrMissedAsOftenAsSaid) {
  EXPECT_NEAR(share_closed({.false_contacts = 0.02}, false), 0.02, 0.003);
  EXPECT_EQ(share_closed({.false_contacts = 0.02}, true), 1.0);
  EXPECT_NEAR(share_closed({.missed_contacts = 0.05}, true), 0.95, 0.005);
  EXPECT_EQ(share_closed({.missed_contacts = 0.05}, false), 0.0);
}

// A foot that touches at some time in a period of 2 ms and bounces for 4 ms after it: the readings
// 0 to 2 ms and 2 to 4 ms later are a lot, those after 4 ms are true.
TEST(PlantFaults, ABounceRattlesForItsTimeAfterEachChange) {
  KnownPlant inner;
  FaultyPlant plant(inner, argos(), {.contact_bounce = 0.004}, kDt, 1);
  Measurement sensed;
  plant.read(sensed);
  int wrong[3] = {};
  constexpr int kChanges = 2000;
  for (int change = 0; change < kChanges; ++change) {
    const bool touches = change % 2 == 0;
    inner.contact = LegArray<bool>(6, touches);
    for (int& count : wrong) {
      plant.read(sensed);
      count += sensed.contact[0] != touches ? 1 : 0;
    }
  }
  EXPECT_NEAR(wrong[0], 0.5 * kChanges, 0.05 * kChanges);
  EXPECT_NEAR(wrong[1], 0.5 * kChanges, 0.05 * kChanges);
  EXPECT_EQ(wrong[2], 0);
}

// 3 ms are one and a half periods: an angle that grows by 1 rad/s reads 3 mrad less.
TEST(PlantFaults, DelaysAreExactForAnyControlPeriod) {
  KnownPlant inner;
  FaultyPlant plant(inner, argos(), {.sensing_delay = 0.003, .command_delay = 0.005}, kDt, 1);
  Measurement sensed;
  for (int k = 0; k < 10; ++k) {
    inner.contact = LegArray<bool>(6, k >= 4);
    plant.read(sensed);
    EXPECT_EQ(sensed.time, k * kDt);
    EXPECT_EQ(sensed.contact[0], k >= 6) << k;
    if (k >= 2) {
      EXPECT_NEAR(sensed.q[2][1], sensed.time - 0.003, 1e-12);
    }
    plant.write(targets_at(sensed.time));
    if (k >= 3) {
      EXPECT_NEAR(inner.written.back().q[2][1], sensed.time - 0.005, 1e-12);
    }
  }
}

TEST(PlantFaults, ALateTickKeepsTheOldMeasurementAndLosesItsTargets) {
  KnownPlant inner;
  FaultyPlant plant(inner, argos(), {.late_ticks = 0.2}, kDt, 1);
  Measurement sensed;
  int late = 0;
  double sent = 0.0;
  constexpr int kTicks = 5000;
  for (int k = 0; k < kTicks; ++k) {
    const Measurement before = sensed;
    const PlantStatus status = plant.read(sensed);
    plant.write(targets_at(k, 3.0));
    if (status == PlantStatus::late) {
      ++late;
      EXPECT_EQ(sensed.time, before.time);
      sent += 3.0 * kDt;  // the servos go on
    } else {
      EXPECT_NEAR(sensed.time, inner.time - kDt, 1e-9);  // real time has passed
      sent = k;
    }
    EXPECT_NEAR(inner.written.back().q[1][0], sent, 1e-9);
  }
  EXPECT_NEAR(late, 0.2 * kTicks, 0.03 * kTicks);
}

TEST(PlantFaults, PositionsOnlyCarriesNothingElse) {
  KnownPlant inner;
  FaultyPlant plant(inner, argos(), {.positions_only = true}, kDt, 1);
  plant.write(targets_at(0.3, 2.0));
  EXPECT_EQ(inner.written[0].q[4][2], 0.3);
  EXPECT_TRUE(inner.written[0].qd[4].isZero());
  EXPECT_TRUE(inner.written[0].effort[4].isZero());
  EXPECT_EQ(inner.written[0].mode.size(), 0);
}

TEST(PlantFaults, TheEndOfThePlantIsPassedOn) {
  KnownPlant inner;
  inner.status = PlantStatus::closed;
  FaultyPlant plant(inner, argos(), {.joint_noise = 1e-3}, kDt, 1);
  Measurement sensed;
  EXPECT_EQ(plant.read(sensed), PlantStatus::closed);
}

TEST(PlantFaults, AreTheSameTwiceAndOthersWithAnotherSeed) {
  const PlantFaults faults = {.joint_noise = 1e-3, .late_ticks = 0.1};
  EXPECT_EQ(errors_of(faults, 50), errors_of(faults, 50));
  EXPECT_NE(errors_of(faults, 50), errors_of(faults, 50, 2));
}

// A further fault draws from a stream of its own.
TEST(PlantFaults, OneMoreChangesNoOther) {
  KnownPlant one, two;
  FaultyPlant noisy(one, argos(), {.joint_noise = 1e-3}, kDt, 1);
  FaultyPlant both(two, argos(), {.joint_noise = 1e-3, .false_contacts = 0.5}, kDt, 1);
  Measurement a, b;
  for (int k = 0; k < 20; ++k) {
    noisy.read(a);
    both.read(b);
    EXPECT_EQ(a.q[3], b.q[3]);
  }
}

Summary walk_with(const PlantFaults& faults, const char* terrain = "boxes:0.05",
                  std::uint64_t seed = 1) {
  sim3d::WorldParams params;
  params.seed = seed;
  sim3d::World world(argos(), sim3d::parse_terrain(terrain), params, nominal_posture(argos()));
  FaultyPlant plant(world, argos(), faults, kDt, seed);
  footstep_gen::Walker walker(argos());
  TrialOptions options;
  options.schedule = {{0.0, heading_control::Heading::straight(0.0)}};
  options.seconds = 2.0;
  return run_trial(walker, plant, world.truth(), options);
}

TEST(PlantFaults, NoneOfThemIsBitByBitThePlantItself) {
  sim3d::World world(argos(), sim3d::parse_terrain("boxes:0.05"), {}, nominal_posture(argos()));
  footstep_gen::Walker walker(argos());
  TrialOptions options;
  options.schedule = {{0.0, heading_control::Heading::straight(0.0)}};
  options.seconds = 2.0;
  EXPECT_EQ(walk_with({}).state_hash, run_trial(walker, world, world.truth(), options).state_hash);
}

TEST(PlantFaults, AWalkWithThemHasTheSameBitsTwice) {
  const PlantFaults faults = {.joint_noise = 5e-4,
                              .joint_quantisation = 1.5e-3,
                              .contact_bounce = 0.004,
                              .sensing_delay = 0.002,
                              .command_delay = 0.004};
  EXPECT_EQ(walk_with(faults).state_hash, walk_with(faults).state_hash);
  EXPECT_NE(walk_with(faults, "flat").state_hash, walk_with(faults, "flat", 2).state_hash);
}

TEST(PlantFaults, EverythingOutOfRangeIsRefusedAtOnceWithUnitAndRange) {
  const PlantFaults faults = {.joint_noise = -1e-3,
                              .joint_quantisation = std::numeric_limits<double>::quiet_NaN(),
                              .joint_zero_error = 0.5,
                              .contact_bounce = 2.0,
                              .false_contacts = 1.5,
                              .missed_contacts = -0.1,
                              .sensing_delay = 1.5,
                              .command_delay = std::numeric_limits<double>::infinity(),
                              .late_ticks = 2.0};
  try {
    check(faults);
    FAIL() << "accepted";
  } catch (const InvalidInput& refusal) {
    for (const char* part :
         {"joint_noise [rad]: -0.001 must be finite and in [0, 0.2]", "joint_quantisation [rad]",
          "joint_zero_error [rad]", "contact_bounce [s]: 2 must", "false_contacts [1]: 1.5",
          "missed_contacts [1]: -0.1", "sensing_delay [s]: 1.5 must be finite and in [0, 1]",
          "command_delay [s]", "late_ticks [1]: 2"})
      EXPECT_NE(std::string(refusal.what()).find(part), std::string::npos) << part;
  }
  KnownPlant inner;
  EXPECT_THROW(FaultyPlant(inner, argos(), faults, kDt, 1), InvalidInput);
  for (const double dt : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(FaultyPlant(inner, argos(), {}, dt, 1), InvalidInput);
}

// Every number of the struct is in the table, and nothing but the numbers.
TEST(PlantFaults, TheTableOfThemIsComplete) {
  PlantFaults all;
  for (const auto& one : imperfections()) all.*one.value = one.greatest;
  EXPECT_NO_THROW(check(all));
  const auto& [noise, quantisation, zero, bounce, wrong, missed, sensing, command, felt, felt_off,
               rate, rate_off, late, only] = all;
  for (const double value : {noise, quantisation, zero, bounce, wrong, missed, sensing, command,
                             felt, felt_off, rate, rate_off, late})
    EXPECT_GT(value, 0.0);
  EXPECT_FALSE(only);
}

}  // namespace
}  // namespace hexagait::walk

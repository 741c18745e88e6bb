// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/model/kinematics.hpp>
#include <hexagait/sim3d/world.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/walk/trial.hpp>
#include <testing/argos.hpp>

namespace hexagait::walk::trial_test {
namespace {

using footstep_gen::Fault;
using footstep_gen::Walker;
using heading_control::Heading;

using testing::argos;

TrialOptions arc_for(double seconds) {
  TrialOptions options;
  options.schedule = {{0.0, Heading::arc(2.0, 0.0)}};
  options.seconds = seconds;
  return options;
}

Summary walk_for(const TrialOptions& options, std::uint64_t seed, const Observer& observer = {}) {
  sim3d::WorldParams params;
  params.seed = seed;
  sim3d::World world(argos(), sim3d::parse_terrain("boxes:0.05"), params,
                     random_posture(argos(), 0.05, seed));
  Walker walker(argos());
  return run_trial(walker, world, world.truth(), options, observer);
}

// From the tick of its command on, until another is given.
TEST(Trial, TurnsTheDutyFactorWhenTheScheduleSaysSo) {
  TrialOptions options = arc_for(0.5);
  options.schedule = {{0.0, Heading::straight(0.0)},
                      {0.1, Heading::straight(0.0), 0.75},
                      {0.2, Heading::straight(0.1)},
                      {0.3, Heading::straight(0.1), 0.6}};
  sim3d::World world(argos(), {}, {}, nominal_posture(argos()));
  Walker walker(argos());
  std::vector<double> seen;
  const auto observe = [&](const auto&, const auto&, const auto&) {
    const gait_state::StepperParams& now = walker.params().stepper;
    seen.push_back(now.stepping == gait_state::Stepping::wave ? now.duty_factor : 0.0);
  };
  (void)run_trial(walker, world, world.truth(), options, observe);
  ASSERT_EQ(seen.size(), 250U);
  for (std::size_t k = 0; k < seen.size(); ++k)
    EXPECT_EQ(seen[k], k < 50 ? 0.0 : k < 150 ? 0.75 : 0.6) << k;
}

TEST(Trial, RefusesAScheduleWithoutCommands) {
  try {
    static_cast<void>(walk_for({}, 1));
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(),
                 "the schedule of the walk is empty; it must have a command, if only to stop");
  }
}

TEST(Trial, HasTheSameBitsTwiceInOneProcess) {
  const Summary a = walk_for(arc_for(3.0), 1), b = walk_for(arc_for(3.0), 1);
  EXPECT_EQ(a.state_hash, b.state_hash);
  EXPECT_EQ(a.distance, b.distance);
  EXPECT_EQ(a.slip_mean, b.slip_mean);
  EXPECT_NE(a.state_hash, walk_for(arc_for(3.0), 2).state_hash);
}

// An observer sees every tick and changes nothing.
TEST(Trial, ShowsEveryTickToItsObserver) {
  long ticks = 0;
  const Summary seen =
      walk_for(arc_for(1.0), 1, [&](const auto&, const auto&, const auto&) { ++ticks; });
  EXPECT_EQ(ticks, 500);
  EXPECT_NEAR(seen.seconds, 1.0, 1e-9);
  EXPECT_EQ(seen.state_hash, walk_for(arc_for(1.0), 1).state_hash);
}

TEST(Trial, WalksAlongTheCommandedArc) {
  // Where a foot runs into an edge a walk may lose half of its time.
  double distance = 0.0;
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    const Summary s = walk_for(arc_for(5.0), seed);
    EXPECT_TRUE(s.ok());
    EXPECT_GT(s.steps, 12);
    EXPECT_NEAR(s.turned, s.distance / 2.0, 0.1);
    EXPECT_FALSE(s.arrived);
    distance += s.distance;
  }
  EXPECT_GT(distance, 4 * 0.5);
}

// It ends within a tick of the distance: at 0.6 m/s at most, 1.2 mm.
TEST(Trial, EndsAtTheDistanceAskedFor) {
  TrialOptions options = arc_for(20.0);
  options.distance = 0.5;
  const Summary s = walk_for(options, 1);
  EXPECT_TRUE(s.arrived);
  EXPECT_LT(s.seconds, 10.0);
  EXPECT_NEAR(s.distance, 0.5, 0.002);
}

// An arc of 2 m radius turns by 0.2 rad over 0.4 m; a tick is 0.6 mrad at most.
TEST(Trial, EndsAtTheTurnAskedFor) {
  TrialOptions options = arc_for(20.0);
  options.turn = 0.2;
  const Summary s = walk_for(options, 1);
  EXPECT_TRUE(s.arrived);
  EXPECT_LT(s.seconds, 10.0);
  EXPECT_NEAR(std::abs(s.turned), 0.2, 0.001);
}

// A plant that never says anything new, or is gone.
class BrokenPlant : public Plant {
 public:
  explicit BrokenPlant(PlantStatus status) : status_(status) {
    truth.feet = LegArray<FootTruth>(6);
    for (FootTruth& foot : truth.feet) foot.in_contact = true;
    truth.X_WB.p.z() = 0.3;
  }
  PlantStatus read(Measurement& measurement) override {
    measurement.q = nominal_posture(argos());
    measurement.contact = LegArray<bool>(6, true);
    return status_;
  }
  void write(const JointTargets& /*targets*/) override { ++writes; }

  GroundTruth truth;
  int writes = 0;

 private:
  PlantStatus status_;
};

TEST(Trial, EndsWithTheFaultWhenThePlantFallsSilent) {
  BrokenPlant plant(PlantStatus::late);
  Walker walker(argos());
  const Summary s = run_trial(walker, plant, plant.truth, arc_for(5.0));
  EXPECT_EQ(s.fault, Fault::plant_late);
  EXPECT_FALSE(s.ok());
  EXPECT_NEAR(s.seconds, walker.params().late_limit, 0.01);
}

TEST(Trial, EndsWithTheFaultWhenThePlantIsGone) {
  BrokenPlant plant(PlantStatus::closed);
  Walker walker(argos());
  const Summary s = run_trial(walker, plant, plant.truth, arc_for(5.0));
  EXPECT_EQ(s.fault, Fault::plant_closed);
  EXPECT_LT(s.seconds, 0.01);
}

TEST(Posture, PutsEveryFootAtItsWorkspaceCentre) {
  const LegArray<LegJoints> q = nominal_posture(argos());
  for (LegId i = 0; i < 6; ++i) {
    const LegModel& leg = argos().legs[i];
    EXPECT_NEAR((foot_position(leg, q[i]) - leg.p_BC).norm(), 0.0, 1e-9);
  }
}

TEST(Posture, DisplacesEveryFootByNoMoreThanTheSpread) {
  double farthest = 0.0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const LegArray<LegJoints> q = random_posture(argos(), 0.1, seed);
    for (LegId i = 0; i < 6; ++i) {
      const LegModel& leg = argos().legs[i];
      const Vector3 offset = foot_position(leg, q[i]) - leg.p_BC;
      EXPECT_NEAR(offset.z(), 0.0, 1e-9);
      EXPECT_LE(offset.norm(), 0.1 + 1e-9);
      farthest = std::max(farthest, offset.norm());
    }
  }
  EXPECT_GT(farthest, 0.09);
}

}  // namespace
}  // namespace hexagait::walk::trial_test

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <functional>
#include <hexagait/footstep_gen/walker.hpp>
#include <hexagait/model/kinematics.hpp>
#include <testing/control_period.hpp>
#include <testing/kinematic_plant.hpp>

// Robots that lose legs, and sensors that lie, on a plant that follows exactly.
namespace hexagait::footstep_gen::lost_legs_test {
namespace {

using heading_control::Heading;
using hexagait::testing::kDt;
using testing::KinematicPlant;
using testing::robot_of;

LegSet set_of(std::initializer_list<LegId> legs) {
  LegSet set;
  for (const LegId leg : legs) set.insert(leg);
  return set;
}

struct Walk {
  explicit Walk(int legs = 6) : robot(robot_of(legs)), plant(robot, 0.0, {}), walker(robot) {
    walker.start(plant.measurement);
  }

  /// @param lie  changes what is measured
  void go_on(double seconds, const std::function<void(Measurement&)>& lie = {},
             const std::function<void(const TickRecord&)>& watch = {}) {
    for (double t = 0.0; t < seconds; t += kDt) {
      Measurement measured = plant.measurement;
      if (lie) lie(measured);
      const TickRecord& record = walker.tick(PlantStatus::fresh, measured, Heading::straight(0.0));
      if (watch) watch(record);
      plant.follow(record, kDt);
    }
  }
  /// For most of late_limit no measurement comes, and the robot stands still.
  void be_silent() {
    for (double t = 0.0; t < 0.9 * walker.params().late_limit; t += kDt)
      walker.tick(PlantStatus::late, plant.measurement, Heading::straight(0.0));
  }
  double x() const { return plant.X_OB.p.x(); }

  RobotModel robot;
  KinematicPlant plant;
  Walker walker;
};

TEST(MayWalkWithout, NeedsTwoLegsOnEachSideAndFourInAll) {
  EXPECT_TRUE(may_walk_without({}, 4));
  EXPECT_FALSE(may_walk_without(set_of({0}), 4));
  for (LegId leg = 0; leg < 6; ++leg) EXPECT_TRUE(may_walk_without(set_of({leg}), 6));
  EXPECT_FALSE(may_walk_without(set_of({0, 2}), 6)) << "one left leg is left";
  EXPECT_TRUE(may_walk_without(set_of({0, 3}), 6));
  EXPECT_TRUE(may_walk_without(set_of({0, 2}), 8));
  EXPECT_FALSE(may_walk_without(set_of({0, 1, 2}), 6));
}

// Without leg 3 (right middle) legs 0 and 5 may lift together: the line from 1 to 4 passes below the
// centre of a symmetric robot.
TEST(LeastMargin, IsNothingUntilTheStanceIsRecentred) {
  const RobotModel robot = robot_of(6);
  const Stance nominal = nominal_stance(robot);
  for (LegId leg = 0; leg < 6; ++leg) {
    EXPECT_NEAR(least_margin(nominal.p_BC, Vector2::Zero(), set_of({leg})), 0.0, 1e-9);
    const Stance stance = stance_without(set_of({leg}), robot, nominal, Vector2::Zero());
    EXPECT_GT(least_margin(stance.p_BC, Vector2::Zero(), set_of({leg})), 0.04) << leg;
    for (LegId other = 0; other < 6; ++other) {
      if (other == leg) continue;
      EXPECT_GT(stance.radius[other], 0.5 * nominal.radius[other]);
      EXPECT_LE((stance.p_BC[other] - nominal.p_BC[other]).norm(),
                0.6 * nominal.radius[leg] + 1e-9);
    }
  }
}

// On the left the centres move to the left: the body moves away from the gap.
TEST(StanceWithout, MovesTheBodyAwayFromTheGap) {
  const RobotModel robot = robot_of(6);
  const Stance nominal = nominal_stance(robot);
  const Stance left = stance_without(set_of({2}), robot, nominal, Vector2::Zero());
  EXPECT_GT(left.p_BC[0].y(), nominal.p_BC[0].y() + 0.05);
  const Stance right = stance_without(set_of({3}), robot, nominal, Vector2::Zero());
  EXPECT_LT(right.p_BC[0].y(), nominal.p_BC[0].y() - 0.05);
}

TEST(LostLegs, TheRobotWalksOnWithFiveWhicheverIsLost) {
  for (LegId lost = 0; lost < 6; ++lost) {
    Walk walk;
    walk.go_on(4.0);
    const double before = walk.x();
    walk.walker.lose_leg(lost);
    LegSet stepped;
    walk.go_on(12.0, {}, [&](const TickRecord& record) {
      ASSERT_FALSE(record.lifts.contains(lost));
      ASSERT_TRUE(record.rule1_violations.empty());
      ASSERT_EQ(record.fault, Fault::none);
      stepped = stepped | record.lifts;
    });
    EXPECT_EQ(stepped, without(LegSet::all(6), set_of({lost}))) << "without leg " << lost;
    EXPECT_GT(walk.x() - before, 12.0 * 0.08) << "without leg " << lost;
    EXPECT_GT(walk.walker.record().legs[lost].p_BF.z(), walk.walker.stance().p_BC[lost].z() + 0.1)
        << "tucked up";
  }
}

TEST(LostLegs, WithOneLegOnASideItStands) {
  Walk walk;
  walk.go_on(3.0);
  walk.walker.lose_leg(0);
  walk.go_on(3.0);
  walk.walker.lose_leg(2);
  walk.go_on(2.0);
  const double before = walk.x();
  LegSet lifts;
  walk.go_on(3.0, {}, [&](const TickRecord& record) { lifts = lifts | record.lifts; });
  EXPECT_TRUE(lifts.empty());
  EXPECT_TRUE(walk.walker.record().refuses);
  EXPECT_NEAR(walk.x(), before, 0.05);
}

TEST(LostLegs, ThatThereAreNotOrAreLostAlreadyAreNone) {
  Walk walk;
  walk.walker.lose_leg(-1);
  walk.walker.lose_leg(6);
  EXPECT_TRUE(walk.walker.lost_legs().empty());
  walk.walker.lose_leg(4);
  walk.walker.lose_leg(4);
  EXPECT_EQ(walk.walker.lost_legs(), set_of({4}));
  walk.walker.start(walk.plant.measurement);
  EXPECT_EQ(walk.walker.lost_legs(), set_of({4})) << "start() keeps it";
}

TEST(LegWatch, FindsALegThatDoesNotAnswerAndGoesOnWithoutIt) {
  Walk walk;
  walk.go_on(3.0);
  const LegJoints frozen = walk.plant.measurement.q[4];
  walk.go_on(6.0, [&](Measurement& measured) { measured.q[4] = frozen; });
  EXPECT_EQ(walk.walker.record().findings.silent, set_of({4}));
  EXPECT_EQ(walk.walker.lost_legs(), set_of({4}));
}

// (watch 3). At any instant of a step, with joints that are read exactly or with noise.
TEST(LegWatch, FindsALegThatIsGoneAtOnceAndNoNoiseInIt) {
  RandomSequence random{.seed = 1};
  for (const double noise : {0.0, 0.0005})
    for (int k = 0; k < 20; ++k) {
      Walk walk;
      walk.go_on(3.0 + 0.04 * k);
      const LegJoints frozen = walk.plant.measurement.q[4];
      const auto lie = [&](Measurement& measured) {
        measured.contact[4] = false;
        measured.q[4] = frozen;
        for (LegJoints& q : measured.q)
          for (double& joint : q) joint += random.uniform(-noise, noise);
      };
      const LegFindings& found = walk.walker.record().findings;
      walk.go_on(1.5 * walk.walker.params().executor.swing.lift_time, lie);
      EXPECT_EQ(found.silent, set_of({4})) << k << " " << noise;
      walk.go_on(8.0, lie);
      EXPECT_EQ(found.silent, set_of({4})) << k << " " << noise;
      EXPECT_TRUE(found.noisy.empty()) << k << " " << noise;
      EXPECT_EQ(walk.walker.lost_legs(), set_of({4})) << k << " " << noise;
    }
}

// A foot whose contact is not felt for a while goes with the ground: its leg is there.
TEST(LegWatch, TakesNoLegForGoneWhoseJointsFollow) {
  for (int k = 0; k < 20; ++k) {
    Walk walk;
    walk.go_on(3.0 + 0.04 * k);
    walk.go_on(1.5 * walk.walker.params().executor.swing.lift_time,
               [&](Measurement& measured) { measured.contact[4] = false; });
    EXPECT_TRUE(walk.walker.record().findings.silent.empty()) << k;
  }
}

// In a silence the targets go on, and the robot may not have heard them.
TEST(LegWatch, TakesNoLegForGoneThatStoodStillInASilence) {
  for (int k = 0; k < 20; ++k) {
    Walk walk;
    walk.go_on(3.0 + 0.04 * k);
    const auto open = [](Measurement& measured) { measured.contact[4] = false; };
    walk.go_on(kDt, open);
    walk.be_silent();
    walk.go_on(kDt, open);
    EXPECT_TRUE(walk.walker.record().findings.silent.empty()) << k;
  }
}

TEST(LegWatch, FindsNothingInARobotThatIsSilentAtTimes) {
  Walk walk;
  for (int k = 0; k < 30; ++k) {
    walk.go_on(0.21);
    walk.be_silent();
    EXPECT_TRUE(walk.walker.record().findings.none()) << k;
  }
}

// (watch 2) From 3 s on foot 4 is found above its set point whenever it is to bear its full share.
TEST(LegWatch, FindsALegThatGivesWayUnderItsLoad) {
  const auto silent_with = [](double sunk, double others) {
    Walk walk;
    const double blocked_error = walk.walker.params().executor.swing.blocked_error;
    walk.go_on(3.0);
    walk.go_on(1.0, [&](Measurement& measured) {
      for (LegId i = 0; i < 6; ++i) {
        const LegLane& lane = walk.walker.record().legs[i];
        if (lane.phase != LegPhase::support || lane.load < 1.0) continue;
        const double up = (i == 4 ? sunk : others) * blocked_error;
        measured.q[i] = inverse_kinematics(walk.robot.legs[i], lane.p_BF + Vector3(0.0, 0.0, up)).q;
      }
    });
    return walk.walker.record().findings.silent;
  };
  EXPECT_EQ(silent_with(0.6, 0.0), set_of({4}));
  EXPECT_TRUE(silent_with(0.4, 0.0).empty());
  EXPECT_TRUE(silent_with(0.4, -0.3).empty()) << "it bears more than others, but does not give way";
  EXPECT_TRUE(silent_with(0.7, 0.4).empty()) << "all give way";
}

// (One that never closes is found where the ground stops feet, which it does not on this plant.)
TEST(LegWatch, FindsAContactThatNeverOpensAndWalksOn) {
  Walk walk;
  walk.go_on(3.0);
  const auto lie = [](Measurement& measured) { measured.contact[1] = true; };
  walk.go_on(6.0, lie);
  EXPECT_EQ(walk.walker.record().findings.stuck_closed, set_of({1}));
  EXPECT_TRUE(walk.walker.record().findings.silent.empty());
  const double before = walk.x();
  walk.go_on(6.0, lie);
  EXPECT_GT(walk.x() - before, 6.0 * 0.15);
  walk.go_on(2.0);  // a step and a stance
  EXPECT_TRUE(walk.walker.record().findings.none()) << "it opens after all";
}

TEST(LegWatch, FindsAContactThatFlickersAndNoOther) {
  RandomSequence random{.seed = 1};
  const auto noise = [&random](Measurement& measured, LegId first, LegId last) {
    for (LegId leg = first; leg <= last; ++leg)
      if (random.uniform(0.0, 1.0) < 0.05) measured.contact[leg] = !measured.contact[leg];
  };
  Walk walk;
  walk.go_on(6.0, [&](Measurement& measured) { noise(measured, 1, 1); });
  EXPECT_EQ(walk.walker.record().findings.flickering, set_of({1}));
  EXPECT_EQ(walk.walker.record().findings.deaf(), set_of({1}));
  const double before = walk.x();
  walk.go_on(6.0, [&](Measurement& measured) { noise(measured, 1, 1); });
  EXPECT_GT(walk.x() - before, 6.0 * 0.15);
  Walk all;
  all.go_on(6.0, [&](Measurement& measured) { noise(measured, 0, 5); });
  EXPECT_TRUE(all.walker.record().findings.flickering.empty()) << "noise of all is nobody's fault";
}

TEST(LegWatch, FindsTheLegWhoseJointsAreNoisyAndNoOther) {
  Walk walk;
  RandomSequence random{.seed = 1};
  const auto noise = [&random](Measurement& measured, LegId first, LegId last) {
    for (LegId leg = first; leg <= last; ++leg)
      for (int k = 0; k < 3; ++k) measured.q[leg][k] += random.uniform(-0.02, 0.02);
  };
  walk.go_on(2.0, [&](Measurement& measured) { noise(measured, 2, 2); });
  EXPECT_EQ(walk.walker.record().findings.noisy, set_of({2}));
  Walk all;
  all.go_on(2.0, [&](Measurement& measured) { noise(measured, 0, 5); });
  EXPECT_TRUE(all.walker.record().findings.noisy.empty()) << "noise of all is nobody's fault";
}

TEST(LegWatch, FindsNothingInASoundRobot) {
  for (const int legs : {4, 6, 8}) {
    Walk walk(legs);
    walk.go_on(10.0);
    EXPECT_TRUE(walk.walker.record().findings.none()) << legs;
  }
}

}  // namespace
}  // namespace hexagait::footstep_gen::lost_legs_test

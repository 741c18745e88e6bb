// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <hexagait/fg16/localisation.hpp>
#include <hexagait/text/invalid_input.hpp>

namespace hexagait::experiments {
namespace {

Pose pose(double x, double y, double yaw) { return {rotation_z(yaw), Vector3(x, y, 0.3)}; }

// A base that walks on in the world, while odometry drifts away from it.
struct Moment {
  ActionRecord record;
  GroundTruth truth;
};
Moment at(double time) {
  Moment moment;
  moment.truth.time = time;
  moment.truth.X_WB = pose(0.2 * time, 0.0, 0.1);
  moment.record.state.X_OB = pose(0.19 * time, 0.01 * time, 0.1 + 0.002 * time);
  return moment;
}

// By the localisation the base is at X_OM⁻¹ X_OB.
Pose localised(const Pose& X_OM, const Moment& moment) {
  return X_OM.inverse() * moment.record.state.X_OB;
}

TEST(JumpingLocalisation, KnowsTheTruthAtAFixButForItsErrors) {
  const JumpingLocalisation::Params params;
  JumpingLocalisation localisation(params);
  double largest = 0.0, sum = 0.0;
  constexpr int kFixes = 2000;
  for (int k = 0; k < kFixes; ++k) {
    const Moment moment = at(k * params.period * 1.001);
    const Pose X_MB = localised(localisation.X_OM(moment.record, moment.truth), moment);
    const Vector3 off = X_MB.p - moment.truth.X_WB.p;
    EXPECT_LE(off.head<2>().norm(), params.shift + 1e-9);
    EXPECT_LE(std::abs(off.z()), params.height + 1e-9);
    const Vector3 turn = rotation_vector(moment.truth.X_WB.R.transpose() * X_MB.R);
    EXPECT_LE(turn.norm(), params.turn + 1e-9);
    EXPECT_NEAR(turn.head<2>().norm(), 0.0, 1e-9);
    largest = std::max(largest, off.head<2>().norm());
    sum += off.y();
  }
  // Uniform in a disc of radius r: a coordinate has the standard deviation r/2.
  EXPECT_GT(largest, 0.98 * params.shift);
  EXPECT_NEAR(sum / kFixes, 0.0, 4.0 * 0.5 * params.shift / std::sqrt(double{kFixes}));
}

TEST(JumpingLocalisation, StandsStillInOdomBetweenFixes) {
  const JumpingLocalisation::Params params{.period = 0.5};
  JumpingLocalisation localisation(params);
  Pose before;
  int jumps = 0;
  for (int k = 0; k <= 1000; ++k) {
    const Moment moment = at(0.002 * k);
    const Pose X_OM = localisation.X_OM(moment.record, moment.truth);
    jumps += k > 0 && X_OM.p != before.p ? 1 : 0;
    before = X_OM;
  }
  EXPECT_EQ(jumps, 4);  // at 0.5, 1, 1.5 and 2 s
}

TEST(JumpingLocalisation, IsAFunctionOfItsSeed) {
  JumpingLocalisation one({.seed = 3}), same({.seed = 3}), other({.seed = 4});
  const Moment moment = at(1.0);
  const Vector3 p = one.X_OM(moment.record, moment.truth).p;
  EXPECT_EQ(p, same.X_OM(moment.record, moment.truth).p);
  EXPECT_NE(p, other.X_OM(moment.record, moment.truth).p);
}

class Joints : public Plant {
 public:
  PlantStatus read(Measurement& measurement) override {
    measurement.q = q;
    return PlantStatus::fresh;
  }
  void write(const JointTargets& targets) override { q = targets.q; }
  LegArray<LegJoints> q = LegArray<LegJoints>(6, leg_joints({0.1, 0.2, 0.3}));
};

// Six legs with these joint axes.
RobotModel model(std::initializer_list<Vector3> axes) {
  RobotModel robot;
  LegModel leg;
  std::ranges::copy(axes, leg.axis_B0.begin());
  robot.legs = LegArray<LegModel>(6, leg);
  return robot;
}

// What it is told it reports as done, and truly does with the error.
TEST(MiscalibratedPlant, IsOffByItsErrorAndDoesNotKnow) {
  Joints robot;
  MiscalibratedPlant plant(robot, model({Vector3::UnitZ(), Vector3::UnitY(), Vector3::UnitY()}),
                           0.02);
  const LegArray<LegJoints> zero(6, LegJoints::Zero());
  plant.write({LegArray<LegJoints>(6, leg_joints({0.5, 0.6, 0.7})), zero, zero});
  Measurement measurement;
  EXPECT_EQ(plant.read(measurement), PlantStatus::fresh);
  for (LegId i = 0; i < 6; ++i) {
    EXPECT_NEAR((measurement.q[i] - leg_joints({0.5, 0.6, 0.7})).norm(), 0.0, 1e-15);
    EXPECT_NEAR((robot.q[i] - leg_joints({0.48, 0.6, 0.7})).norm(), 0.0, 1e-15);
  }
}

// A hip that rolls first; the yaw axis comes second and points down.
TEST(MiscalibratedPlant, FindsTheYawJointByItsAxis) {
  Joints robot;
  MiscalibratedPlant plant(robot, model({Vector3::UnitX(), -Vector3::UnitZ(), Vector3::UnitY()}),
                           0.02);
  Measurement measurement;
  EXPECT_EQ(plant.read(measurement), PlantStatus::fresh);
  EXPECT_NEAR((measurement.q[5] - leg_joints({0.1, 0.18, 0.3})).norm(), 0.0, 1e-15);
}

TEST(MiscalibratedPlant, RefusesALegWithoutAYawJoint) {
  Joints robot;
  const RobotModel no_yaw = model({Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitY()});
  EXPECT_THROW(MiscalibratedPlant(robot, no_yaw, 0.02), InvalidInput);
}

}  // namespace
}  // namespace hexagait::experiments

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/executor/state_estimator.hpp>
#include <hexagait/script/preview.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <limits>
#include <testing/argos.hpp>

namespace hexagait::state_estimator_test {
namespace {

struct Scene {
  RobotModel model = testing::argos();
  Measurement measurement{3.0, nominal_joints(model), LegArray<bool>(6, false)};
  Executor executor{model, {}};
};

// The nominal stance: feet where their workspace centres are, the body level above them.
TEST(StateEstimator, TakesAllFeetToBeOnTheGroundAtTheStart) {
  Scene scene;
  StateEstimator estimator(scene.model, {});
  const RobotState state = estimator.start(scene.measurement);
  EXPECT_EQ(state.time, 3.0);
  for (LegId i = 0; i < 6; ++i) {
    EXPECT_TRUE(state.contact[i]);
    EXPECT_LT((state.p_BF[i] - scene.model.legs[i].p_BC).norm(), 1e-9);
    EXPECT_NEAR(state.p_OF[i].z(), scene.model.foot_radius, 1e-9);
  }
  EXPECT_NEAR(state.X_OB.p.z(), scene.model.foot_radius - scene.model.legs[0].p_BC.z(), 1e-9);
}

TEST(StateEstimator, RefusesToStartWithoutJointPositions) {
  Scene scene;
  StateEstimator estimator(scene.model, {});
  scene.measurement.q[2][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)estimator.start(scene.measurement), InvalidInput);
  scene.measurement.q = LegArray<LegJoints>(4, LegJoints::Zero());
  EXPECT_THROW((void)estimator.start(scene.measurement), InvalidInput);
}

TEST(StateEstimator, BelievesTheSensorsThatThereAreAndThePlanOtherwise) {
  Scene scene;
  for (const bool sees : {true, false}) {
    StateEstimator estimator(scene.model, {.joint_feedback = sees, .foot_contacts = sees});
    RobotState state = estimator.start(scene.measurement);
    scene.executor.reset(state);
    Measurement now = scene.measurement;
    now.q[0][2] += 0.1;
    estimator.update(state, now, scene.executor, 0.002);
    EXPECT_EQ(state.q[0][2], (sees ? now : scene.measurement).q[0][2]);
    EXPECT_EQ(state.contact[3], !sees) << "a leg in support is planned to touch";
    EXPECT_LT((state.p_BF[0] - foot_position(scene.model.legs[0], state.q[0])).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace hexagait::state_estimator_test

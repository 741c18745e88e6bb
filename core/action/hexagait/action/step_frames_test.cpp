// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/action/step_frames.hpp>

namespace hexagait::step_frames_test {
namespace {

void expect_same(const Pose& a, const Pose& b) {
  EXPECT_LT((a.p - b.p).norm(), 1e-12);
  EXPECT_LT((a.R - b.R).norm(), 1e-12);
}

struct Scene {
  RobotState state;
  Frames frames;
  Scene() {
    state.X_OB = {rotation_z(0.4) * rotation(Vector3(0.1, 0.2, 0.0)), {1, 2, 3}};
    state.print_O = LegArray<Vector3>(4, Vector3(0.5, 0.6, 0.7));
    frames.X_OM = {rotation(Vector3(0.05, 0.0, 0.3)), {0.1, 0.2, 0.0}};
  }
};

TEST(StepFrames, ExecuteInTheBodyWhatIsFixedToIt) {
  Scene scene;
  scene.frames.registered[4] = {kBase, {rotation_z(1.0), {0, 1, 0}}};
  scene.frames.registered[5] = {kMap, {}};
  StepFrames frames;
  EXPECT_FALSE(frames.place(kOdom, scene.frames, scene.state).in_body);
  EXPECT_FALSE(frames.place(kFootprint, scene.frames, scene.state).in_body);
  EXPECT_FALSE(frames.place(5, scene.frames, scene.state).in_body);
  EXPECT_TRUE(frames.place(kBase, scene.frames, scene.state).in_body);
  const Placement placement = frames.place(4, scene.frames, scene.state);
  EXPECT_TRUE(placement.in_body);
  expect_same(placement.X_PA, scene.frames.registered[4].X_PA);
  for (const FrameId frame : {kOdom, kMap, kBase, kFootprint, FrameId{4}, FrameId{5}})
    expect_same(frames.in_odom(frame, scene.frames, scene.state),
                pose_in_odom(frame, scene.frames, scene.state));
}

// The footprint of the moment in which the action starts, fixed to the map: when the robot has
// moved on it stays; when the map moves it moves along.
TEST(Adaptation, FixesAFrameToItsTargetWhenTheActionStarts) {
  Scene scene;
  const Pose X_S{rotation_z(0.2), {0.3, 0, 0}};
  action::Action action;
  action.adapt_coordinates = {{kFootprint, kMap, X_S, false}};
  StepFrames frames;
  frames.start(action, scene.frames, scene.state);
  const Pose X_OS = pose_in_odom(kFootprint, scene.frames, scene.state);
  expect_same(frames.in_odom(kFootprint, scene.frames, scene.state), X_OS * X_S);

  const Pose X_MS = scene.frames.X_OM.inverse() * X_OS;
  scene.state.print_O = LegArray<Vector3>(4, Vector3(9, 9, 9));
  scene.frames.X_OM.p.x() += 5.0;
  expect_same(frames.in_odom(kFootprint, scene.frames, scene.state),
              scene.frames.X_OM * X_MS * X_S);
}

TEST(Adaptation, WithYawOnlyIsUpright) {
  Scene scene;
  action::Action action;
  action.adapt_coordinates = {{kBase, kOdom, {}, true}};
  StepFrames frames;
  frames.start(action, scene.frames, scene.state);
  const Placement placement = frames.place(kBase, scene.frames, scene.state);
  EXPECT_FALSE(placement.in_body) << "no longer fixed to the body";
  const double yaw = roll_pitch_yaw(scene.state.X_OB.R).z();
  expect_same(placement.X_PA, {rotation_z(yaw), scene.state.X_OB.p});
}

TEST(Adaptation, IsForgottenByTheNextAction) {
  Scene scene;
  action::Action action;
  action.adapt_coordinates = {{kFootprint, kOdom, {Matrix3::Identity(), {1, 0, 0}}, false}};
  StepFrames frames;
  frames.start(action, scene.frames, scene.state);
  frames.start({}, scene.frames, scene.state);
  expect_same(frames.in_odom(kFootprint, scene.frames, scene.state),
              pose_in_odom(kFootprint, scene.frames, scene.state));
}

}  // namespace
}  // namespace hexagait::step_frames_test

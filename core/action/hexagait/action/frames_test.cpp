// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/action/frames.hpp>
#include <hexagait/text/invalid_input.hpp>

namespace hexagait {
namespace {

RobotState standing(const Pose& X_OB) {
  RobotState state;
  state.X_OB = X_OB;
  state.print_O = LegArray<Vector3>(4);
  const Vector3 prints[] = {{1, 1, 0}, {1, -1, 0}, {-1, 1, 0}, {-1, -1, 0.4}};
  for (LegId i = 0; i < 4; ++i) state.print_O[i] = prints[i];
  return state;
}

void expect_same(const Pose& a, const Pose& b) {
  EXPECT_LT((a.p - b.p).norm(), 1e-12);
  EXPECT_LT((a.R - b.R).norm(), 1e-12);
}

TEST(FrameNames, AreFoundAndRefusedTwice) {
  FrameNames names;
  EXPECT_EQ(names.find("odom"), kOdom);
  EXPECT_EQ(names.find("footprint"), kFootprint);
  EXPECT_EQ(names.find("base_link"), kBase);
  EXPECT_EQ(names.find("door"), std::nullopt);
  EXPECT_EQ(names.add("door"), kFirstRegistered);
  EXPECT_EQ(names.find("door"), kFirstRegistered);
  EXPECT_THROW(names.add("door"), InvalidInput);
  EXPECT_THROW(names.add("base_link"), InvalidInput);
  for (int k = kFirstRegistered + 1; k < kMaxFrames; ++k) names.add(std::to_string(k));
  EXPECT_THROW(names.add("one too many"), InvalidInput);
}

// Prints' mean (0, 0, 0.1); of the body's orientation only the yaw.
TEST(Footprint, IsLevelInTheMiddleOfTheFootprints) {
  const Matrix3 R = rotation_z(0.7) * rotation(Vector3(0.1, -0.2, 0.0));
  const RobotState state = standing({R, {5, 6, 7}});
  const double yaw = roll_pitch_yaw(R).z();
  expect_same(pose_in_odom(kFootprint, {}, state), {rotation_z(yaw), {0, 0, 0.1}});
}

TEST(Footprint, StaysWhereItIsWhileAFootIsInTheAir) {
  RobotState state = standing({});
  state.p_OF = state.print_O;
  const Pose before = pose_in_odom(kFootprint, {}, state);
  state.p_OF[0] += Vector3(0.3, 0.2, 0.4);
  expect_same(pose_in_odom(kFootprint, {}, state), before);
}

TEST(Frames, StandWhereTheirParentsDo) {
  const Pose X_OB{rotation_z(0.3), {1, 2, 3}};
  const RobotState state = standing(X_OB);
  Frames frames;
  frames.X_OM = {rotation_z(-0.2), {0.5, 0, 0}};
  const Pose X_PA{rotation(Vector3(0.1, 0.2, 0.3)), {0, 0, 1}};
  frames.registered[4] = {kMap, X_PA};
  frames.registered[5] = {kBase, X_PA};
  frames.registered[6] = {kOdom, X_PA};
  expect_same(pose_in_odom(kOdom, frames, state), {});
  expect_same(pose_in_odom(kMap, frames, state), frames.X_OM);
  expect_same(pose_in_odom(kBase, frames, state), X_OB);
  expect_same(pose_in_odom(4, frames, state), frames.X_OM * X_PA);
  expect_same(pose_in_odom(5, frames, state), X_OB * X_PA);
  expect_same(pose_in_odom(6, frames, state), X_PA);
}

}  // namespace
}  // namespace hexagait

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/viewer/walking/simulated_walk.hpp>
#include <testing/argos_walk.hpp>
#include <testing/source_path.hpp>

namespace hexagait::viewer::simulated_walk_test {
namespace {

using heading_control::Heading;
using heading_control::HeadingCommand;
using testing::argos;
using testing::kInfinite;
using testing::on;
using testing::run;

bool same_targets(const SimulatedWalk& a, const SimulatedWalk& b) {
  for (LegId i = 0; i < argos().num_legs(); ++i)
    if (a.targets().q[i] != b.targets().q[i]) return false;
  return true;
}

// Straight on at some 0.2 m/s for 4 s, then on an arc to the left.
TEST(SimulatedWalk, GoesWhereItIsSteered) {
  SimulatedWalk walk(argos(), on("flat"));
  run(walk, Heading::straight(0.0), 4.0);
  EXPECT_GT(walk.place().shift.x(), 0.5);
  EXPECT_NEAR(walk.place().shift.y(), 0.0, 0.02);
  run(walk, Heading::arc(1.0, 0.0), 4.0);
  EXPECT_GT(walk.place().angle, 0.4);
  EXPECT_FALSE(walk.fell());
}

// Two walks that were the same until now: the one that is told to stop has other targets in the
// very tick in which it is told.
TEST(SimulatedWalk, ObeysInTheTickOfTheCommand) {
  SimulatedWalk a(argos(), on("flat")), b(argos(), on("flat"));
  run(a, Heading::straight(0.0), 1.0);
  run(b, Heading::straight(0.0), 1.0);
  ASSERT_TRUE(same_targets(a, b));
  a.tick({Heading::straight(0.0), kInfinite});
  b.tick({Heading::straight(0.0).stopped(), kInfinite});
  EXPECT_FALSE(same_targets(a, b));
}

TEST(SimulatedWalk, FrameShowsTheTruth) {
  SimulatedWalk walk(argos(), on("boxes:0.1"));
  run(walk, Heading::arc(2.0, 0.3), 3.0);
  const PoseFrame f = walk.frame();
  EXPECT_EQ(f.tick, 1500U);
  EXPECT_NEAR(f.time, 3.0, 1e-9);
  EXPECT_TRUE(f.moving);
  EXPECT_EQ(f.X_WB.p.head<2>(), walk.place().shift);
  int in_air = 0;
  for (LegId i = 0; i < argos().num_legs(); ++i) {
    const Vector3 p_WF = f.X_WB * foot_position(argos().legs[i], f.legs[i].q);
    EXPECT_LT((p_WF - f.legs[i].p_WF).norm(), 1e-3);
    EXPECT_EQ(f.legs[i].p_WT.allFinite(), !f.support.contains(i));
    in_air += f.contact.contains(i) ? 0 : 1;
  }
  EXPECT_LE(in_air, 3);
  // The turning centre is to the left of where the body sets off, at the radius.
  const Vector2 way = unit_vector(walk.place().angle + 0.3);
  EXPECT_LT((f.centre - (walk.place().shift + 2.0 * perpendicular(way))).norm(), 1e-9);
}

TEST(SimulatedWalk, ShowsNoTurningCentreWhereThereIsNone) {
  SimulatedWalk walk(argos(), on("flat"));
  run(walk, Heading::straight(0.0), 0.1);
  EXPECT_TRUE(walk.frame().centre.array().isNaN().all());
}

// With the legs displaced by up to 9 cm, anywhere on the ground, it stands and walks on.
TEST(SimulatedWalk, BeginsWithScrambledLegsOnRoughGround) {
  for (std::uint64_t draw = 1; draw <= 6; ++draw) {
    const PlanarPose start{0.5 * static_cast<double>(draw),
                           {2.0, -0.3 * static_cast<double>(draw)}};
    SimulatedWalk walk(argos(), on("boxes:0.1"), {start, 0.09, draw});
    EXPECT_LT((walk.place().shift - start.shift).norm(), 0.05);
    run(walk, Heading::straight(0.0), 5.0);
    EXPECT_FALSE(walk.fell()) << draw;
    EXPECT_GT(walk.frame().path, 0.3) << draw;
  }
}

TEST(SimulatedWalk, BeginsWithEachFootAtTheHeightOfItsGround) {
  const sim3d::Terrain terrain(sim3d::parse_terrain("boxes:0.1"), 1);
  const WalkStart start{{0.7, {4.0, -3.0}}, 0.05, 2};
  const LegArray<LegJoints> q = posture_on(terrain, argos(), start);
  LegArray<double> above(argos().num_legs());
  for (LegId i = 0; i < argos().num_legs(); ++i) {
    const Vector3 p_BF = foot_position(argos().legs[i], q[i]);
    const Vector2 p_W = start.X_WB * Vector2(p_BF.head<2>());
    above[i] = p_BF.z() - terrain.height_at(p_W.x(), p_W.y());
    EXPECT_NEAR(above[i], above[0], 1e-6);
  }
}

// Odometry begins at 0 wherever the robot stands: a foothold that is shown in its frame is far away.
TEST(SimulatedWalk, ShowsFootholdsInTheWorld) {
  SimulatedWalk walk(argos(), on("flat"), {{2.0, {5.0, -3.0}}, 0.0, 0});
  int seen = 0;
  for (int k = 0; k < 20; ++k) {
    run(walk, Heading::straight(0.0), 0.1);
    for (const LegFrame& leg : walk.frame().legs) {
      if (!leg.p_WT.allFinite()) continue;
      EXPECT_LT((leg.p_WT - leg.p_WF).norm(), 0.5);
      ++seen;
    }
  }
  EXPECT_GT(seen, 10);
}

TEST(SimulatedWalk, PushMovesTheBody) {
  SimulatedWalk pushed(argos(), on("flat")), left(argos(), on("flat"));
  pushed.push(0.5 * std::numbers::pi);
  run(pushed, Heading::stop(), 0.2);
  run(left, Heading::stop(), 0.2);
  EXPECT_GT(pushed.place().shift.y(), left.place().shift.y() + 1e-4);
  EXPECT_FALSE(pushed.fell());
}

// 200 g with a push for 50 kg would be shot away.
TEST(SimulatedWalk, PushIsAsHardAsTheRobotIsLargeAndHeavy) {
  const RobotModel mite = load_urdf(hexagait::testing::source_path("robots/mite.urdf"));
  recording::Simulation simulation = on("flat");
  recording::complete(simulation, mite);
  SimulatedWalk walk(mite, simulation);
  const PlanarPose before = walk.place();
  walk.push(0.5 * std::numbers::pi);
  double farthest = 0.0;
  for (int k = 0; k < 500; ++k) {
    walk.tick({Heading::stop(), kInfinite});
    farthest = std::max(farthest, (walk.place().shift - before.shift).norm());
  }
  EXPECT_FALSE(walk.fell());
  EXPECT_GT(farthest, 1e-4);
  EXPECT_LT(farthest, 2.0 * mite.legs[0].workspace_radius);
}

TEST(SimulatedWalk, ChangesItsGaitWhileItWalks) {
  SimulatedWalk walk(argos(), on("flat"));
  run(walk, Heading::straight(0.0), 1.0);
  EXPECT_EQ(walk.frame().flags, 0);
  walk.set_gait({.stepping = gait_state::Stepping::wave, .duty_factor = 5.0 / 6.0});
  int most_in_air = 0;
  run(walk, Heading::straight(0.0), 6.0);
  for (int k = 0; k < 1000; ++k) {
    walk.tick({Heading::straight(0.0), kInfinite});
    const PoseFrame f = walk.frame();
    most_in_air = std::max(most_in_air, 6 - f.support.size());
  }
  EXPECT_EQ(walk.frame().flags, PoseFrame::wave);
  EXPECT_LE(most_in_air, 2);  // 1 of 6 legs at a time, and their overlap
}

}  // namespace
}  // namespace hexagait::viewer::simulated_walk_test

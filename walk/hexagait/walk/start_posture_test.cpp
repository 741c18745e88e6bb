// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/sim3d/world.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <hexagait/walk/start_posture.hpp>
#include <testing/argos.hpp>
#include <testing/source_path.hpp>

namespace hexagait::walk {
namespace {

using testing::argos;

// The body is a box of 0.12 m, its middle the origin.
TEST(StartPosture, KnowsHowDeepTheBellyIs) { EXPECT_NEAR(belly_depth(argos()), 0.06, 1e-12); }

// Feet of 2 cm under a belly 6 cm below the origin: their centres are 4 cm below it.
TEST(StartPosture, SitsWithTheFeetBesideTheBelly) {
  const StartPosture posture = start_posture(argos(), StartKind::sitting);
  EXPECT_EQ(posture.rests_on, RestsOn::feet);
  EXPECT_NEAR(posture.height, 0.06, 1e-12);
  for (LegId i = 0; i < 6; ++i) {
    const Vector3 p_BF = foot_position(argos().legs[i], posture.q[i]);
    EXPECT_NEAR((p_BF.head<2>() - argos().legs[i].p_BC.head<2>()).norm(), 0.0, 1e-9);
    EXPECT_NEAR(p_BF.z(), -0.04, 1e-9);
  }
}

// Nothing but the belly touches the ground of a world that is made from it, however it is drawn.
TEST(StartPosture, LiesWithTheLegsInTheAirAndNoTwoSeedsAlike) {
  LegJoints before = LegJoints::Zero();
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const StartPosture posture = start_posture(argos(), StartKind::lying, seed);
    EXPECT_EQ(posture.rests_on, RestsOn::belly);
    sim3d::WorldParams params;
    params.start_height = posture.height - 1e-4;
    sim3d::World world(argos(), {}, params, posture.q);
    world.write({posture.q, LegArray<LegJoints>(6, LegJoints::Zero()),
                 LegArray<LegJoints>(6, LegJoints::Zero())});
    EXPECT_TRUE(world.truth().base_touches_ground) << seed;
    EXPECT_FALSE(world.truth().leg_touches_ground) << seed;
    for (const FootTruth& foot : world.truth().feet) EXPECT_FALSE(foot.in_contact) << seed;
    EXPECT_NE(posture.q[0], before);
    before = posture.q[0];
    EXPECT_EQ(start_posture(argos(), StartKind::lying, seed).q[5], posture.q[5]);
  }
}

// The quadruped's hips hang 8 cm below its belly.
TEST(StartPosture, RefusesARobotWhoseLegsAreUnderItsBelly) {
  const RobotModel quadruped = load_urdf(testing::source_path("robots/quadruped.urdf"));
  EXPECT_THROW((void)start_posture(quadruped, StartKind::sitting), InvalidInput);
  EXPECT_THROW((void)start_posture(quadruped, StartKind::lying), InvalidInput);
  EXPECT_NO_THROW((void)start_posture(quadruped, StartKind::standing));
}

}  // namespace
}  // namespace hexagait::walk

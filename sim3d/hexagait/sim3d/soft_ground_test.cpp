// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/model/kinematics.hpp>
#include <hexagait/sim3d/world.hpp>
#include <testing/argos.hpp>
#include <testing/round_params.hpp>

namespace hexagait::sim3d::soft_ground_test {
namespace {

const LegArray<LegJoints> kZero(6, LegJoints::Zero());

class SoftGround : public ::testing::TestWithParam<const char*> {
 protected:
  // The robot stands for some seconds.
  GroundTruth stand(const std::string& terrain, double seconds = 3.0) const {
    LegArray<LegJoints> q = kZero;
    for (LegId leg = 0; leg < 6; ++leg)
      q[leg] = inverse_kinematics(robot_.legs[leg], robot_.legs[leg].p_BC).q;
    World world(robot_, parse_terrain(terrain), hexagait::testing::round_world<WorldParams>(), q);
    while (world.truth().time < seconds) world.write({q, kZero, kZero});
    return world.truth();
  }

  RobotModel robot_ = testing::argos();
};

// At rest the damper has no force: each foot is F/K deep, and the forces carry the weight. The ground is
// a plane, a box per cell, or triangles, which may give a foot several contacts.
TEST_P(SoftGround, LetsEachFootSinkByItsForceOverTheStiffness) {
  for (const double stiffness : {5e3, 2e4, 2e5}) {
    const GroundTruth truth = stand(std::string(GetParam()) + "soft:" + std::to_string(stiffness));
    double sum = 0.0;
    for (LegId leg = 0; leg < 6; ++leg) {
      const FootTruth& foot = truth.feet[leg];
      const double sinkage = robot_.foot_radius - foot.p_WF.z();
      EXPECT_NEAR(sinkage, foot.normal_force / stiffness, 0.03 * sinkage + 2e-5)
          << stiffness << ", leg " << leg;
      sum += foot.normal_force;
    }
    EXPECT_NEAR(sum, robot_.mass * 9.81, 0.01 * robot_.mass * 9.81);
  }
}

INSTANTIATE_TEST_SUITE_P(OfAllSurfaces, SoftGround, ::testing::Values("", "boxes:0+", "steps:0+"));

TEST(SoftGroundWords, AreStiffnessAndDamping) {
  const Terrain usual(parse_terrain("soft:20000"), 1),
      both(parse_terrain("boxes:5cm+soft:2e4,300"), 1);
  ASSERT_TRUE(usual.softness() && both.softness());
  EXPECT_EQ(usual.softness()->stiffness, 20000.0);
  EXPECT_EQ(usual.softness()->damping, 1000.0);
  EXPECT_EQ(both.softness()->damping, 300.0);
  EXPECT_EQ(both.surface(), Terrain::Surface::cells) << "it has no height of its own";
  EXPECT_FALSE(Terrain(parse_terrain("boxes:5cm"), 1).softness());
  EXPECT_ANY_THROW((void)parse_terrain("soft:0"));
}

}  // namespace
}  // namespace hexagait::sim3d::soft_ground_test

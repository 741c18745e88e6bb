// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/navigation/senses.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <testing/source_path.hpp>

namespace hexagait::navigation {
namespace {

class LayoutOf : public ::testing::TestWithParam<const char*> {
 protected:
  RobotModel robot_ =
      load_urdf(testing::source_path("robots/" + std::string(GetParam()) + ".urdf"));
  SenseLayout layout_ = sense_layout_for(robot_);

  // Where a beam meets level ground.
  Vector3 on_floor(std::size_t k) const {
    const Beam& beam = layout_.beams[k];
    return beam.from_B + beam.to_floor * beam.direction_B;
  }
};

// Feet stand on the floor in the nominal stance, and so do the ends of the beams.
TEST_P(LayoutOf, BeamsMeetTheFloorAheadOfAllFeet) {
  double height = 0.0;
  for (const LegModel& leg : robot_.legs) height -= leg.p_BC.z() / robot_.num_legs();
  for (std::size_t k = 0; k < kBeams; ++k) {
    const Beam& beam = layout_.beams[k];
    EXPECT_NEAR(beam.direction_B.norm(), 1.0, 1e-12);
    EXPECT_NEAR(on_floor(k).z(), -height - robot_.foot_radius, 1e-9);
    EXPECT_GT(on_floor(k).x(), layout_.foot_circle);
    EXPECT_LT(beam.direction_B.z(), -0.2) << "down: level beams would miss a cliff";
  }
}

// A cell of ground that is in the way is wider than the gap between two beams, 5/6 R.
TEST_P(LayoutOf, BeamsCoverTheWidthThatTheFeetNeedToTurn) {
  const double R = layout_.foot_circle;
  for (const LegModel& leg : robot_.legs) EXPECT_LT(leg.p_BC.head<2>().norm(), R);
  EXPECT_GT(on_floor(0).y(), R) << "left";
  EXPECT_LT(on_floor(kBeams - 1).y(), -R) << "right";
  for (std::size_t k = 1; k < kBeams; ++k)
    EXPECT_NEAR(on_floor(k - 1).y() - on_floor(k).y(), 5.0 / 6.0 * R, 1e-9);
}

TEST_P(LayoutOf, WhiskersReachFartherThanTheFeetAndMirrorEachOther) {
  const auto& [left, right] = layout_.whiskers;
  EXPECT_GT(left.tip_B.y(), layout_.foot_circle);
  EXPECT_GT(left.tip_B.x(), layout_.foot_circle);
  const Vector3 mirror(1.0, -1.0, 1.0);
  EXPECT_TRUE(right.tip_B.isApprox(mirror.cwiseProduct(left.tip_B)));
  EXPECT_TRUE(right.root_B.isApprox(mirror.cwiseProduct(left.root_B)));
  EXPECT_GT(left.root_B.y(), 0.0);
}

INSTANTIATE_TEST_SUITE_P(Robots, LayoutOf,
                         ::testing::Values("genghis", "argos", "mite", "titan", "quadruped",
                                           "octopod"));

}  // namespace
}  // namespace hexagait::navigation

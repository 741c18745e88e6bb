// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <hexagait/model/robot_model.hpp>
#include <hexagait/sim2d/terrain2d.hpp>
#include <hexagait/text/invalid_input.hpp>

namespace hexagait::sim2d {
namespace {

using ::testing::HasSubstr;

TEST(Terrain2d, ReadsWhatItWrites) {
  for (const char* text : {"flat", "rough:0.05", "step:0.1", "steps:0.025"})
    EXPECT_EQ(to_string(parse_terrain2d(text)), text);
  EXPECT_EQ(parse_terrain2d("step:10cm"), parse_terrain2d("step:0.1"));
  EXPECT_EQ(parse_terrain2d("rough:50mm").height, 0.05);
}

TEST(Terrain2d, RefusesWhatIsNoneAndNamesTheKnown) {
  for (const char* text : {"", "boxes:0.1", "rough", "rough:", "rough:-1cm", "rough:nan",
                           "rough:5km", "flat:1", "step:0.1 "}) {
    try {
      (void)parse_terrain2d(text);
      ADD_FAILURE() << text;
    } catch (const InvalidInput& error) {
      EXPECT_THAT(error.what(), HasSubstr("flat rough:H step:H steps:H")) << text;
    }
  }
}

// Cells of 10 cm, each with a level of its own in [0, H); nothing on the pad of 30 cm each way.
TEST(Terrain2d, RoughLevelsAreWithinTheirHeightAndDifferFromSideToSide) {
  const Terrain2d ground(parse_terrain2d("rough:0.05"), 7);
  double sum = 0.0;
  int same = 0;
  for (int cell = 3; cell < 1003; ++cell) {
    const double x = (cell + 0.5) * Terrain2d::kCell;
    const double left = ground.height_at(Side::left, x), right = ground.height_at(Side::right, -x);
    EXPECT_TRUE(0.0 <= left && left < 0.05 && 0.0 <= right && right < 0.05);
    EXPECT_EQ(left, ground.height_at(Side::left, x + 0.04));
    same += left == ground.height_at(Side::right, x);
    sum += left;
  }
  EXPECT_EQ(same, 0);
  // The mean of 1000 uniform levels: 2.5 cm, SD 5 cm / √12 / √1000 = 0.46 mm.
  EXPECT_NEAR(sum / 1000, 0.025, 4 * 0.00046);
  EXPECT_EQ(ground.height_at(Side::left, 0.29), 0.0);
  EXPECT_EQ(ground.height_at(Side::right, -0.29), 0.0);
}

TEST(Terrain2d, AStepGoesUpAndLaterDownBothWays) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Terrain2d ground(parse_terrain2d("step:0.1"), seed);
    for (const double way : {1.0, -1.0}) {
      EXPECT_EQ(ground.height_at(Side::left, 0.49 * way), 0.0);
      EXPECT_EQ(ground.height_at(Side::left, 0.61 * way), 0.1);
      EXPECT_EQ(ground.height_at(Side::right, 1.69 * way), 0.1);
      EXPECT_EQ(ground.height_at(Side::right, 1.81 * way), 0.0);
      EXPECT_EQ(ground.height_at(Side::right, 3.2 * way), 0.0);
      EXPECT_EQ(Terrain2d(parse_terrain2d("steps:0.1"), seed).height_at(Side::left, 3.2 * way),
                0.1);
    }
  }
}

// A point of the profile between two of its vertices has the height of the surface there.
TEST(Terrain2d, TheProfileIsTheSurface) {
  for (const char* text : {"flat", "rough:0.08", "step:0.1", "steps:0.1"}) {
    const Terrain2d ground(parse_terrain2d(text), 3);
    const auto points = ground.profile(Side::right, -2.03, 5.01);
    EXPECT_EQ(points.front().x(), -2.03);
    EXPECT_EQ(points.back().x(), 5.01);
    for (std::size_t k = 1; k < points.size(); ++k) {
      ASSERT_GE(points[k].x(), points[k - 1].x());
      if (points[k].x() == points[k - 1].x()) continue;
      EXPECT_EQ(points[k].y(), points[k - 1].y()) << text << " at " << points[k].x();
      const double middle = 0.5 * (points[k].x() + points[k - 1].x());
      EXPECT_EQ(points[k].y(), ground.height_at(Side::right, middle)) << text << " at " << middle;
    }
  }
}

}  // namespace
}  // namespace hexagait::sim2d

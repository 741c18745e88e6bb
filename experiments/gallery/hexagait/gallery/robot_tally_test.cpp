// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <hexagait/gallery/robot_tally.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <testing/source_path.hpp>

namespace hexagait::experiments {
namespace {

// Each walks all, at 0.2 m/s.
std::vector<GalleryRobot> good_robots() {
  std::vector<GalleryRobot> robots;
  for (const char* name : {"argos", "quadruped_rpp"}) {
    robots.push_back(
        in_gallery(load_urdf(testing::source_path("robots/" + std::string(name) + ".urdf"))));
    const WalkEnd end{.outcome = "walked", .seconds = 10.0, .way = 2.0, .off_path = 0.01};
    for (const char* heading : {"straight", "arc", "spin", "crab 45°"})
      robots.back().walks.push_back({name, heading, 0.0, 1, end});
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
      robots.back().walks.push_back({name, "straight", 0.05, seed, end});
  }
  return robots;
}

TEST(GalleryRobot, HasBoxesOfAShareOfItsReach) {
  const std::vector<GalleryRobot> robots = good_robots();
  EXPECT_NEAR(robots[0].boxes, 0.15 * robots[0].model.legs[0].max_reach, 1e-9);
  EXPECT_NEAR(robots[1].boxes, 0.10 * robots[1].model.legs[0].max_reach, 1e-9);
}

TEST(JudgeFlat, FailsForOneWalkThatDoesNotArrive) {
  std::vector<GalleryRobot> robots = good_robots();
  EXPECT_EQ(judge_flat(robots).word(), "holds");
  robots[1].walks[2].end.outcome = "too slow";
  EXPECT_EQ(judge_flat(robots).word(), "FAILS");
}

// Four legs sway; six do not.
TEST(JudgeFlat, HoldsSixLegsToTheirPath) {
  std::vector<GalleryRobot> robots = good_robots();
  robots[1].walks[0].end.off_path = 0.03;
  EXPECT_EQ(judge_flat(robots).word(), "holds");
  robots[0].walks[3].end.off_path = 0.03;
  EXPECT_EQ(judge_flat(robots).word(), "FAILS");
}

TEST(JudgeBoxes, AllowsOneOfTwenty) {
  std::vector<GalleryRobot> robots = good_robots();
  robots.pop_back();
  robots[0].walks[10].end.outcome = "stuck";
  EXPECT_EQ(judge_boxes(robots).word(), "holds");
  robots[0].walks[11].end.outcome = "fell";
  EXPECT_EQ(judge_boxes(robots).word(), "FAILS");
}

// Of quadruped_rpp no more is claimed than was measured, and no less; of argos it is.
TEST(JudgeBoxes, AccountsForWhatIsKnownToFail) {
  std::vector<GalleryRobot> robots = good_robots();
  for (std::size_t k = 4; k < 8; ++k) robots[1].walks[k].end.outcome = "stuck";
  EXPECT_TRUE(judge_boxes(robots).is_accounted_for());
  for (std::size_t k = 8; k < 24; ++k) robots[1].walks[k].end.outcome = "fell";
  EXPECT_FALSE(judge_boxes(robots).is_accounted_for()) << "none arrives";
  robots = good_robots();
  robots.pop_back();
  for (std::size_t k = 4; k < 8; ++k) robots[0].walks[k].end.outcome = "stuck";
  EXPECT_FALSE(judge_boxes(robots).is_accounted_for());
}

TEST(GalleryPage, HasARowPerRobotAndSaysHowWalksEnded) {
  std::vector<GalleryRobot> robots = good_robots();
  robots[0].walks[1].end.outcome = "stuck";
  robots[0].walks[10].end.outcome = "fell";
  const std::string page = gallery_page(robots, "ideal", false);
  EXPECT_THAT(page, ::testing::HasSubstr("| `argos` | 0.200 (1.00 %) | **stuck** | 0.200"));
  EXPECT_THAT(page, ::testing::HasSubstr("| 19 of 20, 1 fell; 0.200 |"));
}

}  // namespace
}  // namespace hexagait::experiments

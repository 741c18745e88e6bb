// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/recording/figures/movie.hpp>
#include <hexagait/recording/figures/robot_view.hpp>
#include <hexagait/recording/figures/walk_figure.hpp>
#include <hexagait/recording/genghis.hpp>
#include <hexagait/recording/trace.hpp>
#include <set>
#include <sstream>

// Of a walk of Genghis, which has a simulator but needs no file.
namespace hexagait::recording {
namespace {

struct Recorded {
  RobotModel robot = robot_in_space(sim2d::GenghisModel{});
  Recording recording{sim2d::Terrain2d(sim2d::parse_terrain2d("rough:0.03"), 1)};
  std::ostringstream trace;
  GenghisSummary summary;

  Recorded() {
    sim2d::GenghisTrial trial;
    trial.terrain = sim2d::parse_terrain2d("rough:0.03");
    trial.seconds = 4.0;
    write_trace_header(trace, robot);
    summary = simulate(trial, [this](const auto& record, const auto& truth, const auto& referee) {
      recording.observe(record, truth, referee);
      write_trace_row(trace, record, truth, referee);
    });
  }
};

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line + ",");
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  return cells;
}

// 4 s: a sample each 20 ms, the last one at the end or up to 20 ms before it.
TEST(Recording, HasASampleEvery20MsAndEveryStep) {
  const Recorded walk;
  EXPECT_EQ(walk.recording.samples().size(), 200U);
  EXPECT_EQ(walk.recording.steps().size(), static_cast<std::size_t>(walk.summary.steps));
  for (const Recording::Step& step : walk.recording.steps()) {
    if (std::isnan(step.land)) continue;
    EXPECT_GT(step.land, step.lift);
    // On a straight line along x the path is x, but for where the walk began.
    EXPECT_NEAR(step.along, step.p_WF.x() - walk.recording.samples().front().X_WB.p.x(), 2e-3);
  }
}

// Joints, targets and efforts of each leg by their names; odometry, which Genghis lacks, is empty.
TEST(Trace, HasAColumnForEveryNumberOfATick) {
  const Recorded walk;
  std::istringstream lines(walk.trace.str());
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> header = split(line);
  const std::set<std::string> names(header.begin(), header.end());
  EXPECT_EQ(names.size(), header.size()) << "a name stands twice";
  for (const char* name : {"time_s", "odom_x_m", "gait_state", "LF_phase", "RR_x_m", "LM_z_m",
                           "LF_swing", "LF_lift_target", "RR_swing_effort"})
    EXPECT_TRUE(names.contains(name)) << name;
  std::getline(lines, line);
  const std::vector<std::string> row = split(line);
  ASSERT_EQ(row.size(), header.size());
  for (std::size_t k = 0; k < row.size(); ++k)
    EXPECT_EQ(row[k].empty(), header[k].starts_with("odom_")) << header[k];
}

// A body of 40 cm, of one box, at two instants: two closed outlines of four corners or more.
TEST(RobotView, DrawsTheOutlineOfTheBodyFromTheSideAndFromAbove) {
  const Recorded walk;
  const RobotView view(walk.recording, walk.robot);
  EXPECT_NEAR(view.body_length(), 0.40, 1e-12);
  EXPECT_EQ(view.num_outlines(), 1);
  for (const figures::Csv& csv : {view.side({0, 100}), view.above({0, 100})}) {
    std::istringstream lines(csv.text());
    std::string line;
    std::getline(lines, line);
    int gaps = 0, points = 0;
    while (std::getline(lines, line)) (line.empty() ? gaps : points) += 1;
    EXPECT_EQ(gaps, 2);
    EXPECT_GE(points, 2 * 5);
  }
}

// The step of 10 cm is met by the feet of both sides, and not before 0.5 m.
TEST(RobotView, ShowsTheGroundUnderTheFeet) {
  Recording recording{sim2d::Terrain2d(sim2d::parse_terrain2d("step:0.1"), 1)};
  EXPECT_EQ(recording.height_at(0.45, 0.1), 0.0);
  EXPECT_EQ(recording.height_at(0.65, 0.1), 0.1);
  EXPECT_EQ(recording.height_at(0.65, -0.1), 0.1);
  EXPECT_EQ(recording.highest(), 0.1);
}

// A figure and a film of the same name write different files beside themselves.
TEST(SideFiles, OfAFigureAndOfAMovieNeverMeet) {
  std::set<std::string> names;
  for (const std::string& name : walk_figure_files("w")) EXPECT_TRUE(names.insert(name).second);
  for (const std::string& name : movie_files("w")) EXPECT_TRUE(names.insert(name).second) << name;
}

}  // namespace
}  // namespace hexagait::recording

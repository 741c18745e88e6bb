// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/sim3d/world.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <hexagait/walk/paths/path_file.hpp>
#include <hexagait/walk/trial.hpp>
#include <testing/source_path.hpp>

// Robots on paths, in the simulator.

namespace hexagait::walk::path_walk_test {
namespace {

using path_following::FacingRule;
using path_following::Path;
using path_following::PathTask;
using path_following::Shape;

const RobotModel& robot(const std::string& name) {
  static std::map<std::string, RobotModel> robots;
  if (!robots.contains(name))
    robots[name] = load_urdf(testing::source_path("robots/" + name + ".urdf"));
  return robots[name];
}

Summary followed(const std::string& name, PathTask task, LocalisedBy localised_by,
                 const std::string& terrain, double seconds) {
  TrialOptions options;
  options.schedule = {{0.0, heading_control::Heading::stop()}};
  options.seconds = seconds;
  options.path = std::move(task);
  options.localised_by = localised_by;
  sim3d::World world(robot(name), sim3d::parse_terrain(terrain), {}, nominal_posture(robot(name)));
  footstep_gen::Walker walker(robot(name));
  return run_trial(walker, world, world.truth(), options);
}

// An L of two sizes of the robot.
PathTask corner(const std::string& name, FacingRule facing = {}) {
  const double a = scale_of(robot(name)).size;
  return {Path({{{0.0, 0.0}}, {{a, 0.0}}, {{a, a}}}, Shape::lines, false), facing, 1,
          path_following::look_ahead_for(params_for(robot(name)).step)};
}

// It stands at the end when the walk ends. The corner is cut by a quarter of the look-ahead, and what
// the steps of a walk add.
TEST(PathWalk, ArrivesAtTheEndWithAnyRobotAndAnyWayToFace) {
  for (const char* name : {"argos", "desktop"})
    for (const char* facing : {"along", "keep", "car"}) {
      const PathTask task = corner(name, parse_facing(facing));
      const Summary s = followed(name, task, LocalisedBy::odometry, "flat", 60.0);
      EXPECT_TRUE(s.ok()) << name << ' ' << facing;
      ASSERT_TRUE(s.path) << name << ' ' << facing;
      EXPECT_TRUE(s.arrived && s.path->arrived) << name << ' ' << facing;
      EXPECT_LT(s.seconds, 59.0) << name << ' ' << facing;
      EXPECT_LT(s.path->off_end, 0.25 * task.look_ahead) << name << ' ' << facing;
      EXPECT_LT(s.path->missed, 0.6 * task.look_ahead) << name << ' ' << facing;
      EXPECT_LT(s.lateral_max, 0.6 * task.look_ahead) << name << ' ' << facing;
      EXPECT_NEAR(s.distance, task.end(), 0.25 * task.look_ahead) << name << ' ' << facing;
      EXPECT_NEAR(s.turned, facing[0] == 'k' ? 0.0 : 1.57, 0.3) << name << ' ' << facing;
    }
}

// With its place given it is nearer to the path than with odometry that drifts, on ground of 10 cm.
TEST(PathWalk, KeepsThePathBetterByAGivenPlace) {
  const double a = scale_of(robot("argos")).size;
  const PathTask line = {Path({{{0.0, 0.0}}, {{5.0 * a, 0.0}}}, Shape::lines, false), {}, 1, 0.25};
  const Summary own = followed("argos", line, LocalisedBy::odometry, "boxes:0.1", 80.0);
  const Summary given = followed("argos", line, LocalisedBy::truth, "boxes:0.1", 80.0);
  EXPECT_TRUE(own.arrived);
  EXPECT_TRUE(given.arrived);
  EXPECT_LT(given.lateral_mean, 0.01);
  EXPECT_LT(own.path->believed_mean, 0.01);
  EXPECT_LT(given.path->off_end, own.odometry_position + 0.02);
}

TEST(PathWalk, HasTheSameBitsTwiceAndSlowsDownWhereItIsTold) {
  PathTask task = corner("argos");
  const Summary fast = followed("argos", task, LocalisedBy::odometry, "flat", 3.0);
  EXPECT_EQ(fast.state_hash,
            followed("argos", task, LocalisedBy::odometry, "flat", 3.0).state_hash);
  EXPECT_FALSE(fast.arrived);
  task.path = Path({{{0.0, 0.0}, {}, 0.05}, {{1.0, 0.0}}}, Shape::lines, false);
  EXPECT_LT(followed("argos", task, LocalisedBy::odometry, "flat", 3.0).distance, 0.16);
}

// A walk along a path is judged by the path: none is stuck that turns in place at its start.
TEST(PathWalk, OfACarThatMustTurnFirstIsNotStuck) {
  const double a = scale_of(robot("argos")).size;
  const PathTask behind = {Path({{{0.0, 0.0}}, {{-a, -0.1 * a}}}, Shape::lines, false),
                           parse_facing("car"), 1, 0.25};
  const Summary s = followed("argos", behind, LocalisedBy::odometry, "flat", 60.0);
  EXPECT_TRUE(s.ok());
  EXPECT_TRUE(s.arrived);
}

}  // namespace
}  // namespace hexagait::walk::path_walk_test

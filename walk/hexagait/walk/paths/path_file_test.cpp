// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <hexagait/params/params_for.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <hexagait/walk/paths/path_file.hpp>
#include <numbers>
#include <testing/source_path.hpp>

namespace hexagait::walk {
namespace {

using path_following::Facing;
using path_following::PathTask;
using ::testing::HasSubstr;

const RobotModel& robot(const char* name) {
  static std::map<std::string, RobotModel> robots;
  if (!robots.contains(name))
    robots[name] = load_urdf(testing::source_path("robots/" + std::string(name) + ".urdf"));
  return robots[name];
}

PathTask loaded(const std::string& text, const char* name = "argos") {
  return parse_path(text, "path.yaml", robot(name), params_for(robot(name)).step);
}

// What is wrong, line by line.
std::string problem(const std::string& text) {
  try {
    static_cast<void>(loaded(text));
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

TEST(PathFile, IsReadAsItIsWritten) {
  const PathTask task = loaded(
      "closed: true\nspeed: 0.2\nfacing: 45deg\n"
      "points:\n  - [0, 0]\n  - {x: 2, y: 0, speed: 0.1}\n  - [200cm, 2]\n");
  EXPECT_TRUE(task.path.closed());
  EXPECT_DOUBLE_EQ(task.path.length(), 4.0 + std::sqrt(8.0));
  EXPECT_EQ(task.path.speed(1.0), 0.2);
  EXPECT_EQ(task.path.speed(2.5), 0.1);
  EXPECT_EQ(task.facing.kind, Facing::fixed);
  EXPECT_DOUBLE_EQ(task.facing.angle, std::numbers::pi / 4.0);
}

// Look-ahead and unit: of the robot's stroke and size.
TEST(PathFile, ScalesWithTheRobot) {
  const std::string text = "unit: size\npoints: [[0, 0], [2, 0]]\n";
  for (const char* name : {"argos", "desktop"}) {
    const PathTask task = loaded(text, name);
    EXPECT_DOUBLE_EQ(task.path.length(), 2.0 * scale_of(robot(name)).size) << name;
    EXPECT_DOUBLE_EQ(task.look_ahead, 1.25 * params_for(robot(name)).step.stroke) << name;
  }
}

TEST(PathFile, ChoosesHowToFaceByWhatItSaysAndTheRobot) {
  const std::string plain = "points: [[0, 0], [2, 0]]\n";
  EXPECT_EQ(loaded(plain).facing.kind, Facing::along);
  EXPECT_EQ(loaded(plain, "genghis").facing.kind, Facing::car);
  EXPECT_EQ(loaded("points: [[0, 0], {x: 2, y: 0, facing: 90deg}]\n").facing.kind, Facing::points);
  EXPECT_EQ(loaded("facing: keep\n" + plain).facing.kind, Facing::fixed);
}

TEST(PathFile, NamesFileLineAndValueOfWhatIsWrong) {
  const std::string file = "path.yaml:";
  EXPECT_THAT(problem("points: [[0, 0], [1, nan]]"), HasSubstr(file + "1:22: points: 'nan'"));
  EXPECT_THAT(problem("points:\n  - [0, 0]\n  - [1, two]\n"),
              HasSubstr(file + "3:9: points: 'two'"));
  EXPECT_THAT(problem("points:\n  - [0, 0]\n  - [1, 0, 0]\n"),
              HasSubstr("3:5: points: is a list of 3"));
  EXPECT_THAT(problem("points:\n  - [0, 0]\n  - {x: 1}\n"),
              HasSubstr("3:5: point: the key \"y\" is missing"));
  EXPECT_THAT(problem("points:\n  - [0, 0]\n  - somewhere\n"),
              HasSubstr("3:5: points: is \"somewhere\"; it must be a point"));
  EXPECT_THAT(problem("points: [[0, 0], [1, 0]]\nclosd: true\n"),
              HasSubstr("did you mean \"closed\"?"));
  EXPECT_THAT(problem("points: [[0, 0], [1, 0]]\nshape: sline\n"),
              HasSubstr("did you mean \"spline\"?"));
  EXPECT_THAT(problem("points: [[0, 0], [1, 0]]\nfacing: alnog\n"),
              HasSubstr("2:9: facing: 'alnog' is no way to face; did you mean 'along'?"));
  EXPECT_THAT(problem("points: [[0, 0], [1, 0]]\nspeed: -1\n"),
              HasSubstr("speed: is \"-1\"; it must be a finite number of more than 0"));
  EXPECT_THAT(problem("closed: true\n"), HasSubstr("the key \"points\" is missing"));
  EXPECT_THAT(problem("- [0, 0]\n- [1, 0]\n"), HasSubstr("it must be a map with points"));
  EXPECT_THAT(problem(""), HasSubstr("is nothing; it must be a map with points"));
  EXPECT_THAT(problem("points: [[0, 0"), HasSubstr(file));
}

TEST(PathFile, NamesPathsThatCannotBeFollowed) {
  EXPECT_THAT(problem("points: [[0, 0]]"),
              HasSubstr("1:10: has 1 point; a path must have at least 2"));
  EXPECT_THAT(problem("points: []"), HasSubstr("has 0 points"));
  EXPECT_THAT(problem("closed: true\npoints: [[0, 0], [1, 0]]"),
              HasSubstr("a closed path must have at least 3"));
  EXPECT_THAT(problem("points:\n  - [0, 0]\n  - [1, 0]\n  - [1, 0]\n"),
              HasSubstr(":4:5: point 3, (1, 0), is where the one before is"));
  EXPECT_THAT(problem("points:\n  - [0, 0]\n  - [1, 0]\n  - [0.1, 0]\n"),
              HasSubstr(":3:5: point 2, (1, 0): the path turns by 180° within 0.2 m"));
}

TEST(PathFile, TellsAllAtOnce) {
  const std::string text = problem("points:\n  - [0, x]\n  - [y, 1]\nclosed: maybe\n");
  for (const char* words : {"'x'", "'y'", "\"maybe\""}) EXPECT_THAT(text, HasSubstr(words));
}

TEST(PathFile, RefusesWhatIsNoFile) {
  EXPECT_THROW(static_cast<void>(load_path("/nowhere.yaml", robot("argos"), {})), InvalidInput);
}

// Of every robot.
TEST(PathFile, ThoseThatComeAlongAreGood) {
  for (const auto& path : std::filesystem::directory_iterator(testing::source_path("paths")))
    for (const auto& urdf : std::filesystem::directory_iterator(testing::source_path("robots"))) {
      if (urdf.path().extension() != ".urdf") continue;
      const RobotModel model = load_urdf(urdf.path());
      EXPECT_NO_THROW(static_cast<void>(load_path(path.path(), model, params_for(model).step)));
    }
}

}  // namespace
}  // namespace hexagait::walk

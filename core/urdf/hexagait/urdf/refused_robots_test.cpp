// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include "testing/recognised.hpp"

namespace hexagait {
namespace {

using ::testing::AllOf;
using testing::expect_refused;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::refusal;
using testing::RobotText;

// ---- refused, with numbers and what to change

TEST(RefusedRobots, HaveTooFewLegs) {
  RobotText robot{.hips = {{0.1, 0.05}, {0.1, -0.05}}};
  expect_refused(robot, {"robot.urdf: robot: has 2 legs; need an even number from 4 to 12"});
}

TEST(RefusedRobots, HaveWheelsOrLegsOfOneJoint) {
  std::string more;
  for (int i = 0; i < 4; ++i)
    more += fmt::format(
        "<link name='w{0}'><collision><origin rpy='1.5707963267948966 0 0'/><geometry>"
        "<cylinder radius='0.05' length='0.02'/></geometry></collision></link>"
        "<joint name='a{0}' type='continuous'><parent link='b'/><child link='w{0}'/>"
        "<origin xyz='{1} {2} 0'/><axis xyz='0 1 0'/></joint>",
        i, i < 2 ? 0.1 : -0.1, i % 2 ? 0.1 : -0.1);
  const std::string rover = "<robot name='rover'><link name='b'/>" + more + "</robot>";
  EXPECT_THAT(refusal(rover), AllOf(HasSubstr("has 0 legs; need an even number from 4 to 12"),
                                    HasSubstr("joint a3: is no leg: is a wheel of radius 0.05 m, "
                                              "and a leg has 2 joints or more")));
  const RobotText wheeled{.tibia_has = "",
                          .foot =
                              "<link name='w{0}'><collision><origin rpy='1.5707963267948966 0 0'/>"
                              "<geometry><cylinder radius='0.03' length='0.02'/></geometry>"
                              "</collision></link><joint name='a{0}' type='continuous'><parent "
                              "link='l{0}c'/><child link='w{0}'/><origin xyz='{1} 0 0'/><axis "
                              "xyz='0 1 0'/></joint>"};
  expect_refused(wheeled, {"ends in a wheel of radius 0.03 m", "make its joint fixed"});
}

/// With this joint fixed in some of the legs.
std::string without_joint(int joint, int legs) {
  std::string text = RobotText().text();
  for (int i = 0; i < legs; ++i) {
    const std::size_t at = text.find(fmt::format("name='q{}-{}' type='revolute'", i, joint));
    text.replace(text.find("revolute", at), 8, "fixed");
  }
  return text;
}

// Lifted and bent, but not swung: such a leg can't move its foot fore and aft.
TEST(RefusedRobots, HaveLegsOfTwoJointsThatDoNotSwing) {
  EXPECT_THAT(refusal(without_joint(0, 6)),
              AllOf(HasSubstr("has two joints; such a leg must swing about the vertical"),
                    HasSubstr("leg q5")));
}

TEST(RefusedRobots, HaveSomeLegsOfTwoJoints) {
  EXPECT_THAT(
      refusal(without_joint(2, 2)),
      AllOf(HasSubstr("leg of joint q0-0: has 2 movable joints, and the other legs have more"),
            HasSubstr("leg of joint q1-0")));
  EXPECT_THAT(refusal(without_joint(2, 4)),
              HasSubstr("has 4 legs of two joints, and others of more"));
}

// Of one pair the hips can only lift.
TEST(RefusedRobots, HaveLegsThatCannotReachTheGroundTogether) {
  std::string text = RobotText().text();
  for (const int i : {2, 3}) {
    std::size_t at = text.find(fmt::format("name='q{}-1'", i));
    text.replace(text.find("lower='-1.5' upper='1.5'", at), 24, "lower='-1.5' upper='-1.2'");
    at = text.find(fmt::format("name='q{}-2'", i));
    text.replace(text.find("lower='0.1' upper='2.6'", at), 23, "lower='0.1' upper='0.3'");
  }
  EXPECT_THAT(refusal(text),
              AllOf(HasSubstr("leg of joint q2-0: gets down to z = 0."),
                    HasSubstr("the body's underside is at -0.02 m"), HasSubstr("q3-0")));
}

TEST(RefusedRobots, AreInMillimetresUnlessToldSo) {
  RobotText robot{.size = 1000.0};
  robot.drive = "velocity='6' effort='2'";
  expect_refused(robot, {"is 310.623 m from its middle", "--scale 0.001"});
  const RobotModel model = parse_urdf(robot.text(), "robot.urdf", {.scale = 0.001});
  EXPECT_NEAR(model.legs[0].tibia, 0.11, 1e-12);
}

TEST(RefusedRobots, AreStillXacro) {
  EXPECT_THAT(refusal("<robot name='r'>\n<xacro:macro name='leg'/></robot>"),
              AllOf(HasSubstr("robot.urdf:2: URDF: 'xacro:macro' is of xacro"),
                    HasSubstr("xacro robot.urdf.xacro > robot.urdf")));
  EXPECT_THAT(refusal("<robot name='r'>\n<link name='${side}_leg'/></robot>"),
              HasSubstr("robot.urdf:2: URDF: '${side}_leg' is of xacro"));
}

TEST(RefusedRobots, HaveDegreesMimicsAndSlidingKnees) {
  expect_refused({.yaw = "lower='-60' upper='60'"},
                 {"joint q0-0: limits -60 to 60 rad are more than two turns", "degrees?"});
  std::string text = RobotText().text();
  text.insert(text.find("<axis", text.find("name='q4-2'")), "<mimic joint='q4-1'/>");
  EXPECT_THAT(refusal(text), HasSubstr("joint q4-2: mimics q4-1; each joint needs its own motor"));
}

// A snake of 900 joints, and 166 legs: told in well under a second.
TEST(RefusedRobots, HaveFarTooManyJointsOrLegs) {
  std::string snake = "<robot name='s'><link name='s0'/>";
  for (int i = 1; i < 900; ++i)
    snake += RobotText::limb(fmt::format("s{}", i), "revolute", fmt::format("s{}", i - 1),
                             {0.1, 0, 0}, i % 2 ? "0 1 0" : "0 0 1");
  EXPECT_THAT(refusal(snake + "</robot>"), HasSubstr("has 899 movable joints; a leg has 2 to 6"));
  RobotText many{.hips = RobotText::rows(83)};
  EXPECT_THAT(refusal(many.text()), HasSubstr("has 166 legs; need an even number from 4 to 12"));
}

TEST(RefusedRobots, LackWhatOptionsName) {
  EXPECT_THAT(refusal(RobotText().text(), {.legs = {"q0-0", "q1-1"}, .feet = {{"l0a", {0, 0, 0}}}}),
              AllOf(HasSubstr("--legs: 'q1-1' is no joint that a chain begins with"),
                    HasSubstr("--foot: 'l0a' is no last link of a chain"),
                    Not(HasSubstr("'q0-0' is no joint"))));
}

// A line each, each with its place.
TEST(RefusedRobots, AreToldAllReasonsAtOnce) {
  RobotText robot{.tibia_has = "", .knee = "lower='2' upper='1'"};
  robot.more = RobotText::limb("arm", "prismatic", "l0c", {0, 0, 0.1}, "0 0 1");
  const std::string said = refusal(robot.text());
  EXPECT_THAT(said,
              AllOf(HasSubstr("joint q0-2: lower limit 2 rad, upper limit 1 rad"),
                    HasSubstr("joint q5-2: lower limit"), HasSubstr("link l1c: has no shape"),
                    HasSubstr("link l5c: has no shape"),
                    HasSubstr("joint to_arm: moves, but is neither revolute nor continuous")));
}

}  // namespace
}  // namespace hexagait

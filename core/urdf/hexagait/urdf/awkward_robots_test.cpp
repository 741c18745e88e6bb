// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include "testing/recognised.hpp"

namespace hexagait {
namespace {

using testing::expect_recognised;
using testing::expect_refused;
using testing::expect_sound;
using ::testing::HasSubstr;
using testing::RobotText;
using testing::told;

// ---- as they should be: nothing is substituted

TEST(AwkwardRobots, AreNotSoIfNothingIsWrongWithThemWhateverTheirNames) {
  const RobotModel robot = expect_recognised({});
  EXPECT_NEAR(robot.mass, 2.0, 1e-5);
  EXPECT_NEAR(robot.legs[0].tibia, 0.11, 1e-12);
}

TEST(AwkwardRobots, MayWeighFrom200GramsTo100KilogramsAndHaveFourToTwelveLegs) {
  for (const auto& [size, mass] : {std::pair(0.4, 0.2), {0.5, 1.0}, {2.0, 20.0}, {4.0, 100.0}})
    for (int pairs = 2; pairs <= 6; ++pairs)
      (void)expect_recognised({.size = size, .mass = mass, .hips = RobotText::rows(pairs)});
}

// ---- where the front is

// Six hips at 60°. The plane of symmetry must hold none of them; all three are as long.
TEST(AwkwardRobots, MayBeRound) {
  const RobotModel beside = expect_recognised(
      {.hips = RobotText::ring(6, std::numbers::pi / 6.0), .base = RobotText::kBox});
  EXPECT_NEAR(beside.legs[0].X_BH.p.x(), 0.08 * std::cos(std::numbers::pi / 6.0), 1e-9);
  EXPECT_NEAR(beside.legs[2].X_BH.p.y(), 0.08, 1e-9);
  const RobotModel on =
      expect_recognised({.hips = RobotText::ring(6, 0.0)}, {"0 robot front: 0°; 30°"});
  EXPECT_NEAR(on.legs[0].X_BH.p.x(), 0.08 * std::cos(std::numbers::pi / 6.0), 1e-9);
  (void)expect_recognised({.hips = RobotText::ring(8, std::numbers::pi / 8.0)});
}

// Turned by 90°, the rows are along the file's y; the front is nearest to +x where it can be chosen.
TEST(AwkwardRobots, MayFaceAnyWay) {
  const RobotModel plain = expect_recognised({});
  for (const double turn : {0.5 * std::numbers::pi, 1.0, -1.0}) {
    const RobotModel robot =
        expect_recognised({.root = RobotText::placed({0, 0, 0}, {0, 0, turn})},
                          {"0 robot front: 0°; " + std::string(turn == 1.0    ? "57.3°"
                                                               : turn == -1.0 ? "-57.3°"
                                                                              : "90°")});
    for (LegId i = 0; i < 6; ++i)
      EXPECT_LT((robot.legs[i].p_BC - plain.legs[i].p_BC).norm(), 1e-9) << turn;
    EXPECT_LT((robot.p_BM - plain.p_BM).norm(), 1e-9);
  }
}

TEST(AwkwardRobots, FaceWhereTheyAreTold) {
  const RobotModel plain = expect_recognised({});
  const RobotModel back =
      expect_recognised({}, {"2 robot front: 0°; 180°"}, {.front = std::numbers::pi});
  EXPECT_LT((back.legs[0].p_BC - plain.legs[0].p_BC).norm(), 1e-9);
  EXPECT_EQ(back.legs[0].joint_names[0], plain.legs[5].joint_names[0]);
}

TEST(AwkwardRobots, MayHaveTheirRootFrameAnywhere) {
  const RobotModel robot =
      expect_recognised({.root = RobotText::placed({0.3, -0.2, 0.5}, {0, 0, 0})},
                        {"0 robot origin of the body: (0, 0, 0); (0.3, -0.2, 0.5) m"});
  EXPECT_LT((robot.legs[0].p_BC - expect_recognised({}).legs[0].p_BC).norm(), 1e-9);
}

// A massless footprint on the ground, a floating joint, and a body above it.
TEST(AwkwardRobots, MayHangFromMasslessRoots) {
  const std::string root =
      "<link name='world'/><link name='footprint'/>"
      "<joint name='free' type='floating'><parent link='world'/><child link='footprint'/></joint>"
      "<joint name='up' type='fixed'><parent link='footprint'/><child link='b'/></joint>";
  (void)expect_recognised({.root = root});
}

// As CAD writes it, y upwards: everything hangs from a root that is rolled by −90°.
TEST(AwkwardRobots, MayHaveAnotherAxisUp) {
  const RobotModel robot =
      expect_recognised({.root = RobotText::placed({0, 0, 0}, {-0.5 * std::numbers::pi, 0, 0})},
                        {"robot up: +z; +y of the file"});
  EXPECT_LT((robot.legs[0].p_BC - expect_recognised({}).legs[0].p_BC).norm(), 1e-9);
}

// ---- where the feet are

TEST(AwkwardRobots, MayEndInALinkWithoutAShape) {
  const RobotModel robot = expect_recognised(
      {.tibia_has = "",
       .foot = "<link name='f{0}'/><joint name='t{0}' type='fixed'><parent link='l{0}c'/>"
               "<child link='f{0}'/><origin xyz='{1} 0 0'/></joint>"},
      {"foot: no collision sphere; the origin of the link fixed to its end"});
  EXPECT_NEAR(robot.foot_radius, 0.025 * 0.21, 1e-9);
  EXPECT_NEAR(robot.legs[0].tibia, 0.11 - robot.foot_radius, 1e-9);
}

TEST(AwkwardRobots, MayEndInALinkWithASmallShape) {
  const RobotModel robot = expect_recognised(
      {.tibia_has = "<collision><origin xyz='0.05 0 0'/><geometry><box size='0.1 0.02 0.02'/>"
                    "</geometry></collision>",
       .foot = "<link name='f{0}'><collision><geometry><box size='0.01 0.02 0.012'/></geometry>"
               "</collision></link><joint name='t{0}' type='fixed'><parent link='l{0}c'/>"
               "<child link='f{0}'/><origin xyz='{1} 0 0'/></joint>"},
      {"the middle of the shape at its end, radius 0.005 m"});
  EXPECT_NEAR(robot.legs[0].tibia, 0.11, 1e-9);
  EXPECT_EQ(robot.legs[0].links.back().shapes.size(), 2U);  // the shin, and the ball
}

// The far end of a rod of 0.11 m; also if only its visual says so.
TEST(AwkwardRobots, MayEndInARod) {
  for (const std::string kind : {"collision", "visual"}) {
    const RobotModel robot = expect_recognised(
        {.tibia_has = "<" + kind +
                      "><origin xyz='0.055 0 0' rpy='0 1.5707963267948966 0'/><geometry><cylinder "
                      "radius='0.004' length='0.11'/></geometry></" +
                      kind + ">"},
        {"the outermost point of its shapes"});
    EXPECT_NEAR(robot.legs[0].tibia, 0.11 - robot.foot_radius, 2e-4);
  }
}

// A knee pad is no foot.
TEST(AwkwardRobots, MayHaveAKneePadAndARod) {
  const RobotModel robot = expect_recognised(
      {.tibia_has = "<collision><geometry><sphere radius='0.01'/></geometry></collision>"
                    "<collision><origin xyz='0.055 0 0'/><geometry><box size='0.11 0.008 0.008'/>"
                    "</geometry></collision>"},
      {"the outermost point of its shapes"});
  EXPECT_GT(robot.legs[0].tibia, 0.1);
}

// Meshes of another machine: the centre of mass is in the middle of a link.
TEST(AwkwardRobots, MayHaveOnlyMeshesThatAreNotHere) {
  RobotText robot{.tibia_has =
                      "<collision><geometry><mesh filename='package://other/tibia.stl'/>"
                      "</geometry></collision>"};
  robot.inertial = [](const std::string& name, double mass, double length) {
    std::string text = RobotText::plausible(name, mass, length);
    return name.back() == 'c' ? text.insert(10, fmt::format("<origin xyz='{} 0 0'/>", 0.5 * length))
                              : text;
  };
  const RobotModel model = expect_recognised(
      robot, {"twice as far as its centre of mass", "mesh package://other/tibia.stl"});
  EXPECT_NEAR(model.legs[0].tibia, 0.11 - model.foot_radius, 1e-9);
}

TEST(AwkwardRobots, AreRefusedIfNothingTellsWhereTheFeetAreAndTakenIfItIsGiven) {
  const RobotText robot{.tibia_has = ""};
  expect_refused(robot, {"robot.urdf:", "link l0c: has no shape", "--foot l0c=X,Y,Z", "link l5c"});
  UrdfOptions options;
  for (int i = 0; i < 6; ++i) options.feet[fmt::format("l{}c", i)] = {0.1, 0.0, 0.0};
  EXPECT_NEAR(expect_recognised(robot, {"2 link l0c foot"}, options).legs[0].tibia, 0.1, 1e-12);
}

// ---- what is no leg

TEST(AwkwardRobots, MayHaveAHeadATurretAndASensor) {
  const std::string more = RobotText::limb("pan", "revolute", "b", {0.12, 0, 0.03}, "0 0 1") +
                           RobotText::limb("tilt", "revolute", "pan", {0, 0, 0.03}, "0 1 0") +
                           RobotText::limb("turret", "continuous", "b", {0, 0, 0.03}, "0 0 1") +
                           RobotText::limb("lidar", "prismatic", "b", {-0.05, 0, 0.03}, "0 0 1");
  const RobotModel robot = expect_recognised(
      {.more = more}, {"3 joint to_pan joint: is no leg: gets down to z = 0.",
                       "3 joint to_turret joint: is no leg: turns about one axis only",
                       "3 joint to_lidar joint: has no joint that turns"});
  EXPECT_NEAR(robot.mass, 2.08, 1e-5);
  EXPECT_NEAR(robot.base.mass, 1.2 + 0.08, 1e-5);
}

// It could reach the ground, but nothing mirrors it, and it is longer than a leg.
TEST(AwkwardRobots, MayHaveAnArm) {
  std::string more = RobotText::limb("a0", "revolute", "b", {0.12, 0, 0.02}, "0 0 1");
  for (int i = 1; i < 5; ++i)
    more += RobotText::limb(fmt::format("a{}", i), "revolute", fmt::format("a{}", i - 1),
                            {0.12, 0, 0}, "0 1 0");
  (void)expect_recognised({.more = more},
                          {"3 joint to_a0 joint: is no leg: has no mirror partner"});
}

// The rear pair hangs from a link of its own, which turns against the body.
TEST(AwkwardRobots, MayHaveAWaist) {
  RobotText robot{.more = RobotText::limb("w", "revolute", "b", {0, 0, 0}, "0 0 1")};
  std::string text = robot.text();
  for (const int i : {4, 5}) {
    const std::size_t at = text.find("parent link='b'", text.find(fmt::format("name='q{}-0'", i)));
    text.replace(at, 15, "parent link='w'");
  }
  const RobotModel model = parse_urdf(text, "robot.urdf");
  expect_sound(model, 6);
  EXPECT_THAT(told(model),
              HasSubstr("3 joint to_w joint: moves the body's parts against each other"));
}

TEST(AwkwardRobots, MayHaveSlidingContactsAtTheirFeet) {
  const RobotModel robot = expect_recognised(
      {.tibia_has = "",
       .foot = "<link name='f{0}'><inertial><mass value='0.001'/></inertial><collision><geometry>"
               "<sphere radius='0.006'/></geometry></collision></link><joint name='s{0}' "
               "type='prismatic'><parent link='l{0}c'/><child link='f{0}'/><origin xyz='{1} 0 0'/>"
               "<limit lower='0' upper='0.004' velocity='1' effort='1'/></joint>"},
      {"3 joint s0 joint: slides by 0.004 m; held at 0"});
  EXPECT_EQ(robot.foot_radius, 0.006);
}

TEST(AwkwardRobots, MayHaveALegOnlyIfItIsToldWhichAreLegs) {
  UrdfOptions options;
  for (const int i : {0, 1, 4, 5}) options.legs.push_back(fmt::format("q{}-0", i));
  const RobotModel robot = parse_urdf(RobotText().text(), "robot.urdf", options);
  expect_sound(robot, 4);
  EXPECT_THAT(told(robot), HasSubstr("joint q2-0 joint: is no leg: is not among those of --legs"));
}

// ---- masses

RobotText with_inertial(const std::string& link, const std::string& text) {
  RobotText robot;
  robot.inertial = [=](const std::string& name, double mass, double length) {
    return name == link || link.empty() ? text : RobotText::plausible(name, mass, length);
  };
  return robot;
}

// A rod of 0.07 m and 7 mm radius, of water: 10.8 g.
TEST(AwkwardRobots, MayLackAMass) {
  for (const std::string text : {"", "<inertial><mass value='0'/></inertial>"}) {
    const RobotModel robot =
        expect_recognised(with_inertial("l2b", text), {"1 link l2b mass: none; 0.0107757 kg"});
    EXPECT_NEAR(robot.legs[2].links[1].mass, std::numbers::pi * 0.007 * 0.007 * 0.07 * 1000.0,
                1e-9);
    EXPECT_LT((robot.legs[2].links[1].p_LM - Vector3(0.035, 0.0, 0.0)).norm(), 1e-12);
  }
  (void)expect_recognised(with_inertial("b", ""), {"1 link b mass: none; 0.704 kg"});
}

TEST(AwkwardRobots, MayWeighNextToNothingOrFarTooMuch) {
  const RobotModel light = expect_recognised(with_inertial("", RobotText::plausible("", 1e-5, 0.1)),
                                             {"1 link b mass: 1e-05 kg"});
  EXPECT_GT(light.mass, 0.5);
  const RobotModel heavy = expect_recognised(
      {.mass = 84.0}, {"1 link b mass: 50.4 kg, in a robot of 0.310623 m", "--density"});
  EXPECT_LT(heavy.mass, 3.0);
}

TEST(AwkwardRobots, MayHaveImpossibleInertias) {
  for (const auto& [inertia, words] : {std::pair("6", "radius of gyration 1.9"),
                                       {"0", "smallest principal moment 0"},
                                       {"-1", "smallest principal moment -1"},
                                       {"1e-12", "radius of gyration 7.9"}})
    (void)expect_recognised(
        with_inertial("b", fmt::format("<inertial><mass value='1.6'/><inertia ixx='{0}' iyy='{0}' "
                                       "izz='{0}' ixy='0' ixz='0' iyz='0'/></inertial>",
                                       inertia)),
        {"1 link b inertia: ", words});
}

TEST(AwkwardRobots, WeighWhatTheyAreTold) {
  const RobotModel robot =
      expect_recognised({}, {"2 robot mass: 2 kg; 3 kg --mass"}, {.mass = 3.0});
  EXPECT_NEAR(robot.mass, 3.0, 1e-12);
}

// ---- joints

TEST(AwkwardRobots, MayLackLimits) {
  (void)expect_recognised({.yaw = "", .hip = "", .knee = ""},
                          {"1 joint q0-0 limits: none; -1.5708 to 1.5708 rad --joint-range",
                           "1 joint q5-2 limits: none; -2.61799 to 2.61799 rad"});
  (void)expect_recognised({.knee = "lower='0' upper='0'"}, {"1 joint q0-2 limits: 0 to 0 rad"});
  (void)expect_recognised({.yaw = "lower='-1e16' upper='1e16'"}, {"limits: -1e+16 to 1e+16 rad"});
  (void)expect_recognised({.yaw = "", .hip = "", .knee = "", .type = "continuous"});
}

// √(9.81/0.21) = 6.835, times 1.5; half of 2 · 9.81 · 0.21.
TEST(AwkwardRobots, MayHaveAbsurdDrives) {
  const RobotModel robot = expect_recognised(
      {.drive = "velocity='0' effort='1e4'"},
      {"1 joint q0-0 velocity limit: 0 rad/s; 10.2", "1 joint q0-0 effort limit: 10000 N m; 2.06"});
  EXPECT_NEAR(robot.legs[0].limits[0].velocity, 1.5 * std::sqrt(9.81 / 0.21), 1e-9);
  (void)expect_recognised({.drive = ""}, {"velocity limit: none", "effort limit: none"});
  (void)expect_recognised({.drive = ""},
                          {"2 joint q0-1 velocity limit: none; 4 rad/s --joint-speed"},
                          {.joint_speed = 4.0});
}

TEST(AwkwardRobots, MayNotBeAllowedToBeAtZero) {
  (void)expect_recognised({.hip = "lower='-1.5' upper='-0.2'", .knee = "lower='0.5' upper='2.5'"});
}

// A coxa of ±24° and a tibia of more than twice the femur.
TEST(AwkwardRobots, MayHaveShortFemursAndLittleYaw) {
  (void)expect_recognised({.femur = 0.05, .tibia = 0.13, .yaw = "lower='-0.42' upper='0.42'"});
}

// Yaw 0 is forbidden, by mirrored limits: the legs stand splayed.
TEST(AwkwardRobots, StandNearTheirUsualStanceIfTheyMayNotTakeIt) {
  RobotText robot{.knee = "lower='0' upper='1.2'"};
  const RobotModel model =
      expect_recognised(robot, {"0 leg q0 stance: foot 0.1 m out", "below the hip"});
  for (const LegModel& leg : model.legs) EXPECT_GT(leg.workspace_radius, 0.05 * 0.21);
}

// ---- names and bodies

TEST(AwkwardRobots, MayGiveTwoLegsOneName) {
  RobotText robot;
  robot.joint_name = [](int leg, int joint) { return fmt::format("joint_{}", 3 * leg + joint); };
  const RobotModel model = expect_recognised(robot, {"name of the leg: joint; LF, by its place"});
  EXPECT_EQ(model.legs[5].name, "RR");
}

TEST(AwkwardRobots, MayHaveABodyWithoutAShape) {
  const RobotModel robot = expect_recognised(
      {.base = ""}, {"1 link b shape of the body: none; the bounding box of its hips"});
  EXPECT_LT((robot.base.shapes[0].size.head<2>() - Vector2(0.18, 0.09)).norm(), 1e-9);
}

// ---- all of it at once

TEST(AwkwardRobots, MayBeAwkwardInManyWays) {
  RobotText robot{.size = 0.8,
                  .mass = 1.5,
                  .hips = RobotText::rows(4),
                  .root = RobotText::placed({0.2, 0.1, 0.3}, {0, 0, 0.5 * std::numbers::pi}),
                  .base = "",
                  .tibia_has = "",
                  .foot =
                      "<link name='f{0}'/><joint name='t{0}' type='fixed'><parent link='l{0}c'/>"
                      "<child link='f{0}'/><origin xyz='{1} 0 0'/></joint>",
                  .more = RobotText::limb("pan", "revolute", "b", {0.1, 0, 0.05}, "0 0 1"),
                  .drive = "velocity='0' effort='0'",
                  .yaw = ""};
  robot.inertial = [](const std::string&, double, double) { return std::string(); };
  (void)expect_recognised(
      robot, {"front", "origin of the body", "foot", "shape of the body", "mass", "velocity limit",
              "effort limit", "limits", "joint to_pan"});
}

}  // namespace
}  // namespace hexagait

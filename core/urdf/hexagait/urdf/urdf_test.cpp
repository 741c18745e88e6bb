// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <fstream>
#include <hexagait/model/robot_model.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <sstream>
#include <testing/source_path.hpp>

namespace hexagait::urdf_test {
namespace {

const std::string kArgosPath = testing::source_path("robots/argos.urdf");

double distance(const Vector3& a, const Vector3& b) { return (a - b).norm(); }

// 32 + 6 · (1.0 + 1.2 + 0.8).
TEST(Argos, HasSixLegsInOrderAndWeighsFiftyKilograms) {
  const RobotModel argos = load_urdf(kArgosPath);
  ASSERT_EQ(argos.num_legs(), 6);
  std::string names;
  for (const LegModel& leg : argos.legs) names += leg.name + " ";
  EXPECT_EQ(names, "LF RF LM RM LR RR ");
  EXPECT_EQ(argos.name, "argos");
  EXPECT_NEAR(argos.mass, 50.0, 1e-13);
  EXPECT_EQ(argos.foot_radius, 0.02);
}

// 0.96 · 0.66 = 0.6336; knee 2.76 rad: √(0.28² + 0.38² + 2·0.28·0.38·cos 2.76) = 0.15908. A third
// of 0.66 m for the disc.
TEST(Argos, HasTheWorkspaceItsLimitsAreMadeFor) {
  for (const LegModel& leg : load_urdf(kArgosPath).legs) {
    EXPECT_NEAR(leg.coxa, 0.08, 1e-15);
    EXPECT_NEAR(leg.femur, 0.28, 1e-15);
    EXPECT_NEAR(leg.tibia, 0.38, 1e-15);
    EXPECT_NEAR(leg.min_reach, 0.15908, 5e-6);
    EXPECT_NEAR(leg.max_reach, 0.6336, 1e-15);
    EXPECT_NEAR(leg.workspace_radius, 0.22, 1e-15);
    EXPECT_EQ(leg.limits[1].velocity, 8.0);
    EXPECT_EQ(leg.limits[2].effort, 200.0);
  }
}

// Left hip (0.35, 0.17), splayed forwards by 0.4 rad: the centre is 0.36 m along (sin 0.4, cos
// 0.4).
TEST(Argos, HasSplayedWorkspaceCentresThatMirrorEachOther) {
  const RobotModel argos = load_urdf(kArgosPath);
  const Vector3 expected(0.35 + 0.36 * std::sin(0.4), 0.17 + 0.36 * std::cos(0.4), -0.3);
  EXPECT_LT(distance(argos.legs[0].p_BC, expected), 1e-15);
  for (LegId left = 0; left < 6; left += 2) {
    const Vector3 c = argos.legs[left].p_BC;
    EXPECT_LT(distance(argos.legs[left + 1].p_BC, {c.x(), -c.y(), c.z()}), 1e-15);
  }
}

// Two joints: 0.02 m to the lift axis, 0.10 m to the foot, lowered by 45°. Angles of the file have six digits.
TEST(Genghis, HasLegsOfTwoJoints) {
  const RobotModel genghis = load_urdf(testing::source_path("robots/genghis.urdf"));
  ASSERT_EQ(genghis.num_legs(), 6);
  EXPECT_NEAR(genghis.mass, 1.0, 1e-12);
  const double side = 0.1 * std::sqrt(0.5);
  for (LegId i = 0; i < 6; ++i) {
    const LegModel& leg = genghis.legs[i];
    EXPECT_EQ(leg.kind, LegKind::yaw_pitch);
    EXPECT_TRUE(leg.has_two_joints());
    EXPECT_NEAR(leg.coxa, 0.02, 1e-12);
    EXPECT_NEAR(leg.femur, 0.10, 1e-12);
    const double y = (i % 2 == 0 ? 1.0 : -1.0) * (0.055 + 0.02 + side);
    EXPECT_LT(distance(leg.p_BC, {0.13 * (1 - i / 2), y, -side}), 1e-6);
    EXPECT_NEAR(leg.workspace_radius, 0.1 / 3.0, 1e-9);
  }
}

// By the legs' symmetry in x = y = 0. Height, in the nominal stance: the knee is square-on where
// cos k₃ = (0.28² + 0.3² − 0.28² − 0.38²) / (2·0.28·0.38), and so on by the law of cosines; femur,
// shin and foot have their centres at half the knee's height, midway from knee to foot, and at
// −0.3.
TEST(Argos, HasItsCentreOfMassInTheMiddleJustBelowTheHips) {
  const double d = std::hypot(0.28, 0.30);
  const double inner = std::acos((0.28 * 0.28 + d * d - 0.38 * 0.38) / (2.0 * 0.28 * d));
  const double knee_z = 0.28 * std::sin(inner - std::atan2(0.30, 0.28));
  const double leg_moment = 1.2 * knee_z / 2.0 + 0.78 * (knee_z - 0.3) / 2.0 - 0.02 * 0.3;
  EXPECT_LT(distance(load_urdf(kArgosPath).p_BM, {0.0, 0.0, 6.0 * leg_moment / 50.0}), 1e-15);
}

// Box: m/12 · (b² + c²) …. Tibia and foot: parallel axes about their common centre of mass. The
// file gives six digits.
TEST(Argos, HasTheInertiasOfABoxAndOfARodWithABallAtItsEnd) {
  const RobotModel argos = load_urdf(kArgosPath);
  const Vector3 box(0.09 + 0.0144, 0.64 + 0.0144, 0.64 + 0.09);
  EXPECT_LT((argos.base.inertia_M_L.diagonal() - 32.0 / 12.0 * box).norm(), 5e-6);

  const LinkModel& tibia = argos.legs[3].links[2];
  const double com = (0.78 * 0.19 + 0.02 * 0.38) / 0.8;
  const double rod = 0.78 * (3.0 * 0.015 * 0.015 + 0.38 * 0.38) / 12.0;
  const double ball = 0.4 * 0.02 * 0.02 * 0.02;
  const double across =
      rod + 0.78 * std::pow(com - 0.19, 2) + ball + 0.02 * std::pow(0.38 - com, 2);
  EXPECT_NEAR(tibia.mass, 0.8, 1e-15);
  EXPECT_LT(distance(tibia.p_LM, {com, 0.0, 0.0}), 1e-15);
  EXPECT_NEAR(tibia.inertia_M_L(1, 1), across, 1e-8);
  EXPECT_NEAR(tibia.inertia_M_L(2, 2), across, 1e-8);
}

TEST(Argos, CarriesItsFootAsASphereOfTheTibia) {
  for (const LegModel& leg : load_urdf(kArgosPath).legs) {
    ASSERT_EQ(leg.links[2].shapes.size(), 2U);
    EXPECT_EQ(leg.links[0].shapes.size(), 1U);
    const Shape &shin = leg.links[2].shapes[0], &foot = leg.links[2].shapes[1];
    EXPECT_EQ(shin.kind, Shape::Kind::cylinder);
    EXPECT_EQ(shin.size.head<2>(), Vector2(0.015, 0.38));
    EXPECT_LT(distance(shin.X_LS.R.col(2), Vector3::UnitX()), 1e-15);
    EXPECT_EQ(foot.kind, Shape::Kind::sphere);
    EXPECT_EQ(foot.size.x(), 0.02);
    EXPECT_LT(distance(leg.links[2].X_BL0 * foot.X_LS.p, leg.p_BF0), 1e-15);
  }
}

TEST(Argos, HasABoxForABody) {
  const RobotModel argos = load_urdf(kArgosPath);
  ASSERT_EQ(argos.base.shapes.size(), 1U);
  EXPECT_EQ(argos.base.shapes[0].kind, Shape::Kind::box);
  EXPECT_EQ(argos.base.shapes[0].size, Vector3(0.8, 0.3, 0.12));
}

std::string argos_text() {
  std::ifstream file(kArgosPath);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

// A pack of 2 kg is fixed at z = 0.3 on a pole (a frame without mass) on the body of 32 kg: the
// centre of mass is at 0.3 · 2/34, and about it bodies 0.3 m apart have 32·2/34 · 0.3² more
// inertia. The pole is rolled by 90°: its y is the body's z, its z the body's −y. So in the body's
// axes the pack has xx, yy, zz = 0.1, 0.3, 0.2 and xy, xz, yz = −0.02, 0.01, −0.03.
TEST(ParseUrdf, MergesWhatIsFixedToALink) {
  const std::string pack =
      "<link name='pole'/><link name='pack'><inertial><mass value='2'/><inertia ixx='0.1' "
      "iyy='0.2' izz='0.3' ixy='0.01' ixz='0.02' iyz='0.03'/></inertial><collision>"
      "<origin xyz='0.1 0 0'/><geometry><sphere radius='0.05'/></geometry></collision></link>"
      "<joint name='p1' type='fixed'><parent link='base_link'/><child link='pole'/>"
      "<origin xyz='0 0 0.1' rpy='1.5707963267948966 0 0'/></joint>"
      "<joint name='p2' type='fixed'><parent link='pole'/><child link='pack'/>"
      "<origin xyz='0 0.2 0'/></joint>";
  std::string text = argos_text();
  text.insert(text.find("</robot>"), pack);
  const RobotModel plain = load_urdf(kArgosPath), robot = parse_urdf(text, "argos");
  EXPECT_NEAR(robot.mass, 52.0, 1e-13);
  EXPECT_NEAR(robot.base.mass, 34.0, 1e-14);
  EXPECT_LT(distance(robot.base.p_LM, {0.0, 0.0, 0.3 * 2.0 / 34.0}), 1e-15);
  EXPECT_LT(distance(52.0 * robot.p_BM, 50.0 * plain.p_BM + Vector3(0.0, 0.0, 0.6)), 1e-13);
  EXPECT_LT(distance(robot.base.shapes[1].X_LS.p, {0.1, 0.0, 0.3}), 1e-15);

  const double apart = 64.0 / 34.0 * 0.09;
  Matrix3 more;
  more << 0.1 + apart, -0.02, 0.01, -0.02, 0.3 + apart, -0.03, 0.01, -0.03, 0.2;
  EXPECT_LT((robot.base.inertia_M_L - plain.base.inertia_M_L - more).norm(), 1e-14);
}

TEST(ParseUrdf, TakesAContinuousJointToTurnHalfATurnEachWay) {
  std::string text = argos_text();
  text.replace(text.find("revolute", text.find("LF_yaw")), 8, "continuous");
  const LegModel leg = parse_urdf(text, "argos").legs[0];
  EXPECT_EQ(leg.limits[0].lower, -std::numbers::pi);
  EXPECT_EQ(leg.limits[0].upper, std::numbers::pi);
  EXPECT_EQ(leg.limits[0].effort, 120.0);
}

}  // namespace
}  // namespace hexagait::urdf_test

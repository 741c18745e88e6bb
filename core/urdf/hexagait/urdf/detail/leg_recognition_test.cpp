// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <hexagait/model/kinematics.hpp>
#include <hexagait/sim/random.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/urdf/detail/leg_recognition.hpp>
#include <hexagait/urdf/urdf.hpp>

namespace hexagait {
namespace {

double distance(const Vector3& a, const Vector3& b) { return (a - b).norm(); }

/// How a robot's maker may choose to count its joints: k = sign · q + zero.
struct Convention {
  Vector3 sign = Vector3::Ones();
  double hip_zero = 0.0, knee_zero = 0.0;  ///< canonical pitch where the joint is at zero
  bool axes_along_z = false;               ///< joint frames turned, so that pitch axes are their z
};

// Every link has 1 kg. {leg}b is a bracket without mass, fixed to the coxa; it puts the hip 0.03 m
// beside the plane of the yaw axis, and the femur leads the knee back into it.
constexpr const char* kLink = R"(
<link name='{}'><inertial><mass value='1'/>
  <inertia ixx='0.01' iyy='0.01' izz='0.01' ixy='0' ixz='0' iyz='0'/></inertial>{}</link>)";
constexpr const char* kJoint = R"(
<joint name='{0}{1}' type='revolute'><parent link='{2}'/><child link='{0}{3}'/>
  <origin xyz='{4}' rpy='{5}'/><axis xyz='{6}'/>
  <limit lower='{7}' upper='{8}' velocity='8' effort='100'/></joint>)";
constexpr const char* kBracket = R"(
<link name='{0}b'/><joint name='{0}fixed' type='fixed'><parent link='{0}c'/><child link='{0}b'/>
  <origin xyz='0.1 0.03 -0.05'/></joint>)";
constexpr const char* kFootAndKneePad = R"(
<collision><origin xyz='0.3 0 0'/><geometry><sphere radius='0.03'/></geometry></collision>
<collision><origin xyz='0.05 0 0'/><geometry><sphere radius='0.04'/></geometry></collision>)";

/// Coxa 0.1, femur 0.2, tibia 0.3, hip-pitch axis at the height 0; canonical limits: yaw ±1, hip
/// −1.5 … 1.5, knee 0.2 … 2.6. If axes are along z, the femur's frame is rolled by −90° about x:
/// its z is then the leg's y, and a turn about z is a pitch.
std::string leg_text(const std::string& leg, double x, double y, const Convention& convention) {
  const bool rolled = convention.axes_along_z;
  const std::string pitch_axis = rolled ? "0 0 {}" : "0 {} 0";
  const auto joint = [&](int i, const std::string& parent, const char* child,
                         const std::string& xyz, const std::string& rpy, const std::string& axis,
                         double zero, double lower, double upper) {
    const double sign = convention.sign[i];
    const double a = sign * (lower - zero), b = sign * (upper - zero);
    return fmt::format(kJoint, leg, i + 1, parent, child, xyz, rpy,
                       fmt::format(fmt::runtime(axis), sign), std::min(a, b), std::max(a, b));
  };
  const double hip = convention.hip_zero, knee = convention.knee_zero;
  const std::string outwards =
      fmt::format("0 0 {}", y > 0.0 ? std::numbers::pi / 2 : -std::numbers::pi / 2);
  const std::string hip_rpy = fmt::format("{} {} 0", rolled ? -std::numbers::pi / 2 : 0.0, hip);
  const std::string knee_rpy = fmt::format(fmt::runtime(pitch_axis), knee);
  return joint(0, "body", "c", fmt::format("{} {} 0.05", x, y), outwards, "0 0 {}", 0.0, -1.0,
               1.0) +
         fmt::format(kBracket, leg) +
         joint(1, leg + "b", "f", "0 0 0", hip_rpy, pitch_axis, hip, -1.5, 1.5) +
         joint(2, leg + "f", "t", rolled ? "0.2 0 -0.03" : "0.2 -0.03 0", knee_rpy, pitch_axis,
               knee, 0.2, 2.6) +
         fmt::format(kLink, leg + "c", "") + fmt::format(kLink, leg + "f", "") +
         fmt::format(kLink, leg + "t", kFootAndKneePad);
}

/// Pairs of legs a and b, c and d, … at x = 0.2, −0.2, … and y = ±0.1; listed rear right to front
/// left.
std::string robot_of(int pairs, const Convention& convention) {
  std::string text = "<robot name='robot'>" + fmt::format(kLink, "body", "");
  for (int i = 2 * pairs - 1; i >= 0; --i)
    text += leg_text(std::string(1, static_cast<char>('a' + i)), 0.2 - 0.4 * (i / 2),
                     i % 2 == 0 ? 0.1 : -0.1, convention);
  return text + "</robot>";
}

std::string quadruped(const Convention& convention) { return robot_of(2, convention); }

std::vector<Convention> conventions() {
  std::vector<Convention> all;
  for (int bits = 0; bits < 16; ++bits) {
    const Vector3 sign(bits & 1 ? -1.0 : 1.0, bits & 2 ? -1.0 : 1.0, bits & 4 ? -1.0 : 1.0);
    for (const Vector2& zeros : {Vector2(0.0, 0.0), Vector2(-0.7, 1.9), Vector2(2.5, 2.0)})
      all.push_back({sign, zeros[0], zeros[1], (bits & 8) != 0});
  }
  return all;
}

TEST(ParseUrdf, TakesFourToTwelveLegsAndOrdersThemByTheirHips) {
  for (int pairs = 2; pairs <= 6; ++pairs) {
    std::string names;
    for (const LegModel& leg : parse_urdf(robot_of(pairs, {}), "robot").legs) names += leg.name;
    EXPECT_EQ(names, std::string("abcdefghijkl").substr(0, static_cast<std::size_t>(2 * pairs)));
  }
  for (const int pairs : {1, 7})
    EXPECT_THROW((void)parse_urdf(robot_of(pairs, {}), ""), InvalidInput);
}

// The maker's own numbers come back: link lengths, hip frame, signs and zeros.
TEST(ParseUrdf, RecognisesTheLegForAnySignsAndZeros) {
  for (const Convention& convention : conventions()) {
    const LegModel leg = parse_urdf(quadruped(convention), "four").legs[1];
    EXPECT_NEAR(leg.coxa, 0.1, 1e-15);
    EXPECT_NEAR(leg.femur, 0.2, 1e-15);
    EXPECT_NEAR(leg.tibia, 0.3, 1e-15);
    EXPECT_LT(distance(leg.X_BH.p, {0.2, -0.1, 0.0}), 1e-15);
    EXPECT_LT((leg.X_BH.R - rotation_z(-std::numbers::pi / 2)).norm(), 1e-15);
    EXPECT_EQ(leg.joint_sign, convention.sign);
    const Vector3 zeros(0.0, convention.hip_zero, convention.knee_zero);
    EXPECT_LT(distance(leg.joint_offset, zeros), 2e-15);
  }
}

// Femur and tibia have 0.5 m, so the foot is 0.1 + 0.2 out of the hip and 0.5/2.2 down.
TEST(ParseUrdf, GivesTheSameWorkspaceForAnySignsAndZeros) {
  const RobotModel reference = parse_urdf(quadruped({}), "four");
  EXPECT_LT(distance(reference.legs[0].p_BC, {0.2, 0.1 + 0.3, -0.5 / 2.2}), 1e-15);
  for (const Convention& convention : conventions()) {
    const RobotModel robot = parse_urdf(quadruped(convention), "four");
    EXPECT_NEAR(robot.mass, 13.0, 1e-14);
    EXPECT_LT(distance(robot.p_BM, reference.p_BM), 1e-14);
    for (LegId leg = 0; leg < 4; ++leg) {
      EXPECT_LT(distance(robot.legs[leg].p_BC, reference.legs[leg].p_BC), 1e-14);
      EXPECT_NEAR(robot.legs[leg].min_reach, reference.legs[leg].min_reach, 1e-14);
      EXPECT_NEAR(robot.legs[leg].max_reach, reference.legs[leg].max_reach, 1e-14);
      EXPECT_NEAR(robot.legs[leg].workspace_radius, reference.legs[leg].workspace_radius, 1e-12);
    }
  }
}

// The joint values for a target put the foot there by the robot's own axes (link_pose), whatever
// the convention: recognition, inverse kinematics and axes agree.
TEST(ParseUrdf, PutsTheFootWhereItIsAskedForAnySignsAndZeros) {
  RandomSequence random{.seed = 21};
  for (const Convention& convention : conventions()) {
    const RobotModel robot = parse_urdf(quadruped(convention), "four");
    for (int k = 0; k < 40; ++k) {
      const LegModel& leg = robot.legs[k % 4];
      const Vector3 p_BF = leg.p_BC + 0.08 * Vector3(random.uniform(-1, 1), random.uniform(-1, 1),
                                                     random.uniform(-1, 1));
      const LegSolution solution = inverse_kinematics(leg, p_BF);
      const Vector3 p_TF = leg.links[2].X_BL0.inverse() * leg.p_BF0;
      ASSERT_TRUE(solution.reachable);
      EXPECT_LT(distance(link_pose(leg, 2, solution.q) * p_TF, p_BF), 1e-14);
    }
  }
}

/// A chain whose axes are canonical and whose points are given: yaw, hip, knee, foot.
SerialChain chain_of(const Vector3& yaw, const Vector3& hip, const Vector3& knee,
                     const Vector3& foot) {
  SerialChain chain;
  chain.joints = {{"yaw", yaw, Vector3::UnitZ(), {}},
                  {"hip", hip, Vector3::UnitY(), {}},
                  {"knee", knee, Vector3::UnitY(), {}}};
  chain.links.resize(3);
  chain.foot = {foot, 0.02};
  return chain;
}

Vector3 outward_direction(const SerialChain& chain) { return recognise_leg(chain).X_BH.R.col(0); }

// Pitch axes along y, so outwards is x or −x.
TEST(RecogniseLeg, TakesOutwardsFromTheCoxaElseFromTheFootElseFromTheBody) {
  const Vector3 in(-1, 0, 0), out(1, 0, 0);
  EXPECT_EQ(outward_direction(chain_of({1, 0, 0}, {0.9, 0, 0}, {2, 0, 0}, {3, 0, 0})), in);
  EXPECT_EQ(outward_direction(chain_of({1, 0, 0}, {1, 0, 0}, {1.5, 0, 1}, {0.7, 0, 0})), in);
  EXPECT_EQ(outward_direction(chain_of({-1, 0, 0}, {-1, 0, 0}, {0, 0, 1}, {-0.7, 0, 0})), out);
  EXPECT_EQ(outward_direction(chain_of({-1, 0, 0}, {-1, 0, 0}, {0, 0, 1}, {-1, 0, -1})), in);
  EXPECT_EQ(outward_direction(chain_of({1, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1, 0, -1})), out);
}

LegKind kind_of(const SerialChain& chain) { return recognise_leg(chain).kind; }

// Within 1e-4: what a file with four decimals can say.
TEST(RecogniseLeg, TakesALegForYawPitchPitchIfItsErrorsAreSmall) {
  const auto recognised = [](int joint, const Vector3& axis, double foot_y) {
    SerialChain chain = chain_of({1, 0, 0}, {1.1, 0, 0}, {1.3, 0, 0}, {1.6, foot_y, 0});
    chain.joints[static_cast<std::size_t>(joint)].axis_B0 = axis.normalized();
    return kind_of(chain) == LegKind::yaw_pitch_pitch;
  };
  EXPECT_TRUE(recognised(0, {0.9e-4, 0, 1}, 0.9e-4));
  EXPECT_TRUE(recognised(1, {0, 1, 0.9e-4}, 0.0));
  EXPECT_TRUE(recognised(2, {0, 1, 0.9e-4}, 0.0));
  EXPECT_FALSE(recognised(0, {1.1e-4, 0, 1}, 0.0));
  EXPECT_FALSE(recognised(1, {0, 1, 1.1e-4}, 0.0));
  EXPECT_FALSE(recognised(2, {0, 1, 1.1e-4}, 0.0));
  EXPECT_FALSE(recognised(0, {0, 0, 1}, 1.1e-4));
}

TEST(RecogniseLeg, WantsLevelPitchAxesNotJustParallelOnes) {
  SerialChain chain = chain_of({1, 0, 0}, {1.1, 0, 0}, {1.3, 0, 0}, {1.6, 0, 0});
  chain.joints[1].axis_B0 = chain.joints[2].axis_B0 = Vector3(0, 1, 0.1).normalized();
  EXPECT_EQ(kind_of(chain), LegKind::serial);
}

/// As many joints about x, y, z, x, … as asked for, one under the other.
SerialChain chain_of(int joints) {
  SerialChain chain;
  for (int i = 0; i < joints; ++i)
    chain.joints.push_back({std::string(1, static_cast<char>('a' + i)),
                            {0.0, 0.2, -0.1 * i},
                            Vector3::Unit(i % 3),
                            {}});
  chain.links.resize(static_cast<std::size_t>(joints));
  chain.foot = {Vector3(0.0, 0.2, -0.1 * joints), 0.02};
  return chain;
}

TEST(RecogniseLeg, TakesThreeToSixJoints) {
  for (int joints = 3; joints <= 6; ++joints) {
    const LegModel leg = recognise_leg(chain_of(joints));
    EXPECT_EQ(leg.num_joints(), joints);
    EXPECT_EQ(leg.links.size(), joints);
  }
}

// Roll about x through (0, 0.2, 0), pitch about y through (0, 0.2, −0.1): they are nearest at the
// former. A leg that hangs down stands to the side of its hip.
TEST(RecogniseLeg, HasTheHipOfASerialLegWhereItsFirstTwoAxesAreNearest) {
  for (const double side : {1.0, -1.0}) {
    SerialChain chain = chain_of(4);
    for (TreeJoint& joint : chain.joints) joint.p_BJ0 += Vector3(0.7, 0.0, 0.0) * joint.axis_B0.x();
    for (TreeJoint& joint : chain.joints) joint.p_BJ0.y() *= side;
    chain.foot->p_BF0.y() *= side;
    const LegModel leg = recognise_leg(chain);
    EXPECT_LT(distance(leg.X_BH.p, {0.0, 0.2 * side, 0.0}), 1e-15);
    EXPECT_LT(distance(leg.X_BH.R.col(0), {0.0, side, 0.0}), 1e-15);
    EXPECT_LT(distance(leg.X_BH.R.col(2), {0.0, 0.0, 1.0}), 1e-15);
  }
}

}  // namespace
}  // namespace hexagait

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <urdf_parser/urdf_parser.h>

#include <hexagait/urdf/detail/rotations.hpp>

namespace hexagait {
namespace {

constexpr const char* kRobot = R"(
<robot name="r">
  <link name="base">
    <inertial><origin rpy="0.1 -0.2 3"/><mass value="1"/>
      <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
    <collision><geometry><sphere radius="1"/></geometry></collision>
    <collision><origin xyz="1 2 3" rpy="-1.5 0.7 2"/><geometry><sphere radius="1"/></geometry></collision>
  </link>
  <link name="arm"/>
  <joint name="elbow" type="fixed"><origin rpy="0 1.5707963267948966 -2.5"/>
    <parent link="base"/><child link="arm"/></joint>
</robot>)";

void expect_equal(const urdf::Rotation& a, const urdf::Rotation& b) {
  EXPECT_NEAR(a.x, b.x, 3e-16);
  EXPECT_NEAR(a.y, b.y, 3e-16);
  EXPECT_NEAR(a.z, b.z, 3e-16);
  EXPECT_NEAR(a.w, b.w, 3e-16);
}

// The oracle is urdfdom itself: spoilt rotations come back, all of them, each in its place.
TEST(RecomputedRotations, AreThoseOfUrdfdom) {
  const urdf::ModelInterfaceSharedPtr expected = urdf::parseURDF(kRobot);
  const urdf::ModelInterfaceSharedPtr model = urdf::parseURDF(kRobot);
  urdf::Link& base = *model->links_.at("base");
  urdf::Joint& elbow = *model->joints_.at("elbow");
  ASSERT_EQ(base.collision_array.size(), 2U);
  for (urdf::Pose* pose : {&base.inertial->origin, &base.collision_array[1]->origin,
                           &elbow.parent_to_joint_origin_transform})
    pose->rotation = urdf::Rotation(1.0, 0.0, 0.0, 0.0);

  recompute_rotations(*model, kRobot);

  const urdf::Link& right = *expected->links_.at("base");
  expect_equal(base.inertial->origin.rotation, right.inertial->origin.rotation);
  for (std::size_t i = 0; i < 2; ++i)
    expect_equal(base.collision_array[i]->origin.rotation,
                 right.collision_array[i]->origin.rotation);
  expect_equal(elbow.parent_to_joint_origin_transform.rotation,
               expected->joints_.at("elbow")->parent_to_joint_origin_transform.rotation);
}

}  // namespace
}  // namespace hexagait

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/urdf/detail/meshes.hpp>
#include <hexagait/urdf/urdf.hpp>

#include "testing/robot_text.hpp"

namespace hexagait {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using testing::RobotText;

/// A directory with a tetrahedron as STL, OBJ and Collada: a base of 10 × 8 in the plane x = 0 and
/// its tip at (110, 0, 0), in millimetres; Collada with y up.
class MeshFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string problem;
    (void)read_mesh("none", problem);
    if (problem.find("without assimp") != problem.npos) GTEST_SKIP() << problem;
    fs::create_directories(directory_ / "mine/meshes");
    fs::create_directories(directory_ / "mine/urdf");
    std::ofstream(directory_ / "mine/meshes/tibia.stl") << R"(solid tibia
facet normal 0 0 0
outer loop
vertex 0 5 -4
vertex 0 -5 -4
vertex 110 0 0
endloop
endfacet
facet normal 0 0 0
outer loop
vertex 0 0 4
vertex 0 5 -4
vertex 110 0 0
endloop
endfacet
endsolid tibia
)";
    std::ofstream(directory_ / "mine/meshes/tibia.obj")
        << "v 0 5 -4\nv 0 -5 -4\nv 0 0 4\nv 110 0 0\nf 1 2 4\nf 3 1 4\nf 2 3 4\n";
    std::ofstream(directory_ / "mine/meshes/tibia.dae") << R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="meter" meter="1"/><up_axis>Y_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="a" count="12">
0 5 -4 0 -5 -4 0 0 4 110 0 0</float_array><technique_common><accessor source="#a" count="4" stride="3">
<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor>
</technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="3"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 3 2 0 3 1 2 3</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/></node>
</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
  }
  void TearDown() override { fs::remove_all(directory_); }

  [[nodiscard]] std::string urdf() const { return (directory_ / "mine/urdf/mine.urdf").string(); }

  fs::path directory_ = fs::path(::testing::TempDir()) /
                        ::testing::UnitTest::GetInstance()->current_test_info()->name();
};

RobotText with_mesh(const std::string& name) {
  return {.tibia_has = "<visual><geometry><mesh filename='" + name +
                       "' scale='0.001 0.001 0.001'/></geometry></visual>"};
}

// The tip of the tetrahedron touches the ground.
TEST_F(MeshFiles, TellWhereTheFootIsWhateverTheirKind) {
  for (const char* name : {"package://mine/meshes/tibia.stl", "../meshes/tibia.obj",
                           "model://mine/meshes/tibia.dae"}) {
    const RobotModel robot = parse_urdf(with_mesh(name).text(), urdf());
    EXPECT_NEAR(robot.legs[0].tibia, 0.11 - robot.foot_radius, 1e-6) << name;
    EXPECT_EQ(robot.legs[0].kind, LegKind::yaw_pitch_pitch) << name;
  }
}

TEST_F(MeshFiles, AreFoundInThePackagesThatAreGiven) {
  const std::string text = with_mesh("package://mine/meshes/tibia.stl").text();
  try {
    (void)parse_urdf(text, "robot.urdf");
    ADD_FAILURE() << "found";
  } catch (const InvalidInput& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("mesh package://mine/meshes/tibia.stl: is not on this machine "
                          "(--package)"));
  }
  const RobotModel robot = parse_urdf(text, "robot.urdf", {.packages = {directory_.string()}});
  EXPECT_NEAR(robot.legs[0].tibia, 0.11 - robot.foot_radius, 1e-6);
}

// The body's box: 110 × 10 × 8 mm.
TEST_F(MeshFiles, GiveTheBodyItsShape) {
  RobotText text;
  text.base =
      "<collision><geometry><mesh filename='../meshes/tibia.obj' scale='0.001 0.001 0.001'/>"
      "</geometry></collision>";
  const RobotModel robot = parse_urdf(text.text(), urdf());
  EXPECT_LT((robot.base.shapes.at(0).size - Vector3(0.11, 0.01, 0.008)).norm(), 1e-6);
}

TEST_F(MeshFiles, OfNonsenseAreLeftOutAndSaidSo) {
  std::ofstream(directory_ / "mine/meshes/tibia.stl") << "no mesh";
  RobotText text;
  text.tibia_has += "<visual><geometry><mesh filename='../meshes/tibia.stl'/></geometry></visual>";
  text.base = "<collision><geometry><mesh filename='../meshes/tibia.stl'/></geometry></collision>";
  const RobotModel robot = parse_urdf(text.text(), urdf());
  ASSERT_EQ(robot.substitutions.size(), 2U);
  EXPECT_EQ(robot.substitutions[0].what, "shape of the body");
  EXPECT_EQ(robot.substitutions[1].element, "mesh ../meshes/tibia.stl");
}

}  // namespace
}  // namespace hexagait

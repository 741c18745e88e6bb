// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/model/kinematics.hpp>
#include <hexagait/viewer/display/scene.hpp>
#include <hexagait/walk/trial.hpp>
#include <nlohmann/json.hpp>
#include <testing/argos_walk.hpp>

namespace hexagait::viewer {
namespace {

using nlohmann::json;
using testing::argos;

Vector3 vector(const json& v) {
  return {v[0].get<double>(), v[1].get<double>(), v[2].get<double>()};
}

json scene_of(const RobotModel& robot) {
  const sim3d::Terrain terrain(sim3d::parse_terrain("boxes:0.1"), 1);
  return json::parse(
      scene_json(robot, terrain, 1, 0.002, 7, {.robots = {"argos", "other"}, .paths = {"square"}}));
}

// What a page does: rotations about the joints' axes, one after the other, move the foot from where
// it is with all joints at zero.
TEST(Scene, TellsAllThatThePositionOfAFootNeeds) {
  const RobotModel robot = argos();
  const json scene = scene_of(robot);
  const LegArray<LegJoints> q = walk::random_posture(robot, 0.1, 3);
  for (LegId i = 0; i < robot.num_legs(); ++i) {
    const json& leg = scene["legs"][static_cast<std::size_t>(i)];
    Pose X;
    for (std::size_t k = 0; k < leg["joints"].size(); ++k) {
      const json& joint = leg["joints"][k];
      const double angle = q[i][static_cast<Eigen::Index>(k)];
      X = X * rotation_about(vector(joint["point"]), rotation(angle * vector(joint["axis"])));
    }
    EXPECT_TRUE((X * vector(leg["foot"])).isApprox(foot_position(robot.legs[i], q[i]), 1e-9));
  }
}

TEST(Scene, HasEveryShapeOfEveryLink) {
  const RobotModel robot = argos();
  const json scene = scene_of(robot);
  EXPECT_EQ(scene["type"], "scene");
  EXPECT_EQ(scene["scene"], 7);
  EXPECT_EQ(scene["robots"], json({"argos", "other"}));
  EXPECT_EQ(scene["base"]["shapes"].size(), robot.base.shapes.size());
  EXPECT_EQ(scene["base"]["shapes"][0]["kind"], "box");
  EXPECT_EQ(vector(scene["base"]["shapes"][0]["size"]), robot.base.shapes[0].size);
  const json& shin = scene["legs"][5]["joints"][2]["link"];
  EXPECT_EQ(shin["shapes"].size(), robot.legs[5].links[2].shapes.size());
}

// A kind that is added to the library is on the page without further ado.
TEST(Scene, ListsAllFaultsAndPlantsOfTheLibrary) {
  const json scene = scene_of(argos());
  ASSERT_EQ(scene["faults"].size(), walk::part_fault_kinds().size());
  for (std::size_t k = 0; k < scene["faults"].size(); ++k)
    EXPECT_EQ(scene["faults"][k]["syntax"], walk::part_fault_kinds()[k].syntax);
  ASSERT_EQ(scene["plants"].size(), recording::plant_presets().size());
  EXPECT_EQ(scene["plants"][1]["name"], recording::plant_presets()[1].name);
  EXPECT_EQ(scene["legs"][0]["joints"][2]["name"], "LF_knee");
}

TEST(Scene, SetupTellsPlantAndFaults) {
  recording::PlantSetup plant = recording::parse_plant("real");
  recording::add_faults(plant, std::vector<std::string>{"cut:LF"});
  const json setup = json::parse(setup_json({plant}, 4));
  EXPECT_EQ(setup["type"], "setup");
  EXPECT_EQ(setup["scene"], 4);
  EXPECT_EQ(setup["faults"], json({"cut:LF"}));
  EXPECT_TRUE(setup["path"].is_null());
  EXPECT_TRUE(setup["race"].is_null());
  const auto tripod = gait_state::parse_gait_choice("tripod");
  EXPECT_EQ(json::parse(setup_json({plant, nullptr, tripod}, 4))["race"], "tripod");
  EXPECT_TRUE(setup["estop"].is_null());
  EXPECT_EQ(json::parse(setup_json({.plant = plant, .stopped_by = 3}, 4))["estop"], 3);
}

TEST(Scene, GroundHasTheLevelsOfTheTerrainByRows) {
  const sim3d::Terrain terrain(sim3d::parse_terrain("steps:0.1"), 1);
  const GroundPatch patch = GroundPatch::around(terrain, {30.0, -12.0});
  const json ground = json::parse(ground_json(terrain, patch, 2));
  EXPECT_EQ(ground["i0"], 100 - GroundPatch::kCells / 2);
  EXPECT_EQ(ground["j0"], -40 - GroundPatch::kCells / 2);
  EXPECT_FALSE(ground["smooth"]);
  ASSERT_EQ(ground["x"].size(), GroundPatch::kCells + 1);
  EXPECT_NEAR(ground["x"][3].get<double>(), 0.3 * (patch.i0 + 3), 1e-5);
  EXPECT_NEAR(ground["y"][5].get<double>(), 0.3 * (patch.j0 + 5), 1e-5);
  EXPECT_NEAR(ground["ramp"].get<double>(), terrain.sample_spacing(), 1e-12);
  ASSERT_EQ(ground["levels"].size(), GroundPatch::kCells * GroundPatch::kCells);
  EXPECT_NEAR(ground["levels"][3 * GroundPatch::kCells + 5].get<double>(),
              terrain.height_at(0.3 * (patch.i0 + 3.5), 0.3 * (patch.j0 + 5.5)), 1e-5);
}

TEST(Scene, GroundOfUnlikeCellsHasTheirEdges) {
  const sim3d::Terrain terrain(sim3d::parse_terrain("stones:25cm,8cm"), 1);
  const GroundPatch patch = GroundPatch::around(terrain, {0.1, 0.1});
  const json ground = json::parse(ground_json(terrain, patch, 2));
  const auto at = static_cast<std::size_t>(-patch.i0);
  EXPECT_NEAR(ground["x"][at].get<double>(), 0.0, 1e-9);
  EXPECT_NEAR(ground["x"][at + 1].get<double>(), 0.25, 1e-9);
  EXPECT_NEAR(ground["x"][at + 2].get<double>(), 0.33, 1e-9);
}

TEST(Scene, SmoothGroundHasTheHeightsOfItsPoints) {
  const sim3d::Terrain terrain(sim3d::parse_terrain("slope:10deg,30deg+boxes:0.1"), 1);
  const json ground =
      json::parse(ground_json(terrain, GroundPatch::around(terrain, {4.0, 1.0}), 2));
  EXPECT_TRUE(ground["smooth"]);
  const std::size_t rows = ground["x"].size(), columns = ground["y"].size();
  ASSERT_EQ(ground["levels"].size(), rows * columns);
  for (const auto& [i, j] : {std::pair<std::size_t, std::size_t>{3, 77}, {150, 9}})
    EXPECT_NEAR(ground["levels"][i * columns + j].get<double>(),
                terrain.height_at(ground["x"][i].get<double>(), ground["y"][j].get<double>()),
                1e-5);
}

TEST(Scene, PatchIsLeftFarFromItsMiddleOnly) {
  const sim3d::Terrain terrain(sim3d::parse_terrain("flat"), 1);
  const GroundPatch patch = GroundPatch::around(terrain, {0.0, 0.0});
  EXPECT_FALSE(patch.is_left_by(terrain, {2.0, -2.0}));
  EXPECT_TRUE(patch.is_left_by(terrain, {3.0, 0.0}));
}

// A name of the robot may be any bytes; the text is UTF-8 all the same.
TEST(Scene, AnErrorIsAlwaysUtf8) {
  EXPECT_EQ(json::parse(error_json("no \xC3"))["type"], "error");
  EXPECT_EQ(json::parse(hello_json(7))["you"], 7);
}

}  // namespace
}  // namespace hexagait::viewer

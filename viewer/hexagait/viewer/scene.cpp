// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <hexagait/viewer/scene.hpp>
#include <nlohmann/json.hpp>

namespace hexagait::viewer {
namespace {

using Json = nlohmann::ordered_json;

// Whatever bytes a name has, the text is UTF-8.
std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// Rounded to a hundredth of a millimetre.
double rounded(double metres) { return std::round(metres * 1e5) / 1e5; }

Json json(const Vector3& v) { return {v.x(), v.y(), v.z()}; }

Json json(const Pose& X) {
  const Eigen::Quaterniond q(X.R);
  return {{"p", json(X.p)}, {"q", {q.x(), q.y(), q.z(), q.w()}}};
}

Json json(const Shape& shape) {
  constexpr const char* kKinds[] = {"box", "cylinder", "sphere"};
  return {{"kind", kKinds[static_cast<int>(shape.kind)]},
          {"size", json(shape.size)},
          {"pose", json(shape.X_LS)}};
}

Json json(const LinkModel& link) {
  Json shapes = Json::array();
  for (const Shape& shape : link.shapes) shapes.push_back(json(shape));
  return {{"name", link.name}, {"pose", json(link.X_BL0)}, {"shapes", shapes}};
}

Json json(const LegModel& leg) {
  Json joints = Json::array();
  for (int k = 0; k < leg.num_joints(); ++k)
    joints.push_back({{"axis", json(leg.axis_B0[k])},
                      {"point", json(leg.p_BJ0[k])},
                      {"link", json(leg.links[k])}});
  return {{"name", short_leg_name(leg.name)}, {"centre", json(leg.p_BC)},
          {"radius", leg.workspace_radius},   {"hip", json(leg.X_BH.p)},
          {"foot", json(leg.p_BF0)},          {"joints", joints}};
}

Json terrains() {
  Json list = Json::array();
  for (const sim3d::TerrainDescription& known : sim3d::known_terrains())
    list.push_back({{"syntax", known.syntax}, {"meaning", known.meaning}});
  return list;
}

}  // namespace

GroundPatch GroundPatch::around(const sim3d::Terrain& terrain, const Vector2& p_W) {
  return {terrain.cell_index(p_W.x()) - kCells / 2, terrain.cell_index(p_W.y()) - kCells / 2};
}

bool GroundPatch::is_left_by(const sim3d::Terrain& terrain, const Vector2& p_W) const {
  const GroundPatch there = around(terrain, p_W);
  return std::abs(there.i0 - i0) > kCells / 6 || std::abs(there.j0 - j0) > kCells / 6;
}

std::string scene_json(const RobotModel& robot, const sim3d::Terrain& terrain, std::uint64_t seed,
                       double control_dt, std::uint32_t number,
                       const std::vector<std::string>& robots) {
  Json legs = Json::array();
  for (const LegModel& leg : robot.legs) legs.push_back(json(leg));
  const Json scene = {{"type", "scene"},
                      {"scene", number},
                      {"robot", robot.name},
                      {"mass", robot.mass},
                      {"terrain", sim3d::to_string(terrain.spec())},
                      {"seed", seed},
                      {"control_dt", control_dt},
                      {"foot_radius", robot.foot_radius},
                      {"base", json(robot.base)},
                      {"legs", legs},
                      {"robots", robots},
                      {"terrains", terrains()}};
  return text_of(scene);
}

std::string ground_json(const sim3d::Terrain& terrain, const GroundPatch& patch,
                        std::uint32_t scene) {
  Json levels = Json::array();
  for (int i = 0; i < GroundPatch::kCells; ++i)
    for (int j = 0; j < GroundPatch::kCells; ++j)
      levels.push_back(rounded(terrain.level(patch.i0 + i, patch.j0 + j)));
  const bool ramps = terrain.spec().kind == sim3d::TerrainSpec::Kind::steps;
  const Json ground = {{"type", "ground"},
                       {"scene", scene},
                       {"i0", patch.i0},
                       {"j0", patch.j0},
                       {"cells", GroundPatch::kCells},
                       {"cell", terrain.spec().cell},
                       {"ramp", ramps ? terrain.sample_spacing() : 0.0},
                       {"highest", terrain.spec().height},
                       {"levels", levels}};
  return text_of(ground);
}

std::string hello_json(std::uint32_t client) {
  return text_of({{"type", "hello"}, {"you", client}});
}

std::string error_json(const std::string& what) {
  return text_of({{"type", "error"}, {"what", what}});
}

}  // namespace hexagait::viewer

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <hexagait/viewer/display/scene.hpp>
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
    joints.push_back({{"name", leg.joint_names[k]},
                      {"axis", json(leg.axis_B0[k])},
                      {"point", json(leg.p_BJ0[k])},
                      {"link", json(leg.links[k])}});
  return {{"name", short_leg_name(leg.name)}, {"centre", json(leg.p_BC)},
          {"radius", leg.workspace_radius},   {"hip", json(leg.X_BH.p)},
          {"foot", json(leg.p_BF0)},          {"joints", joints}};
}

std::vector<double> edges(const sim3d::CellAxis& axis, int first) {
  std::vector<double> all;
  for (int i = first; i <= first + GroundPatch::kCells; ++i) all.push_back(rounded(axis.edge(i)));
  return all;
}

// Has the ground more than level cells, with or without ramps between them?
bool is_smooth(const sim3d::Terrain& terrain) {
  const auto& parts = terrain.spec().parts;
  const bool steps = parts.size() == 1 && parts[0].kind == sim3d::TerrainKind::steps;
  return terrain.surface() == sim3d::Terrain::Surface::samples && !steps;
}

// Four points to a cell.
std::vector<double> divided(const std::vector<double>& edges) {
  constexpr int kParts = 4;
  std::vector<double> all;
  for (std::size_t i = 0; i + 1 < edges.size(); ++i)
    for (int k = 0; k < kParts; ++k)
      all.push_back(rounded(edges[i] + k * (edges[i + 1] - edges[i]) / kParts));
  return all;
}

void add_points(const sim3d::Terrain& terrain, const std::vector<double>& x,
                const std::vector<double>& y, Json& ground) {
  Json levels = Json::array();
  for (const double of_x : x)
    for (const double of_y : y) levels.push_back(rounded(terrain.height_at(of_x, of_y)));
  ground.update({{"smooth", true}, {"x", x}, {"y", y}, {"levels", levels}});
}

Json terrains() {
  Json list = Json::array();
  for (const sim3d::TerrainDescription& known : sim3d::known_terrains())
    if (!known.reads_file)  // a page names no files
      list.push_back(
          {{"syntax", known.syntax},
           {"meaning", known.meaning},
           {"example", known.example},
           {"height", sim3d::parse_terrain(std::string(known.example)).roughness() > 0.0}});
  return list;
}

Json faults(const RobotModel& robot) {
  Json list = Json::array();
  for (const walk::PartFaultWords& kind : walk::part_fault_kinds())
    list.push_back({{"syntax", kind.syntax},
                    {"meaning", kind.meaning},
                    {"values", walk::example_values(kind.kind, robot)}});
  return list;
}

Json plants() {
  Json list = Json::array();
  for (const recording::PlantPreset& preset : recording::plant_presets())
    list.push_back({{"name", preset.name}, {"meaning", preset.meaning}});
  return list;
}

}  // namespace

GroundPatch GroundPatch::around(const sim3d::Terrain& terrain, const Vector2& p_W) {
  return {terrain.x_axis().index(p_W.x()) - kCells / 2,
          terrain.y_axis().index(p_W.y()) - kCells / 2};
}

bool GroundPatch::is_left_by(const sim3d::Terrain& terrain, const Vector2& p_W) const {
  const GroundPatch there = around(terrain, p_W);
  return std::abs(there.i0 - i0) > kCells / 6 || std::abs(there.j0 - j0) > kCells / 6;
}

std::string scene_json(const RobotModel& robot, const sim3d::Terrain& terrain, std::uint64_t seed,
                       double control_dt, std::uint32_t number, const SceneChoices& choices) {
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
                      {"robots", choices.robots},
                      {"paths", choices.paths},
                      {"actions", choices.actions},
                      {"live", choices.live},
                      {"terrains", choices.live ? Json::array() : terrains()},
                      {"faults", choices.live ? Json::array() : faults(robot)},
                      {"plants", choices.live ? Json::array() : plants()}};
  return text_of(scene);
}

std::string ground_json(const sim3d::Terrain& terrain, const GroundPatch& patch,
                        std::uint32_t scene) {
  Json ground = {{"type", "ground"}, {"scene", scene}};
  const std::vector<double> x = edges(terrain.x_axis(), patch.i0);
  const std::vector<double> y = edges(terrain.y_axis(), patch.j0);
  if (is_smooth(terrain)) {
    add_points(terrain, divided(x), divided(y), ground);
    return text_of(ground);
  }
  Json levels = Json::array();
  for (int i = patch.i0; i < patch.i0 + GroundPatch::kCells; ++i)
    for (int j = patch.j0; j < patch.j0 + GroundPatch::kCells; ++j)
      levels.push_back(
          rounded(terrain.height_at(terrain.x_axis().middle(i), terrain.y_axis().middle(j))));
  const bool ramps = terrain.surface() == sim3d::Terrain::Surface::samples;
  ground.update({{"smooth", false},
                 {"i0", patch.i0},
                 {"j0", patch.j0},
                 {"x", x},
                 {"y", y},
                 {"ramp", ramps ? terrain.sample_spacing() : 0.0},
                 {"levels", levels}});
  return text_of(ground);
}

std::string setup_json(const SceneSetup& setup, std::uint32_t scene) {
  Json faults = Json::array();
  for (const walk::PartFault& fault : setup.plant.parts) faults.push_back(fault.text);
  Json way;
  if (setup.path != nullptr) {
    Json points = Json::array();
    for (const Vector2& p : setup.path->picture())
      points.push_back({rounded(p.x()), rounded(p.y())});
    way = {{"points", points}, {"closed", setup.path->closed()}};
  }
  return text_of({{"type", "setup"},
                  {"scene", scene},
                  {"plant", setup.plant.name},
                  {"faults", faults},
                  {"path", way},
                  {"race", setup.race ? Json(to_string(*setup.race)) : Json()},
                  {"estop", setup.stopped_by ? Json(*setup.stopped_by) : Json()}});
}

std::string action_json(const ActionNews& news) {
  constexpr const char* kStates[] = {"none", "checking", "refused", "running",
                                     "done", "stopped",  "failed"};
  Json findings = Json::array();
  for (const ActionFinding& f : news.findings)
    findings.push_back({{"line", f.line},
                        {"column", f.column},
                        {"error", f.is_error},
                        {"text", f.text},
                        {"source", f.source}});
  return text_of({{"type", "action"},
                  {"name", news.name},
                  {"state", kStates[static_cast<int>(news.state)]},
                  {"step", news.step},
                  {"steps", news.steps},
                  {"why", news.why},
                  {"findings", findings}});
}

std::string hello_json(std::uint32_t client) {
  return text_of({{"type", "hello"}, {"you", client}});
}

std::string error_json(const std::string& what) {
  return text_of({{"type", "error"}, {"what", what}});
}

}  // namespace hexagait::viewer

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <hexagait/path_following/path_faults.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/nearest_word.hpp>
#include <hexagait/text/text_file.hpp>
#include <hexagait/walk/paths/path_file.hpp>
#include <hexagait/walk/schedule.hpp>
#include <hexagait/yaml/yaml_reader.hpp>

namespace hexagait::walk {
namespace {

using path_following::Facing;
using path_following::FacingRule;
using path_following::PathTask;
using path_following::Shape;
using path_following::Waypoint;

constexpr std::string_view kPathKeys[] = {"points", "closed", "shape", "unit", "facing", "speed"};
constexpr YamlKeys kPathMap = {"path", kPathKeys};
constexpr std::string_view kPointKeys[] = {"x", "y", "facing", "speed"};
constexpr YamlKeys kPointMap = {"point", kPointKeys};
constexpr NumberRule kLength = {NumberRule::Bound::any, Dimension::length, 1e5};
constexpr NumberRule kAngle = {NumberRule::Bound::any, Dimension::angle};
constexpr NumberRule kSpeed = {NumberRule::Bound::positive, Dimension::number, 1e3};
constexpr std::size_t kMostPoints = 20'000;
const std::vector<std::string> kShapes = {"lines", "spline"};
const std::vector<std::string> kUnits = {"metres", "size"};
const std::vector<std::string> kFacings = {"along", "keep", "car", "points"};

/// The points of a file, and where each is written.
struct Points {
  std::vector<Waypoint> waypoints;
  std::vector<Mark> marks;
};

// [x, y] or {x: …, y: …, facing: …, speed: …}; of a place that is not right, nothing.
std::optional<Waypoint> read_point(YamlReader& yaml, const YamlField& item, double unit) {
  Waypoint point;
  if (yaml.node(item.node).is_list()) {
    constexpr std::size_t kTwo[] = {2};
    const auto xy = yaml.numbers(item, kTwo, kLength);
    if (!xy) return {};
    point.p_P = unit * Vector2((*xy)[0], (*xy)[1]);
    return point;
  }
  if (!yaml.node(item.node).is_map()) {
    yaml.refuse(item, "a point, such as [1.5, 0] or {x: 1.5, y: 0, facing: 90deg}");
    return {};
  }
  const YamlFields fields = yaml.fields(item, kPointMap);
  const auto x = yaml.require(fields, "x"), y = yaml.require(fields, "y");
  const auto at_x = x ? yaml.number(*x, kLength) : std::nullopt;
  const auto at_y = y ? yaml.number(*y, kLength) : std::nullopt;
  if (const auto facing = yaml.find(fields, "facing")) point.facing = yaml.number(*facing, kAngle);
  point.speed = yaml.number_or(fields, "speed", point.speed, kSpeed);
  if (!at_x || !at_y) return {};
  point.p_P = unit * Vector2(*at_x, *at_y);
  return point;
}

Points read_points(YamlReader& yaml, const YamlFields& fields, double unit) {
  Points points;
  const auto field = yaml.require(fields, "points");
  if (!field) return points;
  const std::vector<YamlField> items = yaml.list(*field);
  if (items.size() > kMostPoints)
    yaml.stop(field->mark, fmt::format("points: has {} of them; at most {} are read", items.size(),
                                       kMostPoints));
  for (const YamlField& item : items) {
    const std::optional<Waypoint> point = read_point(yaml, item, unit);
    if (!point) continue;
    points.waypoints.push_back(*point);
    points.marks.push_back(item.mark);
  }
  return points;
}

template <class Value>
Value chosen(YamlReader& yaml, const YamlFields& fields, std::string_view key,
             const std::vector<std::string>& words, std::initializer_list<Value> values) {
  const auto field = yaml.find(fields, key);
  const auto index = field ? yaml.word(*field, words) : std::nullopt;
  return *(values.begin() + index.value_or(0));
}

FacingRule read_facing(YamlReader& yaml, const YamlFields& fields, FacingRule otherwise) {
  const auto field = yaml.find(fields, "facing");
  const auto text = field ? yaml.text(*field) : std::nullopt;
  if (!text) return otherwise;
  try {
    return parse_facing(*text);
  } catch (const InvalidInput& error) {
    yaml.refuse(field->mark, fmt::format("facing: {}", error.what()));
    return otherwise;
  }
}

// Where a robot faces if nobody says otherwise.
FacingRule usual_facing(const RobotModel& robot, bool points_face) {
  if (robot.legs[0].has_two_joints()) return {Facing::car, 0.0};
  return {points_face ? Facing::points : Facing::along, 0.0};
}

}  // namespace

FacingRule parse_facing(const std::string& text) {
  if (text == "along") return {Facing::along, 0.0};
  if (text == "keep") return {Facing::fixed, 0.0};
  if (text == "car") return {Facing::car, 0.0};
  if (text == "points") return {Facing::points, 0.0};
  const auto [angle, problem] = parse_quantity(text, Dimension::angle);
  if (problem.empty()) return {Facing::fixed, angle};
  throw InvalidInput(fmt::format(
      "'{}' is no way to face{}; it must be along, keep, car, points or an angle such as "
      "45deg",
      text, did_you_mean(text, kFacings)));
}

std::string to_string(const FacingRule& facing) {
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  switch (facing.kind) {
    case Facing::along:
      return facing.angle == 0.0 ? "along" : fmt::format("along {:+.4g}°", kDegrees * facing.angle);
    case Facing::fixed:
      return facing.angle == 0.0 ? "keep" : fmt::format("{:.4g}°", kDegrees * facing.angle);
    case Facing::points:
      return "points";
    case Facing::car:
      return "car";
  }
  return "";
}

PathTask task_of(path_following::Path path, const RobotModel& robot, const StepParams& step) {
  const FacingRule facing = usual_facing(robot, path.has_facing());
  return {std::move(path), facing, 1, path_following::look_ahead_for(step)};
}

PathTask load_path(const std::string& file, const RobotModel& robot, const StepParams& step) {
  return parse_path(read_text(file, kMaxYamlText, "a YAML file of a path"), file, robot, step);
}

PathTask parse_path(const std::string& text, const std::string& file, const RobotModel& robot,
                    const StepParams& step) {
  Violations violations(file);
  const YamlTree tree = parse_yaml(text, file, violations);
  YamlReader yaml(tree, violations);
  const YamlNode& root = yaml.node(0);
  if (!root.is_map())
    yaml.stop(root.mark,
              fmt::format("is {}; it must be a map with points, such as points: [[0, 0], "
                          "[2, 0], [2, 1]]",
                          in_words(root)));
  const YamlFields fields = yaml.fields({"path", 0, root.mark}, kPathMap);
  const bool closed = yaml.flag_or(fields, "closed", false);
  const Shape shape = chosen(yaml, fields, "shape", kShapes, {Shape::lines, Shape::spline});
  const double unit = chosen(yaml, fields, "unit", kUnits, {1.0, scale_of(robot).size});
  const double speed = yaml.number_or(fields, "speed", Waypoint{}.speed, kSpeed);
  Points points = read_points(yaml, fields, unit);

  const auto has_facing = [](const Waypoint& point) { return point.facing.has_value(); };
  const bool faces = std::ranges::any_of(points.waypoints, has_facing);
  const FacingRule facing = read_facing(yaml, fields, usual_facing(robot, faces));
  // What is wrong already says more than what follows from it.
  violations.throw_if_any();

  if (!points.waypoints.empty())
    points.waypoints[0].speed = std::min(points.waypoints[0].speed, speed);
  for (const path_following::PathFault& fault :
       faults_of(points.waypoints, shape, closed, step.stroke))
    yaml.refuse(points.marks.empty() ? root.mark : points.marks[fault.waypoint], fault.problem);
  violations.throw_if_any();
  PathTask task = task_of({points.waypoints, shape, closed}, robot, step);
  task.facing = facing;
  return task;
}

}  // namespace hexagait::walk

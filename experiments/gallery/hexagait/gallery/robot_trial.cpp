// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <hexagait/gallery/robot_trial.hpp>
#include <hexagait/params/best_stance.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <nlohmann/json.hpp>
#include <numbers>

namespace hexagait::experiments {
namespace {

using heading_control::Heading;
using heading_control::Turn;

// Of ℓ/T: a fifth of what six legs walk at, half of what four crawl at.
constexpr double kLeastPace = 0.06, kLeastCrawl = 0.03;

using Json = nlohmann::json;

Json json(const WalkEnd& end) {
  return {end.outcome, end.seconds, end.way, end.off_path, end.hindrance};
}

WalkEnd end_from(const Json& json) {
  return {json.at(0), json.at(1), json.at(2), json.at(3), json.at(4)};
}

}  // namespace

RobotHeading straight_on(const RobotScale& scale) {
  return {"straight", Heading::straight(0.0), 5.0 * scale.size};
}

RobotHeading along_an_arc(const RobotScale& scale) {
  const double radius = 2.0 * scale.size;
  return {"arc", Heading::arc(radius, 0.0), 0.5 * std::numbers::pi * radius};
}

RobotHeading in_place() { return {"spin", Heading::spin(Turn::cw), 0.0, 0.5 * std::numbers::pi}; }

RobotHeading sideways(const RobotScale& scale) {
  return {"crab 45°", Heading::straight(0.25 * std::numbers::pi), 3.0 * scale.size};
}

recording::Simulation walk_of(const RobotHeading& heading, const RobotScale& scale) {
  const double pace = scale.reach / scale.time * (scale.legs == 4 ? kLeastCrawl : kLeastPace);
  recording::Simulation simulation;
  simulation.trial.schedule = {{0.0, heading.heading}};
  simulation.trial.seconds = std::max(heading.distance, heading.turn * scale.outer) / pace;
  if (heading.distance > 0.0)
    simulation.trial.distance = heading.distance;
  else
    simulation.trial.turn = heading.turn;
  return simulation;
}

WalkEnd end_of(const walk::Summary& s, const RobotHeading& heading, const RobotModel& robot) {
  WalkEnd end{.outcome = s.fell                                 ? "fell"
                         : s.fault != footstep_gen::Fault::none ? "fault"
                         : s.stuck                              ? "stuck"
                         : s.arrived                            ? "walked"
                                                                : "too slow",
              .seconds = s.seconds};
  end.way = heading.distance > 0.0 ? s.distance : std::abs(s.turned) * scale_of(robot).outer;
  end.off_path = end.way > 0.0 ? s.lateral_mean / end.way : 0.0;
  if (s.stuck) end.hindrance = in_words(s.hindrance, robot);
  return end;
}

bool RobotTrial::fell() const {
  return std::ranges::any_of(walks, [](const WalkEnd& walk) { return walk.outcome == "fell"; });
}

bool RobotTrial::walks_all() const {
  return !walks.empty() && std::ranges::all_of(walks, &WalkEnd::walked);
}

double RobotTrial::off_path() const {
  double most = 0.0;
  for (const WalkEnd& walk : walks) most = std::max(most, walk.off_path);
  return most;
}

RobotTrial try_robot(const RandomRobot& random, const std::atomic<bool>* stop) {
  RobotTrial trial{.seed = random.seed,
                   .legs = random.legs,
                   .layout = to_string(random.layout) + std::string(random.round ? ", round" : ""),
                   .cannot_stand = {},
                   .walks = {}};
  try {
    const RobotModel robot = parse_urdf(random.urdf, fmt::format("random{}", random.seed));
    const RobotScale scale = scale_of(robot);
    trial.size = scale.size;
    trial.mass = robot.mass;
    trial.pace = scale.reach / scale.time;
    trial.cannot_stand = why_it_cannot_walk(robot);
    if (!trial.stands()) return trial;
    for (const RobotHeading& heading : {straight_on(scale), along_an_arc(scale), in_place()})
      trial.walks.push_back(
          end_of(recording::simulate(robot, walk_of(heading, scale), {}, stop), heading, robot));
  } catch (const InvalidInput& error) {
    trial.cannot_stand = error.what();
    std::ranges::replace(trial.cannot_stand, '\n', ' ');
  }
  return trial;
}

std::string to_line(const WalkEnd& end) { return json(end).dump(); }

WalkEnd parse_end(const std::string& line) { return end_from(Json::parse(line)); }

std::string to_line(const RobotTrial& trial) {
  Json walks = Json::array();
  for (const WalkEnd& end : trial.walks) walks.push_back(json(end));
  return Json{trial.seed, trial.legs, trial.layout,       trial.size,
              trial.mass, trial.pace, trial.cannot_stand, walks}
      .dump();
}

RobotTrial parse_trial(const std::string& line) {
  const Json row = Json::parse(line);
  RobotTrial trial{row.at(0), row.at(1), row.at(2), row.at(3), row.at(4), row.at(5), row.at(6), {}};
  for (const Json& walk : row.at(7)) trial.walks.push_back(end_from(walk));
  return trial;
}

}  // namespace hexagait::experiments

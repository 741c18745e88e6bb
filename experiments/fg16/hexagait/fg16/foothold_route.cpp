// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/fg16/foothold_route.hpp>

namespace hexagait::experiments {
namespace {

// Legs are numbered from the front, the left one of each pair first.
constexpr std::array<std::array<LegId, 2>, 3> kPairs = {{{0, 5}, {2, 1}, {4, 3}}};

constexpr double kHeight = 0.32;         // of the base above the feet, for room over a step [m]
constexpr double kClearance = 0.08;      // of a foot on its way [m]
constexpr double kStepClearance = 0.06;  // above the higher level [m]

// Where the level changes between two places, by bisection [m].
double edge_between(double a, double b, double y, const sim3d::Terrain& terrain) {
  const double level = terrain.height_at(a, y);
  for (int k = 0; k < 40; ++k) {
    const double middle = 0.5 * (a + b);
    (terrain.height_at(middle, y) == level ? a : b) = middle;
  }
  return a;
}

// Away from a change of level, to the side on which it is.
double off_edges(double x, double y, double gap, const sim3d::Terrain& terrain) {
  const double here = terrain.height_at(x, y);
  constexpr int kProbes = 50;
  for (int k = 1; k <= kProbes; ++k)
    for (const double way : {gap * k / kProbes, -gap * k / kProbes})
      if (terrain.height_at(x + way, y) != here)
        return edge_between(x, x + way, y, terrain) - std::copysign(gap, way);
  return x;
}

action::BaseCommand base_auto(std::optional<double> height = {}) {
  action::BaseAuto command;
  command.height = height;
  return {command, {}};
}

action::LegCommand footstep(const Foothold& foothold) {
  action::Footstep step;
  step.leg = foothold.leg;
  step.target = {kMap, foothold.p_MF};
  step.profile = foothold.from_another_level ? SwingProfile::square : SwingProfile::triangle;
  step.profile_height = foothold.from_another_level ? kStepClearance : kClearance;
  return {step, {}};
}

}  // namespace

std::vector<std::array<Foothold, 2>> footholds_along(const Route& route, const RobotModel& robot,
                                                     const sim3d::Terrain& terrain) {
  LegArray<double> level(robot.num_legs(), terrain.height_at(route.start, 0.0));
  const auto foothold = [&](LegId leg, double base) {
    const Vector3& p_BC = robot.legs[leg].p_BC;
    const double x = off_edges(base + p_BC.x(), p_BC.y(), route.edge_gap, terrain);
    const double z = terrain.height_at(x, p_BC.y());
    const bool changes = z != level[leg];
    level[leg] = z;
    return Foothold{leg, {x, p_BC.y(), z + robot.foot_radius}, changes};
  };

  // The base gets on by a third of a stride with each pair; in the end all feet are square.
  std::vector<std::array<Foothold, 2>> footholds;
  const double advance = route.stride / 3.0;
  const auto pairs = std::lround(std::ceil((route.end - route.start + route.stride) / advance));
  for (long k = 0; k < pairs; ++k) {
    const double base = route.start + advance * static_cast<double>(k) + 0.5 * route.stride;
    const auto& [first, second] = kPairs[static_cast<std::size_t>(k) % kPairs.size()];
    const double to = std::min(base, route.end);
    footholds.push_back({foothold(first, to), foothold(second, to)});
  }
  return footholds;
}

action::Action walk_on(const std::vector<std::array<Foothold, 2>>& footholds,
                       const std::string& id) {
  action::Action action;
  action.id = id;
  action.steps.resize(2 * footholds.size() + 2);
  for (action::Step& step : action.steps) step.base = base_auto();
  action.steps.front().base = base_auto(kHeight);
  for (std::size_t k = 0; k < footholds.size(); ++k)
    for (const Foothold& foothold : footholds[k])
      action.steps[2 * k + 2].legs.push_back(footstep(foothold));
  return action;
}

}  // namespace hexagait::experiments

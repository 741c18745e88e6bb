// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <hexagait/action/action.hpp>
#include <hexagait/model/robot_model.hpp>
#include <hexagait/sim3d/terrain.hpp>
#include <vector>

namespace hexagait::experiments {

/// The ground of both figures.
inline constexpr const char* kTerrain = "step:0.12";

/// Where terrain "step:H" goes up: the front end of its start pad [m].
inline constexpr double kStepBegins = 0.6;

/// A place for a foot.
struct Foothold {
  LegId leg = 0;
  Vector3 p_MF = Vector3::Zero();   ///< foot's centre in the map [m]
  bool from_another_level = false;  ///< than that of the leg's foothold before
};

/// A way straight on, along x of the map: where it begins and ends, and how the feet get on.
struct Route {
  double start = 0.0;      ///< x of the base [m]
  double end = 1.2;        ///< [m]
  double stride = 0.24;    ///< from one foothold of a leg to its next [m]
  double edge_gap = 0.05;  ///< a foothold is not nearer than this to a change of level [m]
};

/// A list of footholds that takes a robot of six legs along a route, two at a time, as an operator
/// or a footstep planner would give it: pairs (LF, RR), (LM, RF), (LR, RM) in turn, each foot half
/// a stride ahead of its place under the base, so that four feet always stand and the centre of
/// mass stays well within them. Footholds near a change of level are moved away from it.
/// @param terrain  whose heights are known, as to somebody with a map
[[nodiscard]] std::vector<std::array<Foothold, 2>> footholds_along(const Route& route,
                                                                   const RobotModel& robot,
                                                                   const sim3d::Terrain& terrain);

/// The action that goes to these footholds: before each pair the base makes ready (BaseAuto), then
/// it moves along with two Footsteps ([FG16] IV-B). A foot that changes level swings on a square.
[[nodiscard]] action::Action walk_on(const std::vector<std::array<Foothold, 2>>& footholds,
                                     const std::string& id);

}  // namespace hexagait::experiments

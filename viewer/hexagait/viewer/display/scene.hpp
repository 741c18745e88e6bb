// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/gait_state/gait_choice.hpp>
#include <hexagait/math/planar.hpp>
#include <hexagait/model/robot_model.hpp>
#include <hexagait/recording/plant_setup.hpp>
#include <hexagait/sim3d/terrain.hpp>
#include <hexagait/viewer/tasks/checked_action.hpp>
#include <hexagait/viewer/tasks/followed_path.hpp>
#include <hexagait/viewer/tasks/performance.hpp>
#include <optional>
#include <string>
#include <vector>

/// What a page draws that does not change from frame to frame, as JSON text.
namespace hexagait::viewer {

/// The cells of the ground around a place: a square of them.
struct GroundPatch {
  static constexpr int kCells = 52;  ///< along an edge
  int i0 = 0, j0 = 0;                ///< its first cell, in both axes

  /// The patch with this place in its middle [m].
  [[nodiscard]] static GroundPatch around(const sim3d::Terrain& terrain, const Vector2& p_W);

  /// Is the place so far from the middle that a new patch is due?
  [[nodiscard]] bool is_left_by(const sim3d::Terrain& terrain, const Vector2& p_W) const;
};

/// Names of what comes along, from which a page may choose.
struct SceneChoices {
  std::vector<std::string> robots = {}, paths = {}, actions = {};
  bool live = false;  ///< a live robot: nothing of a simulated one is to choose
};

/// {"type":"scene", …}: the robot's links with their shapes, joints and feet, from which a page
/// moves it by the joint angles of a PoseFrame alone; names of robots, paths, actions, terrains,
/// faults and plants to choose from.
/// @param number  that the frames of this scene carry
[[nodiscard]] std::string scene_json(const RobotModel& robot, const sim3d::Terrain& terrain,
                                     std::uint64_t seed, double control_dt, std::uint32_t number,
                                     const SceneChoices& choices);

/// {"type":"ground", …}: level cells between the edges x and y, row by row (x, then y), with walls or
/// ramps between them; or, if smooth, the heights at the points x, y [m].
[[nodiscard]] std::string ground_json(const sim3d::Terrain& terrain, const GroundPatch& patch,
                                      std::uint32_t scene);

/// What can change while a scene goes on.
struct SceneSetup {
  const recording::PlantSetup& plant;
  const FollowedPath* path = nullptr;               ///< null: none
  std::optional<gait_state::GaitChoice> race = {};  ///< gait of the second robot, if there is one
  std::optional<std::uint32_t> stopped_by = {};     ///< client, of an emergency stop that lasts
};

/// {"type":"setup","scene":3,"plant":"real","faults":["dead:LF"],"path":{"points":[[0,0],…],"closed":true},
/// "race":"tripod","estop":7}. Points are in the world [m]; without a path, a race, or an emergency stop, it
/// is null.
[[nodiscard]] std::string setup_json(const SceneSetup& setup, std::uint32_t scene);

/// An action that was asked for.
struct ActionNews {
  enum class State : std::uint8_t { none, checking, refused, running, done, stopped, failed };
  std::string name;
  State state = State::none;
  int step = 0, steps = 0;  ///< from 1; step 0 while running: the robot stops walking
  std::vector<ActionFinding> findings = {};
  std::string why = {};  ///< it was refused, was stopped or failed
};

/// {"type":"action","name":"wave","state":"running","step":2,"steps":7,"why":"","findings":[{"line":3,"column":17,
/// "error":true,"text":"unknown key …","source":"  - base_auto: {hieght: 0.2}"},…]}. The state is checking, refused,
/// running, done, stopped or failed; line 0 is of the whole action.
[[nodiscard]] std::string action_json(const ActionNews& news);

/// {"type":"hello","you":7}: the client's number, which frames name as the holder of the wheel.
[[nodiscard]] std::string hello_json(std::uint32_t client);

/// {"type":"error","what":"…"}.
[[nodiscard]] std::string error_json(const std::string& what);

}  // namespace hexagait::viewer

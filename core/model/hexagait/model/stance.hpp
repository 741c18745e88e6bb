// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/model/robot_model.hpp>
#include <optional>

namespace hexagait {

/// Where the feet stand when nothing moves them, and how far each may go from there. All stages of
/// the walking controller read it here, from Executor::stance(); it may change while the robot
/// walks: Walker::set_stance().
struct Stance {
  LegArray<Vector3> p_BC;   ///< workspace centres in the body frame [m]; at least two differ
  LegArray<double> radius;  ///< of the horizontal discs about them that the feet may use [m]
};

/// The stance of the robot's model.
[[nodiscard]] Stance nominal_stance(const RobotModel& robot) noexcept;

/// A stance described by what a user chooses. What is not given stays as it is in the model.
struct StanceRequest {
  std::optional<double> height = {};  ///< of the body frame's origin above the ground [m]
  double splay = 0.0;                 ///< by how much farther out from its hip each foot is [m]

  bool operator==(const StanceRequest&) const = default;
};

/// The requested stance, with the largest discs that the legs reach.
/// @throws InvalidInput  with every leg that can't stand so
[[nodiscard]] Stance stance_at(const RobotModel& robot, const StanceRequest& request);

/// The robot with this as its nominal stance: centre of mass and inertia are those of the stance.
/// @throws InvalidInput  with every leg whose foot can't be at its centre
[[nodiscard]] RobotModel in_stance(RobotModel robot, const Stance& stance);

/// Throws what in_stance() would, and changes nothing.
void check_stance(const RobotModel& robot, const Stance& stance);

/// Puts the workspace centre of a leg there; false, and nothing changes, if its foot can't be there. The
/// disc is that of the old place.
[[nodiscard]] bool put_foot(LegModel& leg, const Vector3& p_BC);

/// Sets centre of mass and inertia to those of the nominal stance.
/// @pre mass and nominal stance of the robot are set
void weigh(RobotModel& robot);

}  // namespace hexagait

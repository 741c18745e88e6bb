// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/walk/paths/path_pilot.hpp>
#include <hexagait/walk/referee/path_judge.hpp>
#include <span>
#include <vector>

namespace hexagait::viewer {

/// The farthest that a point of it may be from the robot, in sizes of its stance (scale_of()).
inline constexpr double kFarthestPoint = 100.0;

/// A path on the ground that a steered walk follows by the place that the simulator knows. It stays
/// where it is made: neither copied nor moved.
class FollowedPath {
 public:
  /// @param X_WP  of the path's frame in the world
  FollowedPath(path_following::PathTask task, const PlanarPose& X_WP);
  FollowedPath(const FollowedPath&) = delete;
  FollowedPath& operator=(const FollowedPath&) = delete;

  /// The command for the next tick; none while it is interrupted and once it has arrived. Allocates nothing.
  [[nodiscard]] heading_control::HeadingCommand steer(const footstep_gen::Walker& walker,
                                                      const GroundTruth& truth) noexcept;
  /// After every tick. @returns the distance from the path, > 0 to its left; 0 before its first point [m]
  double observe(const footstep_gen::Walker& walker, const GroundTruth& truth);

  /// It does not steer until it goes on, from where it was on the path.
  void interrupt() { interrupted_ = true; }
  void go_on() { interrupted_ = false; }

  [[nodiscard]] bool steers() const { return !interrupted_ && !arrived_; }
  [[nodiscard]] bool arrived() const { return arrived_; }  ///< at its end, and stands
  [[nodiscard]] bool closed() const { return task_.path.closed(); }
  /// Points along it for a picture, one lap, in the world [m].
  [[nodiscard]] std::vector<Vector2> picture() const;

 private:
  path_following::PathTask task_;
  PlanarPose X_WP_;
  walk::PathPilot pilot_;
  walk::PathJudge judge_;
  bool interrupted_ = false, arrived_ = false;
};

/// A path through points in the world, smooth; a closed one goes round and round.
/// @throws InvalidInput  if a point is too far from the robot, or as for a path in a file
[[nodiscard]] path_following::PathTask drawn_path(std::span<const Vector2> points_W, bool closed,
                                                  const RobotModel& robot, const StepParams& step,
                                                  const PlanarPose& X_WB);

}  // namespace hexagait::viewer

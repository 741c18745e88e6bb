// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/path_following/pursuit.hpp>
#include <hexagait/walk/referee/reference_path.hpp>
#include <vector>

namespace hexagait::walk {

/// How well a robot followed its path. Distances are of the base's origin, seen from above, from when it
/// is at the first point.
struct PathSummary {
  double length = 0.0;                             ///< that it was to go, all laps [m]
  double done = 0.0;                               ///< of it, by the truth [m]
  double believed_mean = 0.0, believed_max = 0.0;  ///< distance of its odometry from the path [m]
  /// The greatest distance of a point of the path, up to `done`, from where the robot has been: a corner
  /// that it cuts, or a part that it left out [m].
  double missed = 0.0;
  double off_end = 0.0;  ///< distance from the end of the path, when it stood there [m]
  bool arrived = false;  ///< it took itself to be at the end, and stopped
};

/// Judges by the true pose how a path is followed; knows nothing of the pilot's progress.
class PathJudge {
 public:
  /// @param start  true pose of the base at the start, of the path's frame in the world
  PathJudge(const path_following::PathTask& task, const PlanarPose& start);

  /// After every tick.
  /// @param X_OB  odometry
  ReferencePath::Deviation observe(const PlanarPose& X_WB, const PlanarPose& X_OB);

  /// Whether it has been at the first point.
  [[nodiscard]] bool on_path() const { return progress_.on_path; }
  /// Where the base should be, in the world: the nearest place of the path, facing as it is to.
  [[nodiscard]] PlanarPose ideal() const;
  /// All but `arrived`.
  [[nodiscard]] PathSummary summary() const;

 private:
  struct Progress {
    double s = 0.0;
    bool on_path = false;
  };
  // Follows a place, seen in the path's frame, along the path; its distance from it, > 0 to the left.
  double follow(Progress& progress, const Vector2& p_P) const;
  void visit(const Vector2& p_P);

  const path_following::PathTask* task_;
  PlanarPose start_;
  Progress progress_, believed_;
  double believed_sum_ = 0.0, believed_max_ = 0.0, off_end_ = 0.0;
  long believed_ticks_ = 0;
  double spacing_ = 0.0;
  std::vector<double> nearest_;  ///< squared distance of the walk from points every `spacing_` [m²]
};

}  // namespace hexagait::walk

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <hexagait/params/params_for.hpp>
#include <hexagait/path_following/path_faults.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/viewer/tasks/followed_path.hpp>
#include <hexagait/walk/paths/path_file.hpp>

namespace hexagait::viewer {
namespace {

using path_following::PathTask;

constexpr int kLaps = 1000;          // of a closed path: as many as nobody waits for
constexpr double kPicture = 0.2;     // of the look-ahead, between points of a picture
constexpr std::size_t kMost = 1000;  // points of a picture

GroundTruth at(const PlanarPose& X_WP) {
  GroundTruth truth;
  truth.X_WB.p = {X_WP.shift.x(), X_WP.shift.y(), 0.0};
  truth.X_WB.R = rotation({0.0, 0.0, X_WP.angle});
  return truth;
}

}  // namespace

FollowedPath::FollowedPath(PathTask task, const PlanarPose& X_WP)
    : task_(std::move(task)),
      X_WP_(X_WP),
      pilot_(task_, walk::LocalisedBy::truth, at(X_WP)),
      judge_(task_, X_WP) {}

heading_control::HeadingCommand FollowedPath::steer(const footstep_gen::Walker& walker,
                                                    const GroundTruth& truth) noexcept {
  return pilot_.steer(walker, truth);
}

double FollowedPath::observe(const footstep_gen::Walker& walker, const GroundTruth& truth) {
  arrived_ = arrived_ || pilot_.stands_at_end(walker);
  const PlanarPose X_WB = in_plane(truth.X_WB);
  return judge_.observe(X_WB, between(X_WP_, X_WB)).lateral;
}

std::vector<Vector2> FollowedPath::picture() const {
  const double length = task_.path.length();
  const auto pieces = std::clamp(
      static_cast<std::size_t>(std::ceil(length / (kPicture * task_.look_ahead))), 2UL, kMost);
  std::vector<Vector2> points;
  for (std::size_t k = 0; k <= pieces; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(pieces);
    points.push_back(X_WP_ * task_.path.at(share * length));
  }
  return points;
}

PathTask drawn_path(std::span<const Vector2> points_W, bool closed, const RobotModel& robot,
                    const StepParams& step, const PlanarPose& X_WB) {
  const double farthest = kFarthestPoint * scale_of(robot).size;
  std::vector<path_following::Waypoint> waypoints;
  for (const Vector2& p_W : points_W) {
    waypoints.push_back({.p_P = p_W});
    if (const double far = (p_W - X_WB.shift).norm(); !(far <= farthest))
      throw InvalidInput(
          fmt::format("path: point {} is {:.3g} m from {}; at most {:.3g} m are walked to",
                      waypoints.size(), far, robot.name, farthest));
  }
  constexpr auto kShape = path_following::Shape::spline;
  const auto faults = faults_of(waypoints, kShape, closed, step.stroke);
  if (!faults.empty()) throw InvalidInput("path: " + faults.front().problem);
  PathTask task = walk::task_of({waypoints, kShape, closed}, robot, step);
  if (closed) task.laps = kLaps;
  return task;
}

}  // namespace hexagait::viewer

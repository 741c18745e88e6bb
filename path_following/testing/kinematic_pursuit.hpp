// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <hexagait/path_following/pursuit.hpp>
#include <numbers>

/// A body without legs that does at once what pursuit commands.
namespace hexagait::path_following::testing {

struct Follower {
  PathTask task;
  PlanarPose X_PB = {};
  PathProgress progress = {};
  double farthest = 0.0;  ///< from the path since it was at the first point [m]

  /// Goes on by `step` of its path, at most `steps` times.
  void follow(int steps, double step = 0.005) {
    for (int k = 0; k < steps && !progress.arrived; ++k) {
      const Pursuit now = pursue(progress, task, X_PB, 0.0);
      progress = now.progress;
      if (progress.on_path) farthest = std::max(farthest, off());
      const heading_control::Heading& h = now.command.heading;
      if (!h.moving()) continue;
      const PlanarTwist per_metre{h.rho() * unit_vector(h.crab_angle()), h.k()};
      const double size = std::max(h.rho(), 0.3 * std::abs(h.k()));  // feet at 0.3 m
      X_PB = X_PB * exponential(per_metre, step / size);
      X_PB.angle = wrap_angle(X_PB.angle);
    }
  }
  [[nodiscard]] double off() const {
    const double from = std::max(0.0, progress.s - 0.1),
                 to = std::min(task.end(), progress.s + 0.1);
    return (task.path.at(task.path.nearest(X_PB.shift, from, to)) - X_PB.shift).norm();
  }
  [[nodiscard]] double off_facing() const {
    return std::abs(wrap_angle(X_PB.angle - facing_at(task, progress.s)));
  }
};

/// A circle of 64 points about (0, radius), from the origin, to the left.
inline Path circle(double radius) {
  std::vector<Waypoint> points;
  for (int k = 0; k < 64; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / 64.0;
    points.push_back({{radius * portable::sin(angle), radius * (1.0 - portable::cos(angle))}});
  }
  return {points, Shape::spline, true};
}

inline Path line(double length) { return {{{{0.0, 0.0}}, {{length, 0.0}}}, Shape::lines, false}; }

/// A square of this side, to the left.
inline Path square(double a) {
  return {{{{0.0, 0.0}}, {{a, 0.0}}, {{a, a}}, {{0.0, a}}}, Shape::lines, true};
}

}  // namespace hexagait::path_following::testing

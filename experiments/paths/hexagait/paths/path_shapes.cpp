// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/paths/path_shapes.hpp>
#include <numbers>

namespace hexagait::experiments {

using path_following::Shape;
using path_following::Waypoint;

// Bernoulli's lemniscate, turned by 45°.
path_following::Path figure_eight(double size) {
  constexpr int kPoints = 24;
  std::vector<Waypoint> points;
  for (int k = 0; k < kPoints; ++k) {
    const Vector2 u = unit_vector(2.0 * std::numbers::pi * k / kPoints);  // from the crossing on
    const double a = 2.0 * size * u.y() / (1.0 + u.x() * u.x());
    const Vector2 p(a, a * u.x());
    points.push_back({std::numbers::sqrt2 / 2.0 * Vector2(p.x() + p.y(), p.x() - p.y())});
  }
  return {points, Shape::spline, true};
}

path_following::Path square(double size) {
  std::vector<Waypoint> points = {
      {{0.0, 0.0}}, {{1.0, 0.0}}, {{1.0, 2.0}}, {{-1.0, 2.0}}, {{-1.0, 0.0}}};
  for (Waypoint& point : points) point.p_P *= size;
  return {points, Shape::lines, true};
}

}  // namespace hexagait::experiments

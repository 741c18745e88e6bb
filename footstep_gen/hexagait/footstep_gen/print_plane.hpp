// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <hexagait/math/geometry.hpp>
#include <hexagait/math/leg.hpp>

namespace hexagait::footstep_gen {

/// The plane through the footprints by least squares of their heights, in odom. Odometry may tilt, so that prints on
/// level ground differ in height; from their plane they don't.
struct PrintPlane {
  Vector2 middle = Vector2::Zero();  ///< [m]
  double height = 0.0;               ///< there [m]
  Vector2 slope = Vector2::Zero();
  double off = 0.0;  ///< greatest distance of a print above or below it [m]

  [[nodiscard]] double at(const Vector2& p_O) const noexcept {
    return height + slope.dot(p_O - middle);
  }
};

/// Of prints on one line, a level one.
[[nodiscard]] inline PrintPlane plane_through(const LegArray<Vector3>& print_O) noexcept {
  Vector3 middle = Vector3::Zero();
  for (const Vector3& print : print_O) middle += print / print_O.size();
  Matrix3 moments = Matrix3::Zero();
  for (const Vector3& print : print_O) moments += (print - middle) * (print - middle).transpose();
  const double xx = moments(0, 0), xy = moments(0, 1), yy = moments(1, 1);
  const double xz = moments(0, 2), yz = moments(1, 2), determinant = xx * yy - xy * xy;

  PrintPlane plane{.middle = middle.head<2>(), .height = middle.z()};
  if (determinant > 0.0) plane.slope = Vector2(yy * xz - xy * yz, xx * yz - xy * xz) / determinant;
  for (const Vector3& print : print_O)
    plane.off = std::max(plane.off, std::abs(print.z() - plane.at(print.head<2>())));
  return plane;
}

}  // namespace hexagait::footstep_gen

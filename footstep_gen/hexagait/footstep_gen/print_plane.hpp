// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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
[[nodiscard]] PrintPlane plane_through(const LegArray<Vector3>& print_O) noexcept;

}  // namespace hexagait::footstep_gen

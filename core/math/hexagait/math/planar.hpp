// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/math/geometry.hpp>

namespace hexagait {

/// Motion of the body in its horizontal plane, per unit of something (a second, or a metre of
/// path). Expressed in the body frame: the origin moves along v while the body turns at w about z.
struct PlanarTwist {
  Vector2 v = Vector2::Zero();
  double w = 0.0;
};

/// A displacement in the plane: turn by angle, then shift. p' = Rz(angle) p + shift.
struct PlanarPose {
  double angle = 0.0;               ///< [rad]
  Vector2 shift = Vector2::Zero();  ///< [m]

  friend PlanarPose operator*(const PlanarPose& a, const PlanarPose& b) {
    const double c = std::cos(a.angle), s = std::sin(a.angle);
    return {a.angle + b.angle, a.shift + Vector2(c * b.shift.x() - s * b.shift.y(),
                                                 s * b.shift.x() + c * b.shift.y())};
  }
  friend Vector2 operator*(const PlanarPose& a, const Vector2& p) {
    return (a * PlanarPose{0.0, p}).shift;
  }
  [[nodiscard]] PlanarPose inverse() const {
    const double c = std::cos(angle), s = std::sin(angle);
    return {-angle, {-c * shift.x() - s * shift.y(), s * shift.x() - c * shift.y()}};
  }
};

/// The displacement after following `twist` for a length (or time) s: the exponential map of SE(2).
/// Exact for all w·s, also 0.
[[nodiscard]] PlanarPose exponential(const PlanarTwist& twist, double s);

/// The twist that leads to `pose` in one unit; inverse of exponential(·, 1) for |angle| < π.
[[nodiscard]] PlanarTwist logarithm(const PlanarPose& pose);

}  // namespace hexagait

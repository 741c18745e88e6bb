// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/math/geometry.hpp>
#include <hexagait/math/trigonometry.hpp>

namespace hexagait {

/// A planar twist in the body frame: the origin moves along v while the body turns at w about z.
/// Per second or per metre of path, as the user says.
struct PlanarTwist {
  Vector2 v = Vector2::Zero();  ///< [m/s] or [m/m]
  double w = 0.0;               ///< [rad/s] or [rad/m]
};

/// A planar displacement: p' = Rz(angle) p + shift.
struct PlanarPose {
  double angle = 0.0;               ///< [rad]
  Vector2 shift = Vector2::Zero();  ///< [m]

  friend PlanarPose operator*(const PlanarPose& a, const PlanarPose& b) {
    const auto [s, c] = portable::sincos(a.angle);
    return {a.angle + b.angle, a.shift + Vector2(c * b.shift.x() - s * b.shift.y(),
                                                 s * b.shift.x() + c * b.shift.y())};
  }
  friend Vector2 operator*(const PlanarPose& a, const Vector2& p) {
    return (a * PlanarPose{0.0, p}).shift;
  }
  [[nodiscard]] PlanarPose inverse() const {
    const auto [s, c] = portable::sincos(angle);
    return {-angle, {-c * shift.x() - s * shift.y(), s * shift.x() - c * shift.y()}};
  }
};

/// A pose seen from above: its yaw and its place.
[[nodiscard]] inline PlanarPose in_plane(const Pose& X) {
  return {portable::atan2(X.R(1, 0), X.R(0, 0)), X.p.head<2>()};
}

/// a.inverse() * b: the pose b as seen from a.
[[nodiscard]] inline PlanarPose between(const PlanarPose& a, const PlanarPose& b) {
  const auto [s, c] = portable::sincos(a.angle);
  const Vector2 way = b.shift - a.shift;
  return {b.angle - a.angle, {c * way.x() + s * way.y(), c * way.y() - s * way.x()}};
}

/// The displacement after following `twist` for a time or path length s: the exponential map of
/// SE(2). Accurate for every w·s, including 0.
[[nodiscard]] PlanarPose exponential(const PlanarTwist& twist, double s);

/// exponential(twist, s) * p: where a point goes.
[[nodiscard]] Vector2 carried(const Vector2& p, const PlanarTwist& twist, double s);

/// The twist that reaches `pose` in one second (or metre): the inverse of exponential(·, 1) for
/// |angle| < π.
[[nodiscard]] PlanarTwist logarithm(const PlanarPose& pose);

}  // namespace hexagait

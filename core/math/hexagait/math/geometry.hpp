// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <hexagait/math/trigonometry.hpp>
#include <numbers>

namespace hexagait {

using Vector2 = Eigen::Vector2d;
using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;

/// Pose of frame B in frame A: p_A = R_AB · p_B + p_AB. Monogram notation: docs/notation.md.
struct Pose {
  Matrix3 R = Matrix3::Identity();  ///< rotation R_AB
  Vector3 p = Vector3::Zero();      ///< position p_AB of B's origin, in A [m]

  [[nodiscard]] Pose inverse() const { return {R.transpose(), -(R.transpose() * p)}; }

  friend Pose operator*(const Pose& X_AB, const Pose& X_BC) {
    return {X_AB.R * X_BC.R, X_AB.R * X_BC.p + X_AB.p};
  }
  friend Vector3 operator*(const Pose& X_AB, const Vector3& p_B) { return X_AB.R * p_B + X_AB.p; }
};

/// The twist of a body, expressed in the axes of that body.
struct Twist {
  Vector3 v = Vector3::Zero();  ///< linear velocity of the body's origin [m/s]
  Vector3 w = Vector3::Zero();  ///< angular velocity [rad/s]
};

/// Wraps an angle into (−π, π] [rad].
[[nodiscard]] inline double wrap_angle(double angle) {
  if (std::abs(angle) <= std::numbers::pi) return angle;
  return std::remainder(angle, 2.0 * std::numbers::pi);
}

/// The angle of a vector from x, in [−π, π] [rad].
[[nodiscard]] inline double angle_of(const Vector2& v) { return portable::atan2(v.y(), v.x()); }

/// The unit vector at `angle` [rad] from x.
[[nodiscard]] inline Vector2 unit_vector(double angle) {
  const auto [s, c] = portable::sincos(angle);
  return {c, s};
}

/// Rotation by `angle` [rad] about z.
[[nodiscard]] inline Matrix3 rotation_z(double angle) {
  const auto [s, c] = portable::sincos(angle);
  return (Matrix3() << c, -s, 0, s, c, 0, 0, 0, 1).finished();
}

/// Rotation by the vector w: angle |w| [rad] about w/|w| (Rodrigues). Exact for any |w|, also 0.
[[nodiscard]] Matrix3 rotation(const Vector3& w);

/// The rotation vector of R, |w| in [0, π] [rad]; inverse of rotation().
[[nodiscard]] Vector3 rotation_vector(const Matrix3& R);

/// Roll, pitch, yaw [rad] of R = Rz(yaw) Ry(pitch) Rx(roll) (REP-103).
[[nodiscard]] Vector3 roll_pitch_yaw(const Matrix3& R);

/// R with its columns made orthonormal again (one Gram-Schmidt pass): removes rounding drift.
[[nodiscard]] Matrix3 orthonormalised(const Matrix3& R);

/// [a]×, the matrix for which [a]× b = a × b.
[[nodiscard]] inline Matrix3 cross_matrix(const Vector3& a) {
  return (Matrix3() << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0).finished();
}

/// The displacement that rotates everything by R about an axis through the point p [m].
[[nodiscard]] inline Pose rotation_about(const Vector3& p, const Matrix3& R) {
  return {R, p - R * p};
}

/// The points of two lines that are closest to each other [m].
struct NearestPoints {
  Vector3 on_first = Vector3::Zero(), on_second = Vector3::Zero();
};

/// The closest points of the lines through p_1 and p_2 [m] along the unit vectors a_1 and a_2. Of
/// parallel lines: p_2 and its projection onto the first line.
[[nodiscard]] NearestPoints nearest_points(const Vector3& p_1, const Vector3& a_1,
                                           const Vector3& p_2, const Vector3& a_2);

/// z × v: v rotated by +90° about z.
[[nodiscard]] inline Vector2 perpendicular(const Vector2& v) { return {-v.y(), v.x()}; }

/// z component of a × b.
[[nodiscard]] inline double cross(const Vector2& a, const Vector2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace hexagait

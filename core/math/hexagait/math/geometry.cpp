// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/math/geometry.hpp>
#include <hexagait/math/trigonometry.hpp>

namespace hexagait {

// With the half angle nothing cancels: R = 1 + 2 cos sin [a]× + 2 sin² [a]× [a]×, a = w/|w|.
Matrix3 rotation(const Vector3& w) {
  const double angle = w.norm();
  if (angle == 0.0) return Matrix3::Identity();
  const auto [s, c] = portable::sincos(0.5 * angle);
  const Vector3 v = (s / angle) * w;
  return Eigen::Quaterniond(c, v.x(), v.y(), v.z()).toRotationMatrix();
}

Vector3 rotation_vector(const Matrix3& R) {
  const Eigen::Quaterniond half(R);
  const double s = half.vec().norm();
  if (s == 0.0) return Vector3::Zero();
  const double angle = 2.0 * portable::atan2(s, std::abs(half.w()));
  return (half.w() < 0.0 ? -angle / s : angle / s) * half.vec();
}

Vector3 roll_pitch_yaw(const Matrix3& R) {
  return {portable::atan2(R(2, 1), R(2, 2)),
          portable::atan2(-R(2, 0), portable::hypot(R(2, 1), R(2, 2))),
          portable::atan2(R(1, 0), R(0, 0))};
}

Matrix3 orthonormalised(const Matrix3& R) {
  Matrix3 Q;
  Q.col(0) = R.col(0).normalized();
  Q.col(1) = (R.col(1) - Q.col(0).dot(R.col(1)) * Q.col(0)).normalized();
  Q.col(2) = Q.col(0).cross(Q.col(1));
  return Q;
}

NearestPoints nearest_points(const Vector3& p_1, const Vector3& a_1, const Vector3& p_2,
                             const Vector3& a_2) {
  constexpr double kParallel = 1e-9;
  const Vector3 way = p_2 - p_1;
  const double along = a_1.dot(a_2), skew = 1.0 - along * along;
  if (skew < kParallel) return {p_1 + a_1 * a_1.dot(way), p_2};
  const double s = (a_1.dot(way) - along * a_2.dot(way)) / skew;
  const double t = (along * a_1.dot(way) - a_2.dot(way)) / skew;
  return {p_1 + s * a_1, p_2 + t * a_2};
}

}  // namespace hexagait

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/math/trigonometry.hpp>
#include <hexagait/urdf/detail/rotations.hpp>

namespace hexagait {

Matrix3 rotation_of(const Vector3& rpy) {
  const portable::SinCos roll = portable::sincos(0.5 * rpy.x()),
                         pitch = portable::sincos(0.5 * rpy.y()),
                         yaw = portable::sincos(0.5 * rpy.z());
  const double x = roll.s * pitch.c * yaw.c - roll.c * pitch.s * yaw.s,
               y = roll.c * pitch.s * yaw.c + roll.s * pitch.c * yaw.s,
               z = roll.c * pitch.c * yaw.s - roll.s * pitch.s * yaw.c,
               w = roll.c * pitch.c * yaw.c + roll.s * pitch.s * yaw.s;
  const double norm = std::sqrt(x * x + y * y + z * z + w * w);
  return Eigen::Quaterniond(w / norm, x / norm, y / norm, z / norm).toRotationMatrix();
}

}  // namespace hexagait

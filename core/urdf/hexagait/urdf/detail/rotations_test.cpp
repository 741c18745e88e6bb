// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/urdf/detail/rotations.hpp>

namespace hexagait {
namespace {

// Rz(yaw) Ry(pitch) Rx(roll), by Eigen and the C library.
TEST(RotationOf, IsTheProductOfRotationsAboutFixedAxesXYZ) {
  for (const Vector3& rpy : {Vector3(0.1, -0.2, 3.0),
                             {-1.5, 0.7, 2.0},
                             {0.0, 1.5707963267948966, -2.5},
                             {0.0, 0.0, 0.0},
                             {4.0, -5.0, 6.0}}) {
    const Matrix3 expected = (Eigen::AngleAxisd(rpy.z(), Vector3::UnitZ()) *
                              Eigen::AngleAxisd(rpy.y(), Vector3::UnitY()) *
                              Eigen::AngleAxisd(rpy.x(), Vector3::UnitX()))
                                 .toRotationMatrix();
    EXPECT_LT((rotation_of(rpy) - expected).norm(), 2e-15);
  }
}

}  // namespace
}  // namespace hexagait

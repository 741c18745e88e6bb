// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/math/geometry.hpp>

namespace hexagait {

/// The rotation Rz(yaw) Ry(pitch) Rx(roll) of a URDF's rpy [rad], as the product of three half-angle
/// quaternions.
[[nodiscard]] Matrix3 rotation_of(const Vector3& rpy);

}  // namespace hexagait

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/math/geometry.hpp>

namespace hexagait::detail {

/// v turned about the unit vector a by the angle of this cosine and sine (Rodrigues).
[[nodiscard]] inline Vector3 turned(const Vector3& v, const Vector3& a, double c, double s) {
  return c * v + s * a.cross(v) + ((1.0 - c) * a.dot(v)) * a;
}

}  // namespace hexagait::detail

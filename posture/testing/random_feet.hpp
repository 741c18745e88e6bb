// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/math/geometry.hpp>
#include <hexagait/math/leg.hpp>
#include <hexagait/sim/random.hpp>
#include <testing/random_vector.hpp>

namespace hexagait::posture::testing {

/// Workspace centres of six legs, two by two [m].
inline LegArray<Vector3> centres() {
  LegArray<Vector3> p_BC(6);
  for (LegId leg = 0; leg < 6; ++leg)
    p_BC[leg] = {0.4 * (1 - leg / 2), leg % 2 == 0 ? 0.3 : -0.3, -0.25};
  return p_BC;
}

using hexagait::testing::random_vector;

/// Feet anywhere within `size` of their centres, along each axis [m].
inline LegArray<Vector3> random_feet(RandomSequence& random, double size) {
  LegArray<Vector3> p_BF = centres();
  for (Vector3& p : p_BF) p += random_vector(random, size);
  return p_BF;
}

}  // namespace hexagait::posture::testing

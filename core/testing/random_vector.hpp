// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/math/geometry.hpp>
#include <hexagait/sim/random.hpp>

namespace hexagait::testing {

/// Each coordinate uniform in ±size, drawn in the order x, y, z.
inline Vector3 random_vector(RandomSequence& random, double size = 1.0) {
  const double x = random.uniform(-size, size), y = random.uniform(-size, size);
  return {x, y, random.uniform(-size, size)};
}

}  // namespace hexagait::testing

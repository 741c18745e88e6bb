// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <hexagait/math/geometry.hpp>
#include <hexagait/math/leg.hpp>
#include <hexagait/params/robot_params.hpp>

namespace hexagait::footstep_gen {

/// How much higher the highest of the last footprints is than the lowest, along gravity [m].
/// \param print_O  of all legs, in odom; not empty
[[nodiscard]] inline double height_spread(const LegArray<Vector3>& print_O) noexcept {
  double lowest = print_O[0].z(), highest = lowest;
  for (const Vector3& print : print_O) {
    lowest = std::min(lowest, print.z());
    highest = std::max(highest, print.z());
  }
  return highest - lowest;
}

/// The steps for ground as rough as the feet have found it, (step 2): lower on level ground; from a
/// spread of (1 − level_height) height on, as high as over rough ground.
[[nodiscard]] inline StepParams on_ground(StepParams step, double spread) noexcept {
  step.height = std::min(step.height, step.level_height * step.height + spread);
  return step;
}

}  // namespace hexagait::footstep_gen

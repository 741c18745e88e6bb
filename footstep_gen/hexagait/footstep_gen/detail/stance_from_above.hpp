// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/executor/executor.hpp>

namespace hexagait::footstep_gen {

/// A robot seen along gravity: axes of odom, origin at the body's.
struct StanceFromAbove {
  LegArray<Vector3> feet;  ///< set points [m]
  Vector2 p_M;             ///< centre of mass, as Executor::p_BM() [m]
};

/// @param R_OB  the body's rotation in odom, whose z is up
[[nodiscard]] inline StanceFromAbove stance_from_above(const Executor& executor,
                                                       const Matrix3& R_OB) noexcept {
  StanceFromAbove stance{LegArray<Vector3>(executor.legs().size()),
                         (R_OB * executor.p_BM()).head<2>()};
  for (LegId i = 0; i < stance.feet.size(); ++i) stance.feet[i] = R_OB * executor.legs()[i].p_BF;
  return stance;
}

}  // namespace hexagait::footstep_gen

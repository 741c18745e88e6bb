// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/posture/lean.hpp>

namespace hexagait::posture {

Vector2 lean(const LegArray<Vector3>& p_BC, const Vector3& p_BM, const Vector3& up_B,
             double most) noexcept {
  constexpr double kSteep =
      0.5;  // cosine of the steepest slope that counts; `most` bounds it before
  double height = 0.0;
  for (const Vector3& centre : p_BC) height += (p_BM.z() - centre.z()) / p_BC.size();
  const Vector2 way = -height / std::max(kSteep, up_B.z()) * up_B.head<2>();
  const double length = way.norm();
  return length > most ? Vector2(most / length * way) : way;
}

}  // namespace hexagait::posture

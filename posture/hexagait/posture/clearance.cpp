// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/posture/clearance.hpp>

namespace hexagait::posture {

double clearance(const LegArray<Vector3>& ground_BF, const LegArray<Vector3>& p_BC,
                 const PlaneFit& plane, LegSet legs) noexcept {
  constexpr double kShare = 0.5, kMost = 1.0 / 3.0;
  double highest = 0.0, depth = 0.0;
  for (LegId i = 0; i < p_BC.size(); ++i) {
    depth -= p_BC[i].z() / p_BC.size();
    if (!legs.contains(i)) continue;
    const Vector3& g = ground_BF[i];
    const double on_plane = plane.height + plane.roll * g.y() - plane.pitch * g.x();
    highest = std::max(highest, g.z() - p_BC[i].z() - on_plane);
  }
  return std::min(kMost * std::max(0.0, depth), kShare * highest);
}

}  // namespace hexagait::posture

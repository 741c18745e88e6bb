// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/footstep_gen/detail/rear_edge.hpp>
#include <hexagait/gait_state/ring.hpp>

namespace hexagait::footstep_gen {
namespace {

constexpr double kHysteresis = 0.05;  // of the distance of the farthest centre

}  // namespace

int rear_edge(const heading_control::PathArc& arc, int present) noexcept {
  const int n = arc.p_BC.size();
  const Vector2 back = -arc.per_metre.v;
  LegArray<double> behind(n);  // by ring position
  double size2 = 0.0;
  for (int k = 0; k < n; ++k) {
    const Vector2 centre = arc.p_BC[gait_state::leg_at(k, n)].head<2>();
    behind[k] = back.dot(centre);
    size2 = std::max(size2, centre.squaredNorm());
  }
  const auto score = [&](int k) { return 0.5 * (behind[k] + behind[k + 1 == n ? 0 : k + 1]); };

  int best = present;
  for (int k = 0; k < n; ++k)
    if (score(k) > score(best)) best = k;
  return score(best) > score(present) + kHysteresis * std::sqrt(size2) ? best : present;
}

}  // namespace hexagait::footstep_gen

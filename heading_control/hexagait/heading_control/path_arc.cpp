// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/heading_control/path_arc.hpp>

namespace hexagait::heading_control {

PathArc path_arc(const Heading& heading, const Stance& stance) noexcept {
  const int n = stance.p_BC.size();
  const double k = heading.k(), rho = heading.rho(), alpha = heading.crab_angle();
  const PlanarTwist unit{rho * unit_vector(alpha), k};
  PathArc arc{
      heading, stance.p_BC, unit, LegArray<Vector2>(n, Vector2::Zero()), LegArray<double>(n), 0};

  // |velocity at cᵢ| = |k cᵢ − ρ u|; the greatest is the unit of path.
  LegArray<double> speed(n);
  for (LegId leg = 0; leg < n; ++leg) {
    arc.direction[leg] = direction_at(arc, arc.p_BC[leg]);
    speed[leg] = arc.direction[leg].norm();
    if (speed[leg] > speed[arc.farthest]) arc.farthest = leg;
  }
  const double m = speed[arc.farthest];
  assert(m > 0.0);
  arc.per_metre = {unit.v / m, unit.w / m};

  // R / max(|cᵢ − o|, ρᵢ) with both multiplied by |k|, which leaves it finite when k = 0.
  for (LegId leg = 0; leg < n; ++leg) {
    if (speed[leg] == 0.0) continue;
    arc.direction[leg] /= speed[leg];
    arc.lag_scale[leg] = m / std::max(speed[leg], std::abs(k) * stance.radius[leg]);
  }
  return arc;
}

PlanarPose displacement(const PathArc& arc, double s) noexcept {
  return exponential(arc.per_metre, s);
}

Vector3 advance(const PathArc& arc, const Vector3& p_B, double s) noexcept {
  const Vector2 p = carried(p_B.head<2>(), arc.per_metre, s);
  return {p.x(), p.y(), p_B.z()};
}

Vector3 aep(const PathArc& arc, LegId leg, double half_step) noexcept {
  return advance(arc, arc.p_BC[leg], arc.heading.moving() ? half_step : 0.0);
}

LegArray<double> lags(const PathArc& arc, const LegArray<Vector3>& p_BF) noexcept {
  LegArray<double> result(p_BF.size());
  for (LegId leg = 0; leg < p_BF.size(); ++leg) result[leg] = lag(arc, leg, p_BF[leg]);
  return result;
}

}  // namespace hexagait::heading_control

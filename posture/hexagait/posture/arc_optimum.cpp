// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <hexagait/math/trigonometry.hpp>
#include <hexagait/posture/arc_optimum.hpp>
#include <numbers>

namespace hexagait::posture {
namespace {

// The three sums of the quadratic.
struct Sums {
  double lag_S = 0.0, lag_A = 0.0;  // Σ t(c)·(c − p)
  double D = 0.0;                   // Σ_S t(p)·t(c)
};

Sums sums(const LegArray<Vector3>& p_BF, const LegArray<Vector3>& p_BC, LegSet support,
          const PlanarTwist& per_metre) {
  Sums sums;
  for (LegId leg = 0; leg < p_BF.size(); ++leg) {
    const Vector2 offset = (p_BC[leg] - p_BF[leg]).head<2>();
    const Vector2 t_c = per_metre.v + per_metre.w * perpendicular(p_BC[leg].head<2>());
    const double lag = t_c.dot(offset);
    if (support.contains(leg)) {
      sums.lag_S += lag;
      sums.D += t_c.dot(t_c - per_metre.w * perpendicular(offset));
    } else {
      sums.lag_A += lag;
    }
  }
  return sums;
}

// 2 atan(w q) / w. Below 1e-4 the series has a relative error of less than 1e-16.
double path_length(double q, double w) {
  const double x = w * q;
  return std::abs(x) < 1e-4 ? 2.0 * q * (1.0 - x * x / 3.0) : 2.0 * portable::atan(x) / w;
}

// The minimum of |f| where f has no zero: the extremum of f on the side of the airborne legs.
double extremum(const Sums& sums, double w) {
  const double quarter = std::copysign(0.5 * std::numbers::pi, w * sums.lag_A);
  return wrap_angle(-quarter - portable::atan2(w * sums.lag_S, sums.D)) / w;
}

}  // namespace

ArcOptimum arc_optimum(const LegArray<Vector3>& p_BF, const LegArray<Vector3>& p_BC, LegSet support,
                       const PlanarTwist& per_metre) noexcept {
  using enum ArcOptimum::Status;
  const double w = per_metre.w;
  const Sums s = sums(p_BF, p_BC, support, per_metre);
  if (s.D == 0.0 && w * s.lag_S == 0.0) return {0.0, unsupported};

  const double discriminant = s.D * s.D + w * w * (s.lag_S - s.lag_A) * (s.lag_S + s.lag_A);
  if (discriminant < 0.0) return {extremum(s, w), clamped};
  const double root = std::sqrt(discriminant);

  // Both quotients are tan(θ/2); each is used where its sum does not cancel. D < 0 (feet on the far
  // side of the turning centre) implies w ≠ 0.
  if (s.D >= 0.0) return {path_length(-(s.lag_S + s.lag_A) / (s.D + root), w), found};
  return {wrap_angle(2.0 * portable::atan2(root - s.D, w * (s.lag_A - s.lag_S))) / w, found};
}

}  // namespace hexagait::posture

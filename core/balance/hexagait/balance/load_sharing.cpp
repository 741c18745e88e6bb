// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/balance/load_sharing.hpp>

namespace hexagait {
namespace {

// Regularises the moments of one or two feet, which then share the weight [m²].
constexpr double kRegularisation = 1e-6;

}  // namespace

LegArray<double> shared_load(const LegArray<Vector3>& p_F, const Vector3& p_M,
                             const LegArray<double>& load, double weight) noexcept {
  const int n = p_F.size();
  LegArray<double> force(n, 0.0);

  // Normal equations for (a, b, c), with the centre of mass as the origin.
  double w = 0.0, wx = 0.0, wy = 0.0, wxx = kRegularisation, wxy = 0.0, wyy = kRegularisation;
  for (LegId i = 0; i < n; ++i) {
    const double x = p_F[i].x() - p_M.x(), y = p_F[i].y() - p_M.y();
    w += load[i];
    wx += load[i] * x;
    wy += load[i] * y;
    wxx += load[i] * x * x;
    wxy += load[i] * x * y;
    wyy += load[i] * y * y;
  }
  if (w <= 0.0) return force;

  // Their right-hand side is (W, 0, 0), so the solution is proportional to the first column of the
  // adjugate.
  const double a = wxx * wyy - wxy * wxy, b = wxy * wy - wx * wyy, c = wx * wxy - wxx * wy;

  // Feet cannot pull: set negative forces to 0 and scale the rest to the weight.
  double sum = 0.0;
  for (LegId i = 0; i < n; ++i) {
    const double x = p_F[i].x() - p_M.x(), y = p_F[i].y() - p_M.y();
    force[i] = std::max(0.0, load[i] * (a + b * x + c * y));
    sum += force[i];
  }
  const double scale = sum > 0.0 ? weight / sum : 0.0;
  for (LegId i = 0; i < n; ++i) force[i] *= scale;
  return force;
}

}  // namespace hexagait

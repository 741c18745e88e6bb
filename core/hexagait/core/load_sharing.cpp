// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>
#include <algorithm>
#include <hexagait/core/load_sharing.hpp>

namespace hexagait {
namespace {

// Keeps the moments soluble for one or two feet (they then share the weight alone) [m²].
constexpr double kRegularisation = 1e-6;

}  // namespace

LegArray<double> shared_load(const LegArray<Vector3>& p_F, const Vector3& p_M,
                             const LegArray<double>& share, double weight) noexcept {
  const int n = p_F.size();
  LegArray<double> force(n, 0.0);

  // Normal equations for (a, b, c), with the centre of mass as the origin.
  Matrix3 normal = Vector3(0.0, kRegularisation, kRegularisation).asDiagonal();
  for (LegId i = 0; i < n; ++i) {
    const Vector3 row(1.0, p_F[i].x() - p_M.x(), p_F[i].y() - p_M.y());
    normal += share[i] * row * row.transpose();
  }
  if (normal(0, 0) <= 0.0) return force;
  const Vector3 abc = normal.inverse() * Vector3(weight, 0.0, 0.0);

  // No foot can pull: drop what is negative and scale the rest to the weight.
  double sum = 0.0;
  for (LegId i = 0; i < n; ++i) {
    const Vector3 row(1.0, p_F[i].x() - p_M.x(), p_F[i].y() - p_M.y());
    force[i] = std::max(0.0, share[i] * abc.dot(row));
    sum += force[i];
  }
  const double scale = sum > 0.0 ? weight / sum : 0.0;
  for (LegId i = 0; i < n; ++i) force[i] *= scale;
  return force;
}

}  // namespace hexagait

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <hexagait/math/trigonometry.hpp>
#include <hexagait/posture/plane_fit.hpp>

namespace hexagait::posture {
namespace {

// Means and central second moments of (x, y, e), e the height error p_z − c_z.
struct Moments {
  Vector3 mean = Vector3::Zero();
  double xx = 0.0, xy = 0.0, yy = 0.0, xe = 0.0, ye = 0.0;
};

Moments moments(const LegArray<Vector3>& p_BF, const LegArray<Vector3>& p_BC, LegSet legs) {
  Moments m;
  for (LegId leg = 0; leg < p_BF.size(); ++leg)
    if (legs.contains(leg)) m.mean += p_BF[leg] - Vector3(0.0, 0.0, p_BC[leg].z());
  m.mean /= legs.size();
  for (LegId leg = 0; leg < p_BF.size(); ++leg) {
    if (!legs.contains(leg)) continue;
    const Vector3 d = p_BF[leg] - Vector3(0.0, 0.0, p_BC[leg].z()) - m.mean;
    m.xx += d.x() * d.x();
    m.xy += d.x() * d.y();
    m.yy += d.y() * d.y();
    m.xe += d.x() * d.z();
    m.ye += d.y() * d.z();
  }
  return m;
}

struct Slope {
  Vector2 gradient = Vector2::Zero();  // (a, b)
  int rank = 0;
};

// Solves [xx xy; xy yy] (a, b) = (xe, ye), in the least-norm sense if the feet are on a line.
Slope slope(const Moments& m) {
  constexpr double kOnALine = 1e-4;  // ratio of the principal moments, (1/100)²
  const double half_trace = 0.5 * (m.xx + m.yy);
  const double largest = half_trace + portable::hypot(0.5 * (m.xx - m.yy), m.xy);
  if (largest == 0.0) return {};
  const double determinant = m.xx * m.yy - m.xy * m.xy;  // = largest · smallest
  if (determinant > kOnALine * largest * largest)
    return {Vector2(m.yy * m.xe - m.xy * m.ye, m.xx * m.ye - m.xy * m.xe) / determinant, 2};
  // Along the line: its direction is the eigenvector of `largest`; take the better of two formulas.
  const Vector2 along =
      (m.xx >= m.yy ? Vector2(largest - m.yy, m.xy) : Vector2(m.xy, largest - m.xx)).normalized();
  return {along * along.dot(Vector2(m.xe, m.ye)) / largest, 1};
}

}  // namespace

PlaneFit plane_fit(const LegArray<Vector3>& p_BF, const LegArray<Vector3>& p_BC,
                   LegSet legs) noexcept {
  const LegSet counted = legs & LegSet::all(p_BF.size());
  if (counted.empty()) return {};
  const Moments m = moments(p_BF, p_BC, counted);
  const Slope s = slope(m);
  return {.height = m.mean.z() - s.gradient.dot(m.mean.head<2>()),
          .roll = s.gradient.y(),
          .pitch = -s.gradient.x(),
          .rank = 1 + s.rank};
}

}  // namespace hexagait::posture

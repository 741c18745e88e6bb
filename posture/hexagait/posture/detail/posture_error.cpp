// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <hexagait/posture/detail/posture_error.hpp>

namespace hexagait::posture {
namespace {

Vector2 velocity(const PlanarTwist& twist, const Vector3& p) {
  return twist.v + twist.w * perpendicular(p.head<2>());
}

}  // namespace

double quadratic_error(const LegArray<Vector3>& p_BF, const LegArray<Vector3>& p_BC) noexcept {
  double sum = 0.0;
  for (LegId leg = 0; leg < p_BF.size(); ++leg) sum += (p_BF[leg] - p_BC[leg]).squaredNorm();
  return sum;
}

PostureGradient gradient(const LegArray<Vector3>& p_BF, const LegArray<Vector3>& p_BC) noexcept {
  Vector3 shift = Vector3::Zero(), turn = Vector3::Zero();
  for (LegId leg = 0; leg < p_BF.size(); ++leg) {
    shift += p_BF[leg] - p_BC[leg];
    turn += p_BC[leg].cross(p_BF[leg]);
  }
  return {2.0 * shift.x(), 2.0 * shift.y(), 2.0 * shift.z(),
          2.0 * turn.x(),  2.0 * turn.y(),  2.0 * turn.z()};
}

double arc_gradient(const LegArray<Vector3>& p_BF, const LegArray<Vector3>& p_BC, double r,
                    double alpha) noexcept {
  const PostureGradient g = gradient(p_BF, p_BC);
  return r * unit_vector(alpha).dot(Vector2(g.x, g.y)) + g.yaw;
}

double advance_gradient(const LegArray<Vector3>& p_BF, const LegArray<Vector3>& p_BC,
                        const PlanarTwist& per_metre) noexcept {
  double sum = 0.0;
  for (LegId leg = 0; leg < p_BF.size(); ++leg)
    sum += velocity(per_metre, p_BC[leg]).dot((p_BC[leg] - p_BF[leg]).head<2>());
  return 2.0 * sum;
}

double advance_curvature(const LegArray<Vector3>& p_BF, LegSet support,
                         const PlanarTwist& per_metre) noexcept {
  double sum = 0.0;
  for (LegId leg = 0; leg < p_BF.size(); ++leg)
    if (support.contains(leg)) sum += velocity(per_metre, p_BF[leg]).squaredNorm();
  return 2.0 * sum;
}

}  // namespace hexagait::posture

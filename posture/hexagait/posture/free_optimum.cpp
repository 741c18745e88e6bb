// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <hexagait/posture/free_optimum.hpp>

namespace hexagait::posture {
namespace {

using Matrix4 = Eigen::Matrix4d;
using Vector4 = Eigen::Vector4d;

Vector3 mean(const LegArray<Vector3>& points, LegSet legs) {
  Vector3 sum = Vector3::Zero();
  for (LegId leg = 0; leg < points.size(); ++leg)
    if (legs.contains(leg)) sum += points[leg];
  return sum / legs.size();
}

// Horn's matrix N of S = Σ c′ p′ᵀ: Σ p′ · R(q) c′ = qᵀ N q for a unit quaternion (w, x, y, z).
Matrix4 quadratic_form(const Matrix3& S) {
  const Vector3 axis(S(1, 2) - S(2, 1), S(2, 0) - S(0, 2), S(0, 1) - S(1, 0));
  Matrix4 N;
  N(0, 0) = S.trace();
  N.block<1, 3>(0, 1) = axis.transpose();
  N.block<3, 1>(1, 0) = axis;
  N.block<3, 3>(1, 1) = S + S.transpose() - S.trace() * Matrix3::Identity();
  return N;
}

// Among the eigenvectors of the largest eigenvalue, the unit quaternion nearest to the identity.
Matrix3 best_rotation(const Matrix4& N) {
  constexpr double kSameEigenvalue =
      1e-9;  // of the width of the spectrum: feet within 3e-5 of a line
  const Eigen::SelfAdjointEigenSolver<Matrix4> eigen(N);
  const Vector4& value = eigen.eigenvalues();
  const double threshold = value[3] - kSameEigenvalue * (value[3] - value[0]);
  Vector4 q = Vector4::Zero();
  for (int j = 0; j < 4; ++j)
    if (value[j] >= threshold) q += eigen.eigenvectors()(0, j) * eigen.eigenvectors().col(j);
  // Rotations by π are all equally far from the identity: return any.
  if (q.norm() < 1e-12) q = eigen.eigenvectors().col(3);
  q.normalize();
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
}

}  // namespace

Pose free_optimum(const LegArray<Vector3>& p_BF, const LegArray<Vector3>& p_BC,
                  LegSet legs) noexcept {
  const LegSet counted = legs & LegSet::all(p_BF.size());
  if (counted.empty()) return {};
  const Vector3 p_mean = mean(p_BF, counted), c_mean = mean(p_BC, counted);
  Matrix3 S = Matrix3::Zero();
  for (LegId leg = 0; leg < p_BF.size(); ++leg)
    if (counted.contains(leg)) S += (p_BC[leg] - c_mean) * (p_BF[leg] - p_mean).transpose();
  const Matrix3 R = best_rotation(quadratic_form(S));
  return {R, p_mean - R * c_mean};
}

}  // namespace hexagait::posture

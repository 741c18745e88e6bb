// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/math/geometry.hpp>
#include <hexagait/math/leg.hpp>

namespace hexagait::posture {

/// The body pose, free in all six directions, that brings the feet nearest to their workspace
/// centres: the pose X_BD of the desired body frame D in the present one that minimises
///
///     E = Σᵢ ‖X_BD⁻¹ pᵢ − cᵢ‖² = Σᵢ ‖pᵢ − X_BD cᵢ‖²
///
/// i.e. the rigid registration of the centres to the feet. [PC04] finds it by descending the six
/// gradients of (7); this is the closed form of Horn (1987): with p′, c′ relative to their means,
/// the rotation is the quaternion that maximises Σ p′ᵢ · R c′ᵢ, a quadratic form, hence the
/// eigenvector of the largest eigenvalue of a symmetric 4×4 matrix. Always a rotation, never a
/// reflection.
///
/// If the feet do not determine the rotation (all on one line, or fewer than three), the smallest
/// optimal one is returned; the identity if `legs` is empty.
///
/// Meant for resolving a deadlock, in which no leg may step and the body cannot advance along the
/// path.
///
/// @param p_BF  feet [m]
/// @param p_BC  workspace centres [m]
/// @param legs  legs that count
[[nodiscard]] Pose free_optimum(const LegArray<Vector3>& p_BF, const LegArray<Vector3>& p_BC,
                                LegSet legs) noexcept;

}  // namespace hexagait::posture

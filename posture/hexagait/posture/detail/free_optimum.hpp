// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/math/geometry.hpp>
#include <hexagait/math/leg.hpp>

namespace hexagait::posture {

/// The body pose, free in all six directions, at which the feet are nearest to their workspace
/// centres: the pose X_BD of the desired body frame D in the present body frame B that minimises
///
///     E = Σᵢ ‖X_BD⁻¹ pᵢ − cᵢ‖² = Σᵢ ‖pᵢ − X_BD cᵢ‖²
///
/// i.e. the rigid registration of the centres to the feet. [PC04] descends the six gradients of (7)
/// to it; this is the closed form of Horn (1987): with p′, c′ taken from their means, the rotation
/// is the quaternion that maximises Σ p′ᵢ · R c′ᵢ, a quadratic form in it, so the eigenvector of
/// the largest eigenvalue of a symmetric 4×4 matrix. Always a rotation, never a reflection.
///
/// Where feet leave the rotation open (on one line, or fewer than three), it is the smallest of all
/// that are optimal. The identity if `legs` is empty.
///
/// It is the way out of a deadlock, where no leg may step and none can go on along the path; half a
/// microsecond or so, not for every tick.
///
/// @param p_BF  feet [m]
/// @param p_BC  workspace centres [m]
/// @param legs  those that count
[[nodiscard]] Pose free_optimum(const LegArray<Vector3>& p_BF, const LegArray<Vector3>& p_BC,
                                LegSet legs) noexcept;

}  // namespace hexagait::posture

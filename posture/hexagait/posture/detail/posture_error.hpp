// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/math/leg.hpp>
#include <hexagait/math/planar.hpp>

/// How far the body is from its best pose over given feet ([PC04] 4). Legs move best from the
/// middle of their workspaces, so the body should be where the feet are nearest to the workspace
/// centres. Feet pᵢ and workspace centres cᵢ are in the body frame [m]; both arrays have one entry
/// per leg.
namespace hexagait::posture {

/// The quadratic error of the present posture,
///
///     E = Σᵢ ‖pᵢ − cᵢ‖²    [m²]                                                   [PC04] (6)
[[nodiscard]] double quadratic_error(const LegArray<Vector3>& p_BF,
                                     const LegArray<Vector3>& p_BC) noexcept;

/// Derivatives of E at the present posture with respect to the displacement of the *feet*
///
///     qᵢ = Tz(z) Ty(y) Tx(x) Rz(yaw) Ry(pitch) Rx(roll) pᵢ                         [PC04] (5)
///
/// in the body frame. The body moves the other way: displacing it along −gradient increases E.
struct PostureGradient {
  double x = 0.0, y = 0.0, z = 0.0;           ///< [m]
  double roll = 0.0, pitch = 0.0, yaw = 0.0;  ///< [m²/rad]
};

/// The six gradients of [PC04] (7), as printed: 2 Σ (p − c) and 2 Σ c × p, over all legs. Meant for
/// resolving a deadlock, where the body must leave its path. For walking use advance_gradient() and
/// PlaneFit: roll and pitch here also respond to feet that lag along the path.
[[nodiscard]] PostureGradient gradient(const LegArray<Vector3>& p_BF,
                                       const LegArray<Vector3>& p_BC) noexcept;

/// The gradient restricted to an arc of radius r [m] and crab angle α [rad], [PC04] (9) as printed:
///
///     ∂E/∂γ = 2 r cos α Σ(p_x − c_x) + 2 r sin α Σ(p_y − c_y) + 2 Σ(c_x p_y − c_y p_x)
///
/// γ turns the *feet* by M(γ), as in [PC04] (8); the body advances by −γ. Singular for r = ±∞.
/// @returns [m²/rad]
[[nodiscard]] double arc_gradient(const LegArray<Vector3>& p_BF, const LegArray<Vector3>& p_BC,
                                  double r, double alpha) noexcept;

/// The same for any path and for the *body's* advance s along it: with t(p) = v + w z × p the
/// motion of the body's point p per metre, feet move by ∂p/∂s = −t(p), and
///
///     ∂E/∂s = 2 Σᵢ t(cᵢ) · (cᵢ − pᵢ)    (= −w ∂E/∂γ of (9))
///
/// (t(c) and t(p) give the same sum: they differ by w z × (c − p), which is normal to c − p.) It is
/// twice the summed lag, each leg weighted by the speed of its centre. Positive: feet lag, the body
/// is too far ahead. The walker sums over all legs, including airborne ones, which make the body
/// advance although only support legs move with it.
/// @param per_metre  twist of the body per metre of path (heading_control's PathArc::per_metre)
/// @returns [m]
[[nodiscard]] double advance_gradient(const LegArray<Vector3>& p_BF, const LegArray<Vector3>& p_BC,
                                      const PlanarTwist& per_metre) noexcept;

/// Curvature of E along the path, for a Newton step −advance_gradient/advance_curvature:
///
///     H = 2 Σ_S ‖∂pᵢ/∂s‖² = 2 Σ_S ‖t(pᵢ)‖²
///
/// over the support legs S, which alone move. It is the Gauss-Newton part, never negative; the
/// exact derivative of advance_gradient() is 2 Σ_S t(pᵢ)·t(cᵢ), which is equal when the feet are at
/// their centres or the path is straight. arc_optimum() has the exact zero without iteration.
/// @returns dimensionless; 0 without support legs
[[nodiscard]] double advance_curvature(const LegArray<Vector3>& p_BF, LegSet support,
                                       const PlanarTwist& per_metre) noexcept;

}  // namespace hexagait::posture

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/math/leg.hpp>
#include <hexagait/math/planar.hpp>

namespace hexagait::posture {

/// The best position of the body on its path, for given feet.
struct ArcOptimum {
  enum class Status {
    found,        ///< the gradient vanishes there
    clamped,      ///< the gradient vanishes nowhere; there it is smallest
    unsupported,  ///< no support leg, or none that moves as the body advances: advance = 0
  };
  double advance = 0.0;  ///< s* [m of path]
  Status status = Status::unsupported;
};

/// The advance of the body at which the gradient along the path ([PC04] (9), advance_gradient()),
/// summed over *all* legs, vanishes when the support legs S keep their footholds and the airborne
/// legs A stay where they are in the body frame. [PC04] 4 descends the gradient; this is its zero.
///
/// Derivation. Let t(p) = v + w z × p and θ = w s. Advancing by s takes a support foot to
/// p − t(p) sin θ / w + z × t(p) (1 − cos θ) / w, so half the gradient becomes
///
///     f(s) = L_S + L_A + D sin θ / w − w L_S (1 − cos θ) / w,
///     L = Σ t(c)·(c − p),    D = Σ_S t(p)·t(c)
///
/// (since t(c) · z × t(p) = w t(c)·(c − p)). With q = tan(θ/2) / w this is a quadratic in q; its
/// root nearest to 0, which is the minimum of E, is
///
///     q = −(L_S + L_A) / (D + √Δ),    Δ = D² + w² (L_S² − L_A²),    s* = 2 atan(w q) / w
///
/// It holds for all w without division by w or cancellation. For w = 0 it is the mean, s* = −Σ_all
/// lag / n_support. In angles about the turning centre, with a = p − o, b = c − o, it turns the
/// feet by
///
///     γ = −θ = atan2(Σ_S a×b, Σ_S a·b) + asin(Σ_A a×b / hypot(Σ_S a×b, Σ_S a·b))
///
/// Δ < 0 means an argument of the arcsine beyond ±1; then the θ with the least |f| is returned.
///
/// Accuracy: relative error below 1e-13, except for Δ ≪ D² (feet some 90° about o from their
/// centres), where it approaches that of a double root, 1e-8.
///
/// @param p_BF       feet, all legs [m]
/// @param p_BC       workspace centres [m]
/// @param support    legs that keep their footholds; all others count as airborne
/// @param per_metre  twist of the body per metre of path
[[nodiscard]] ArcOptimum arc_optimum(const LegArray<Vector3>& p_BF, const LegArray<Vector3>& p_BC,
                                     LegSet support, const PlanarTwist& per_metre) noexcept;

}  // namespace hexagait::posture

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/math/geometry.hpp>
#include <hexagait/math/leg.hpp>

namespace hexagait::posture {

/// The displacement of the *body*, in its own frame, that makes it parallel to the ground under its
/// feet and brings it to its nominal height. 0 in directions that the feet do not determine.
struct PlaneFit {
  double height = 0.0;  ///< upwards [m]
  double roll = 0.0;    ///< about x; positive: left side up [rad]
  double pitch = 0.0;   ///< about y; positive: nose down [rad]
  int rank = 0;         ///< number of directions that the feet determine
};

/// Minimises the vertical part of the posture error,
///
///     E_z = Σᵢ (q_z,i − c_z,i)²
///
/// When the body rises by h and turns by (φ, θ) about (x, y), a foot on the ground moves in the
/// body frame, to first order, by
///
///     δp_z = −h − φ p_y + θ p_x
///
/// So E_z is minimal for (φ, θ) = (b, −a) if z = h + a x + b y is the least-squares plane through
/// the height errors (p_x, p_y, p_z − c_z). For centres of equal height it is the plane through the
/// footprints, wherever in their workspaces the feet stand. The remaining error is of second order
/// in the angles.
///
/// Deviation: [PC04] sets the full gradients ∂E/∂ψ and ∂E/∂θ of (7) to 0, whose terms c_z p_x and
/// c_z p_y respond to feet that merely lag along the path, and tilt the body as it walks. We keep
/// only the z terms. gradient() has the printed form.
///
/// Feet on a line (all on one side, or only two) do not determine the slope across it, which is
/// then 0, as is the slope of a single foot. Feet count as on a line if their spread across it is
/// less than 1/100 of that along it.
///
/// @param p_BF  feet [m]; for an airborne leg, its last footprint
/// @param p_BC  workspace centres [m]; only their heights are read
/// @param legs  legs that count
[[nodiscard]] PlaneFit plane_fit(const LegArray<Vector3>& p_BF, const LegArray<Vector3>& p_BC,
                                 LegSet legs) noexcept;

}  // namespace hexagait::posture

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/math/geometry.hpp>
#include <hexagait/math/leg.hpp>

namespace hexagait::posture {

/// How the body is to move to be parallel to the ground under its feet, at its nominal height.
/// Motions of the *body*, in its own frame, signs of REP-103; 0 in directions the feet leave open.
struct PlaneFit {
  double height = 0.0;  ///< up [m]
  double roll = 0.0;    ///< about x, left side up [rad]
  double pitch = 0.0;   ///< about y, nose down [rad]
  int rank = 0;         ///< how many of the three the feet determine
};

/// The part of the posture error that height, roll and pitch are for: heights alone,
///
///     E_z = Σᵢ (q_z,i − c_z,i)²
///
/// When the body moves up by h and turns by (φ, θ) about (x, y), a foot that stays on the ground
/// moves in the body frame, to first order, by
///
///     δp_z = −h − φ p_y + θ p_x
///
/// So E_z is least where z = h + a x + b y with (φ, θ) = (b, −a) is the least-squares plane through
/// the height errors (p_x, p_y, p_z − c_z). For centres of equal height it is the plane through the
/// footprints itself, exactly, wherever in their workspaces the feet stand. What is left after the
/// body has moved by it is of second order in the angles.
///
/// Deviation: [PC04] nulls the full gradients ∂E/∂ψ and ∂E/∂θ of (7), whose terms c_z p_x and c_z
/// p_y answer to feet that merely lag along the path, and tilt the body as it walks. These are the
/// z terms of it alone. gradient() has the printed form.
///
/// Feet on a line (all on one side, or two) say nothing of the slope across it: that slope is left
/// at 0, as is all slope for a single foot. On a line means spread across it by less than 1/100 of
/// the spread along it.
///
/// @param p_BF  feet [m]; for an airborne leg its last footprint, carried along
/// @param p_BC  workspace centres [m]; only their heights are read
/// @param legs  those that count
[[nodiscard]] PlaneFit plane_fit(const LegArray<Vector3>& p_BF, const LegArray<Vector3>& p_BC,
                                 LegSet legs) noexcept;

}  // namespace hexagait::posture

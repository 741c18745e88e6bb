// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/math/geometry.hpp>
#include <hexagait/math/leg.hpp>

namespace hexagait {

/// How the supporting feet share the robot's weight: the vertical forces that minimise the weighted
/// sum of squares
///
///     min Σ F_i² / w_i   subject to   Σ F_i = W,  Σ F_i p_i = W p_M        (in the plane)
///
/// whose solution is F_i = w_i (a + b x_i + c y_i). With w_i ramping from 0 to 1 as a leg is
/// loaded, the forces change without a jump. They are fed forward to the joints, so that the servos
/// need no deflection to carry the robot ("gravity compensation", [FG16] IV).
///
/// @param p_F     feet, in a frame with vertical z [m]; z is not used
/// @param p_M     centre of mass, same frame [m]
/// @param load    w_i in [0, 1]: fraction of its load that each leg carries, 0 for a leg in the air
/// @param weight  W = m g [N]
/// @returns F_i ≥ 0 [N]; if the centre of mass is outside the support polygon, or fewer than three
///          feet carry load, negative forces are set to 0 and the rest scaled to sum to W
[[nodiscard]] LegArray<double> shared_load(const LegArray<Vector3>& p_F, const Vector3& p_M,
                                           const LegArray<double>& load, double weight) noexcept;

}  // namespace hexagait

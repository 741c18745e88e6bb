// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/math/geometry.hpp>
#include <hexagait/math/leg.hpp>

namespace hexagait::posture {

/// Displacement of all workspace centres in the body frame that leaves the centre of mass, seen along gravity,
/// where it is over the feet of a level robot. A body parallel to a slope has its centre of mass downhill of
/// that place: the robot leans uphill.
///
///     l = −H/u_z (u_x, u_y),   |l| ≤ most                                            (posture 7)
///
/// with `up` u in the body frame and the height H of the centre of mass over the centres. It also keeps the
/// posture stable: the feet of a body that tilts back seem to be farther behind in the body frame, for which
/// (posture 4) alone would take the body back, and the centre of mass farther still.
/// @param p_BC  workspace centres, body frame [m]
/// @param p_BM  centre of mass, body frame [m]
/// @param up_B  unit vector against gravity, body frame
/// @param most  ≥ 0 [m]
[[nodiscard]] Vector2 lean(const LegArray<Vector3>& p_BC, const Vector3& p_BM, const Vector3& up_B,
                           double most) noexcept;

}  // namespace hexagait::posture

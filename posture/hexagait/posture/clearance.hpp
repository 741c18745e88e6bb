// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/math/leg.hpp>
#include <hexagait/posture/plane_fit.hpp>

namespace hexagait::posture {

/// How much higher than (posture 5) the body should be, so that uneven ground does not touch it: half of how
/// far the highest known ground is above the plane, at most a third of the stance's height,
///
///     z = min(H/3, ½ maxᵢ (gᵢ_z − cᵢ_z − h − ψ gᵢ_y + θ gᵢ_x))                          (posture 6)
///
/// with the plane (h, ψ, θ), the workspace centres c and the mean depth H of c below the body's origin. The
/// other half is left to the reach of the legs that stand low.
/// @param ground_BF  highest ground that each leg knows of, body frame [m]
/// @param p_BC       workspace centres, body frame [m]
/// @returns [m], ≥ 0; on a plane 0
[[nodiscard]] double clearance(const LegArray<Vector3>& ground_BF, const LegArray<Vector3>& p_BC,
                               const PlaneFit& plane, LegSet legs) noexcept;

}  // namespace hexagait::posture

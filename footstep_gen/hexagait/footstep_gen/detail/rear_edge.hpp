// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/heading_control/path_arc.hpp>

namespace hexagait::footstep_gen {

/// The ring edge (gait 1) between the two rear legs of a heading: of all pairs of neighbours, the
/// one whose workspace centres are farthest against the motion,
///
///     score = −v · (c_a + c_b) / 2
///
/// with v the velocity of the body's origin per metre of path. In a spin v is 0 and no leg is at
/// the rear; the edge then stays unchanged. Hysteresis: another pair takes over only when it is
/// farther behind by 5 % of the distance of the farthest centre, so that the edge does not flicker
/// at a heading half-way between two pairs (crabbing at 90°).
///
/// @param present  the previous edge, 0 … n − 1
[[nodiscard]] int rear_edge(const heading_control::PathArc& arc, int present) noexcept;

}  // namespace hexagait::footstep_gen

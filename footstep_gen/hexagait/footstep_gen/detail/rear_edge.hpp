// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/heading_control/path_arc.hpp>

namespace hexagait::footstep_gen {

/// The ring edge (gait 1) between the two legs that are the rear ones for a heading: of all pairs
/// of neighbours the one whose workspace centres lie farthest against the motion,
///
///     score = −v · (c_a + c_b) / 2
///
/// v the velocity of the body's origin per metre of path. v fades to 0 on a spin, where no leg is
/// behind: the pair then stays as it was. Hysteresis: another pair takes over only when it is
/// farther behind by 5 % of the farthest centre's distance, so that a direction half-way between
/// two pairs (crabbing at 90°) lets neither flicker.
///
/// @param present  the edge that was chosen before; 0 … n − 1
[[nodiscard]] int rear_edge(const heading_control::PathArc& arc, int present) noexcept;

}  // namespace hexagait::footstep_gen

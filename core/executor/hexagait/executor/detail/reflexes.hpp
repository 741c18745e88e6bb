// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/executor/leg_lane.hpp>

/// How a try of a step ends that met something in its way, or no ground, and where the next one goes. The
/// set point lets go of what blocks the foot: it would push with more than 1 kN and roll the body.
namespace hexagait {

/// No further try is higher or nearer: what the foot meets now is its ground.
[[nodiscard]] bool gives_up(const LegLane& lane, const SwingParams& params) noexcept;

/// Moves back, away from the foothold, and up. The next try is higher and, after two, shorter; after the last of
/// SwingParams::max_retreats the foot goes back to where it stood, and if it finds no ground there either, it
/// searches, (swing 5).
void retreat(LegLane& lane, const LegSensed& sensed, const Pose& X_OB,
             const SwingParams& params) noexcept;

/// The same, and the next try is nearer at once.
void retreat_closer(LegLane& lane, const LegSensed& sensed, const Pose& X_OB,
                    const SwingParams& params) noexcept;

/// May what a foot on its way down touches be the wall of a hole, (step 12)?
[[nodiscard]] bool may_be_wall(const LegLane& lane, const LegSensed& sensed, const Pose& X_OB,
                               const SwingParams& params) noexcept;

/// Does a foot on its way down touch an edge, from which it would slide off, (step 11)?
[[nodiscard]] bool is_edge(const LegLane& lane, const LegSensed& sensed, const Pose& X_OB) noexcept;

/// The next try is nearer; where a hole is known the edge is its own, and counts as no ground.
void leave_edge(LegLane& lane, const LegSensed& sensed, const Pose& X_OB,
                const SwingParams& params) noexcept;

/// There is no ground within reach: straight up again, so that the foot meets no wall of the hole. Where it
/// tries next, who commands the footsteps knows best.
void climb_out(LegLane& lane, const LegSensed& sensed, const Pose& X_OB) noexcept;

}  // namespace hexagait

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/heading_control/path_arc.hpp>
#include <hexagait/math/planar.hpp>

namespace hexagait::heading_control {

/// A velocity command as path and speed limit. The gait decides the speed (the body follows the
/// legs), so a commanded velocity can only be an upper limit.
struct HeadingCommand {
  Heading heading = Heading::stop();
  double speed_limit = 0.0;  ///< [m/s of path], at the farthest workspace centre
};

/// The heading of a planar velocity (vx, vy, wz) of the body, in the body frame:
///
///     o = (−vy, vx) / wz,    speed_limit = maxᵢ |v + w z × cᵢ|
///
/// @param twist  [m/s], [rad/s]
/// @param last   the previous heading, whose path a stop keeps
/// @returns `last` stopped, with speed limit 0, if the twist is zero or not finite
[[nodiscard]] HeadingCommand from_twist(const PlanarTwist& twist, const Stance& stance,
                                        const Heading& last = Heading::stop()) noexcept;

/// The velocity of a body that follows the arc at `path_speed` [m/s of path]; zero if stopped.
/// Inverse of from_twist().
[[nodiscard]] PlanarTwist to_twist(const PathArc& arc, double path_speed) noexcept;

}  // namespace hexagait::heading_control

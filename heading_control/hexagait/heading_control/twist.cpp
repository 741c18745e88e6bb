// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/heading_control/twist.hpp>

namespace hexagait::heading_control {

HeadingCommand from_twist(const PlanarTwist& twist, const Stance& stance,
                          const Heading& last) noexcept {
  const Heading heading = Heading::along(twist.v, twist.w);
  if (!heading.moving()) return {last.stopped(), 0.0};
  double speed = 0.0;
  for (const Vector3& c : stance.p_BC)
    speed = std::max(speed, (twist.v + twist.w * perpendicular(c.head<2>())).norm());
  return {heading, speed};
}

PlanarTwist to_twist(const PathArc& arc, double path_speed) noexcept {
  if (!arc.heading.moving()) return {};
  return {path_speed * arc.per_metre.v, path_speed * arc.per_metre.w};
}

}  // namespace hexagait::heading_control

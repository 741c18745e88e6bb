// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <hexagait/math/geometry.hpp>
#include <hexagait/math/leg.hpp>
#include <span>

namespace hexagait {

/// The convex hull of the feet that carry the robot, seen along gravity.
struct SupportPolygon {
  std::array<Vector2, kMaxLegs>
      vertices;  ///< counter-clockwise, none on the line of its neighbours [m]
  int size = 0;  ///< of vertices; 0 no point, 1 a point, 2 a segment
};

/// Hull of up to kMaxLegs points [m], by Andrew's monotone chain.
/// Duplicates and points within 1 nm of an edge are dropped, so a hull of three vertices or more
/// has an inside; three feet in a row on each side of the body are the usual case.
[[nodiscard]] SupportPolygon support_polygon(std::span<const Vector2> points) noexcept;

/// Hull of the feet in `support`, from x and y of their positions in a frame whose z is vertical
/// [m].
[[nodiscard]] SupportPolygon support_polygon(const LegArray<Vector3>& feet,
                                             LegSet support) noexcept;

/// Distance from `point` to the nearest edge [m]: positive inside the polygon, negative outside.
/// With `point` the centre of mass it is the static stability margin; the robot stands if it is
/// positive. A segment or a point has no inside: minus the distance to it. −∞ for no vertices.
[[nodiscard]] double stability_margin(const SupportPolygon& polygon, const Vector2& point) noexcept;

}  // namespace hexagait

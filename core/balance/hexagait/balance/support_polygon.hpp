// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <hexagait/math/geometry.hpp>
#include <hexagait/math/leg.hpp>
#include <span>

namespace hexagait {

/// The convex hull of the supporting feet, projected along gravity.
struct SupportPolygon {
  std::array<Vector2, kMaxLegs> vertices;  ///< counter-clockwise, no three on a line [m]
  int size = 0;                            ///< number of vertices; 1: a point, 2: a segment
};

struct PolygonEdge {
  Vector2 from;     ///< [m]
  Vector2 inwards;  ///< unit normal
};

/// The edge from vertex k to the next.
[[nodiscard]] PolygonEdge edge_of(const SupportPolygon& polygon, int k) noexcept;

/// The edge that `point` is farthest beyond, or, inside, nearest to; of a segment its side towards the point.
/// @pre  two vertices or more
[[nodiscard]] PolygonEdge nearest_edge(const SupportPolygon& polygon,
                                       const Vector2& point) noexcept;

/// Hull of up to kMaxLegs points [m], by Andrew's monotone chain. Duplicates and points within 1 nm
/// of an edge are dropped, so that a hull of three or more vertices has an interior. (Three feet in
/// a row on each side of the body are the usual case.)
[[nodiscard]] SupportPolygon support_polygon(std::span<const Vector2> points) noexcept;

/// Hull of the feet in `support`.
/// @param feet  in a frame with vertical z [m]; z is not used
[[nodiscard]] SupportPolygon support_polygon(const LegArray<Vector3>& feet,
                                             LegSet support) noexcept;

/// Distance from `point` to the nearest edge [m]: positive inside the polygon, negative outside.
/// For the centre of mass this is the static stability margin: the robot stands if it is positive.
/// For a segment or a point, minus the distance to it; without vertices, −∞.
[[nodiscard]] double stability_margin(const SupportPolygon& polygon, const Vector2& point) noexcept;

}  // namespace hexagait

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/balance/support_polygon.hpp>

namespace hexagait {

/// The points p of the plane with normalᵀ p ≤ bound.
struct HalfPlane {
  Vector2 normal = Vector2::UnitX();  ///< unit vector
  double bound = 0.0;                 ///< [m]
};

/// Where the centre of mass may be: the support polygon with every edge moved inwards by a margin.
struct StableRegion {
  SupportPolygon polygon;
  std::array<HalfPlane, kMaxLegs> edges;  ///< after the move
  int size = 0;                           ///< number of edges; 0 without support: anywhere
  double margin = 0.0;                    ///< actual margin [m]
  bool shrunk = false;                    ///< it is smaller than requested
};

/// Radius of the largest circle inscribed in a polygon [m]. By duality it is the minimum of
///
///     λ_i b_i + λ_j b_j + λ_k b_k   over triples with   λ ≥ 0, Σλ = 1, Σ λ n = 0     (region 1)
///
/// @pre region.size >= 3, and the edges enclose a bounded area
[[nodiscard]] double inscribed_radius(const StableRegion& region) noexcept;

/// The region of a polygon with a margin [m]. If the polygon is too small for it, the margin is
/// reduced to the inscribed radius less a micrometre. A segment or a point has margin 0.
[[nodiscard]] StableRegion stable_region(const SupportPolygon& polygon, double margin) noexcept;

}  // namespace hexagait

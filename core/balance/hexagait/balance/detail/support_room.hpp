// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/balance/support_polygon.hpp>

namespace hexagait {

/// normalᵀ p ≤ bound in the plane; the normal has length 1.
struct HalfPlane {
  Vector2 normal = Vector2::UnitX();
  double bound = 0.0;  ///< [m]
};

/// Where the centre of mass may be: the support polygon with every edge moved inwards.
struct SupportRoom {
  SupportPolygon polygon;
  std::array<HalfPlane, kMaxLegs> edges;  ///< moved already
  int size = 0;                           ///< of edges; 0 if nothing supports: anywhere
  double margin = 0.0;                    ///< by which they are moved [m]
  bool shrunk = false;                    ///< that is less than was asked for
};

/// Radius of the largest circle within the edges of a polygon [m]. By duality it is the least of
///
///     λ_i b_i + λ_j b_j + λ_k b_k   over triples with   λ ≥ 0, Σλ = 1, Σ λ n = 0     (room 1)
///
/// @pre room.size >= 3 edges that enclose a bounded area
[[nodiscard]] double inscribed_radius(const SupportRoom& room) noexcept;

/// The room that a polygon leaves at a margin [m]; where it has none, as large a margin as it has,
/// less a micrometre. Of a segment or a point: itself, margin 0.
[[nodiscard]] SupportRoom support_room(const SupportPolygon& polygon, double margin) noexcept;

}  // namespace hexagait

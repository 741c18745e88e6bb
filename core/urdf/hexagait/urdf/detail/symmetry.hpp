// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/math/geometry.hpp>
#include <vector>

namespace hexagait {

/// A vertical plane in which hips mirror each other.
struct Symmetry {
  double front = 0.0;   ///< direction of the plane, in (−π/2, π/2] from x [rad]
  double offset = 0.0;  ///< of the plane from the origin, to its left [m]
  /// Of each hip the one that it is mirrored to; −1: none, or it lies in the plane.
  std::vector<int> partner;
  [[nodiscard]] int num_paired() const;
};

/// The plane that pairs most of the hips, to 5 % of their layout's radius. Of several the one along
/// which the layout is longest, of about equals (10 %) the nearest to x.
[[nodiscard]] Symmetry find_symmetry(const std::vector<Vector2>& hips);

/// The symmetry about a plane along a given direction, wherever it pairs most.
[[nodiscard]] Symmetry symmetry_along(const std::vector<Vector2>& hips, double front);

/// Largest distance of a hip from the mean of all [m].
[[nodiscard]] double layout_radius(const std::vector<Vector2>& hips);

}  // namespace hexagait

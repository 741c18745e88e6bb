// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/balance/detail/stable_region.hpp>
#include <limits>

namespace hexagait {
namespace {

constexpr double kInside = 1e-6;  // size of the region left by the largest margin [m]

// A segment, or a point, as two opposite pairs of half-planes: across it and along it.
void add_segment(StableRegion& region) {
  const Vector2& a = region.polygon.vertices[0];
  const Vector2& b = region.polygon.vertices[static_cast<std::size_t>(region.polygon.size - 1)];
  const Vector2 along =
      region.polygon.size == 2 ? Vector2((b - a).normalized()) : Vector2(1.0, 0.0);
  const Vector2 across = perpendicular(along);
  region.edges[0] = {across, across.dot(a)};
  region.edges[1] = {-across, -across.dot(a)};
  region.edges[2] = {along, along.dot(b)};
  region.edges[3] = {-along, -along.dot(a)};
  region.size = 4;
}

}  // namespace

double inscribed_radius(const StableRegion& region) noexcept {
  double radius = std::numeric_limits<double>::infinity();
  for (int i = 0; i < region.size; ++i) {
    for (int j = i + 1; j < region.size; ++j) {
      for (int k = j + 1; k < region.size; ++k) {
        const HalfPlane& a = region.edges[static_cast<std::size_t>(i)];
        const HalfPlane& b = region.edges[static_cast<std::size_t>(j)];
        const HalfPlane& c = region.edges[static_cast<std::size_t>(k)];
        // Edges are counter-clockwise: λ ≥ 0 if the three normals positively span the plane.
        const double la = cross(b.normal, c.normal), lb = cross(c.normal, a.normal),
                     lc = cross(a.normal, b.normal);
        if (la < 0.0 || lb < 0.0 || lc < 0.0 || la + lb + lc <= 0.0) continue;
        radius = std::min(radius, (la * a.bound + lb * b.bound + lc * c.bound) / (la + lb + lc));
      }
    }
  }
  return std::max(radius, 0.0);
}

StableRegion stable_region(const SupportPolygon& polygon, double margin) noexcept {
  StableRegion region{.polygon = polygon, .edges = {}, .margin = margin};
  if (polygon.size < 3) {
    region.margin = 0.0;
    region.shrunk = polygon.size == 0 || margin > 0.0;
    if (polygon.size > 0) add_segment(region);
    return region;
  }
  region.size = polygon.size;
  for (int i = 0; i < region.size; ++i) {
    const Vector2& from = polygon.vertices[static_cast<std::size_t>(i)];
    const Vector2& to = polygon.vertices[static_cast<std::size_t>((i + 1) % region.size)];
    const Vector2 normal = -perpendicular((to - from).normalized());
    region.edges[static_cast<std::size_t>(i)] = {normal, normal.dot(from)};
  }
  const double radius = inscribed_radius(region),
               largest = radius - std::min(kInside, 0.5 * radius);
  region.shrunk = margin > largest;
  region.margin = std::min(margin, largest);
  for (int i = 0; i < region.size; ++i)
    region.edges[static_cast<std::size_t>(i)].bound -= region.margin;
  return region;
}

}  // namespace hexagait

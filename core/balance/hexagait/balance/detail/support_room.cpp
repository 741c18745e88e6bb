// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/balance/detail/support_room.hpp>
#include <limits>

namespace hexagait {
namespace {

constexpr double kInside = 1e-6;  // what is kept of the room when the margin takes it all [m]

// A segment, or a point, as two opposite pairs of half-planes: across it and along it.
void add_segment(SupportRoom& room) {
  const Vector2& a = room.polygon.vertices[0];
  const Vector2& b = room.polygon.vertices[static_cast<std::size_t>(room.polygon.size - 1)];
  const Vector2 along = room.polygon.size == 2 ? Vector2((b - a).normalized()) : Vector2(1.0, 0.0);
  const Vector2 across = perpendicular(along);
  room.edges[0] = {across, across.dot(a)};
  room.edges[1] = {-across, -across.dot(a)};
  room.edges[2] = {along, along.dot(b)};
  room.edges[3] = {-along, -along.dot(a)};
  room.size = 4;
}

}  // namespace

double inscribed_radius(const SupportRoom& room) noexcept {
  double radius = std::numeric_limits<double>::infinity();
  for (int i = 0; i < room.size; ++i) {
    for (int j = i + 1; j < room.size; ++j) {
      for (int k = j + 1; k < room.size; ++k) {
        const HalfPlane& a = room.edges[static_cast<std::size_t>(i)];
        const HalfPlane& b = room.edges[static_cast<std::size_t>(j)];
        const HalfPlane& c = room.edges[static_cast<std::size_t>(k)];
        // Edges are counter-clockwise: all λ of one sign means that the normals go around.
        const double la = cross(b.normal, c.normal), lb = cross(c.normal, a.normal),
                     lc = cross(a.normal, b.normal);
        if (la < 0.0 || lb < 0.0 || lc < 0.0 || la + lb + lc <= 0.0) continue;
        radius = std::min(radius, (la * a.bound + lb * b.bound + lc * c.bound) / (la + lb + lc));
      }
    }
  }
  return std::max(radius, 0.0);
}

SupportRoom support_room(const SupportPolygon& polygon, double margin) noexcept {
  SupportRoom room{.polygon = polygon, .edges = {}, .margin = margin};
  if (polygon.size < 3) {
    room.margin = 0.0;
    room.shrunk = polygon.size == 0 || margin > 0.0;
    if (polygon.size > 0) add_segment(room);
    return room;
  }
  room.size = polygon.size;
  for (int i = 0; i < room.size; ++i) {
    const Vector2& from = polygon.vertices[static_cast<std::size_t>(i)];
    const Vector2& to = polygon.vertices[static_cast<std::size_t>((i + 1) % room.size)];
    const Vector2 normal = -perpendicular((to - from).normalized());
    room.edges[static_cast<std::size_t>(i)] = {normal, normal.dot(from)};
  }
  const double radius = inscribed_radius(room), largest = radius - std::min(kInside, 0.5 * radius);
  room.shrunk = margin > largest;
  room.margin = std::min(margin, largest);
  for (int i = 0; i < room.size; ++i) room.edges[static_cast<std::size_t>(i)].bound -= room.margin;
  return room;
}

}  // namespace hexagait

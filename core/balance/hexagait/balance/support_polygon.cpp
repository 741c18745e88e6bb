// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/balance/support_polygon.hpp>
#include <limits>

namespace hexagait {
namespace {

constexpr double kSamePlace = 1e-9;  // [m]

double squared_distance_to_segment(const Vector2& point, const Vector2& a, const Vector2& b) {
  const Vector2 edge = b - a;
  const double length2 = edge.squaredNorm();
  const double along = length2 > 0.0 ? std::clamp(edge.dot(point - a) / length2, 0.0, 1.0) : 0.0;
  return (point - a - along * edge).squaredNorm();
}

bool is_left_turn(const Vector2& a, const Vector2& b, const Vector2& c) {
  return cross(b - a, c - b) > 0.0;
}

bool is_before(const Vector2& a, const Vector2& b) {
  return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
}

// Removes the vertices at the end of the chain from `first` that `next` would make concave.
void retract(SupportPolygon& hull, int first, const Vector2& next) {
  const auto last = [&](int back) {
    return hull.vertices[static_cast<std::size_t>(hull.size - back)];
  };
  while (hull.size >= first + 2 && !is_left_turn(last(2), last(1), next)) --hull.size;
}

void extend(SupportPolygon& hull, int first, const Vector2& next) {
  retract(hull, first, next);
  hull.vertices[static_cast<std::size_t>(hull.size++)] = next;
}

// Drops one vertex that lies on the segment between its neighbours; false if there is none.
bool drop_superfluous(SupportPolygon& hull) {
  for (int i = 0; hull.size > 1 && i < hull.size; ++i) {
    const auto at = [&](int j) { return hull.vertices[static_cast<std::size_t>(j)]; };
    const double distance2 = squared_distance_to_segment(at(i), at(i > 0 ? i - 1 : hull.size - 1),
                                                         at(i + 1 < hull.size ? i + 1 : 0));
    if (distance2 > kSamePlace * kSamePlace) continue;
    auto* const begin = hull.vertices.data();
    std::move(begin + i + 1, begin + hull.size, begin + i);
    --hull.size;
    return true;
  }
  return false;
}

}  // namespace

PolygonEdge edge_of(const SupportPolygon& polygon, int k) noexcept {
  const Vector2& from = polygon.vertices[static_cast<std::size_t>(k)];
  const int next = k + 1 < polygon.size ? k + 1 : 0;
  const Vector2& to = polygon.vertices[static_cast<std::size_t>(next)];
  return {from, perpendicular(to - from).normalized()};
}

PolygonEdge nearest_edge(const SupportPolygon& polygon, const Vector2& point) noexcept {
  const auto inside = [&point](const PolygonEdge& edge) {
    return edge.inwards.dot(point - edge.from);
  };
  PolygonEdge nearest = edge_of(polygon, 0);
  for (int k = 1; k < polygon.size; ++k)
    if (const PolygonEdge edge = edge_of(polygon, k); inside(edge) < inside(nearest))
      nearest = edge;
  return nearest;
}

SupportPolygon support_polygon(std::span<const Vector2> points) noexcept {
  assert(points.size() <= kMaxLegs);
  SupportPolygon hull;
  if (points.empty()) return hull;
  std::array<Vector2, kMaxLegs> sorted;
  const auto begin = sorted.begin();
  auto end = begin;
  for (const Vector2& point : points) {
    const auto place = std::upper_bound(begin, end, point, is_before);
    std::move_backward(place, end, end + 1);
    *place = point;
    ++end;
  }

  // The lower chain from left to right, then the upper one back to where the lower one starts.
  for (auto p = begin; p != end; ++p) extend(hull, 0, *p);
  const int rightmost = hull.size - 1;
  for (auto p = end - 1; p - begin > 1; --p) extend(hull, rightmost, *(p - 1));
  retract(hull, rightmost, *begin);
  while (drop_superfluous(hull)) {
  }
  return hull;
}

SupportPolygon support_polygon(const LegArray<Vector3>& feet, LegSet support) noexcept {
  std::array<Vector2, kMaxLegs> points;
  std::size_t n = 0;
  for (LegId leg = 0; leg < feet.size(); ++leg)
    if (support.contains(leg)) points[n++] = feet[leg].head<2>();
  return support_polygon(std::span<const Vector2>(points.data(), n));
}

double stability_margin(const SupportPolygon& polygon, const Vector2& point) noexcept {
  double distance2 = std::numeric_limits<double>::infinity();
  bool inside = polygon.size >= 3;
  for (int i = 0; i < polygon.size; ++i) {
    const Vector2& a = polygon.vertices[static_cast<std::size_t>(i)];
    const Vector2& b = polygon.vertices[static_cast<std::size_t>((i + 1) % polygon.size)];
    distance2 = std::min(distance2, squared_distance_to_segment(point, a, b));
    inside = inside && cross(b - a, point - a) >= 0.0;
  }
  return inside ? std::sqrt(distance2) : -std::sqrt(distance2);
}

}  // namespace hexagait

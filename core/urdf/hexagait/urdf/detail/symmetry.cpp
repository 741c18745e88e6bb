// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/math/trigonometry.hpp>
#include <hexagait/urdf/detail/symmetry.hpp>

namespace hexagait {
namespace {

constexpr double kMirrored = 0.05;   // how far off, of the layout's radius
constexpr double kAsLong = 1.1;      // ratios of length to width that count as equal
constexpr double kSameAngle = 1e-3;  // [rad]

/// Partners by a plane along `front` whose points are at `offset` to the left.
Symmetry symmetry_about(const std::vector<Vector2>& hips, double front, double offset,
                        double tolerance) {
  const Vector2 left = perpendicular(unit_vector(front));
  Symmetry symmetry{front, offset, std::vector<int>(hips.size(), -1)};
  for (std::size_t i = 0; i < hips.size(); ++i) {
    const double side = left.dot(hips[i]) - offset;
    if (symmetry.partner[i] >= 0 || std::abs(side) < tolerance) continue;
    const Vector2 image = hips[i] - 2.0 * side * left;
    double nearest = tolerance;
    for (std::size_t j = 0; j < hips.size(); ++j) {
      if (j == i || symmetry.partner[j] >= 0 || !((hips[j] - image).norm() < nearest)) continue;
      nearest = (hips[j] - image).norm();
      symmetry.partner[i] = static_cast<int>(j);
    }
    if (symmetry.partner[i] >= 0)
      symmetry.partner[static_cast<std::size_t>(symmetry.partner[i])] = static_cast<int>(i);
  }
  return symmetry;
}

/// Extent of the paired hips along the plane over that across it.
double slenderness(const std::vector<Vector2>& hips, const Symmetry& symmetry) {
  const Vector2 along = unit_vector(symmetry.front), across = perpendicular(along);
  Vector2 least = Vector2::Constant(1e300), greatest = -least;
  for (std::size_t i = 0; i < hips.size(); ++i) {
    if (symmetry.partner[i] < 0) continue;
    const Vector2 p(along.dot(hips[i]), across.dot(hips[i]));
    least = least.cwiseMin(p);
    greatest = greatest.cwiseMax(p);
  }
  const Vector2 extent = greatest - least;
  return extent.y() > 0.0 ? extent.x() / extent.y() : 0.0;
}

/// Does `a` make a better front than `b`?
bool is_better(const std::vector<Vector2>& hips, const Symmetry& a, const Symmetry& b) {
  if (a.num_paired() != b.num_paired()) return a.num_paired() > b.num_paired();
  const double long_a = slenderness(hips, a), long_b = slenderness(hips, b);
  if (long_a > kAsLong * long_b) return true;
  if (long_b > kAsLong * long_a) return false;
  const double off_a = std::abs(a.front), off_b = std::abs(b.front);
  return std::abs(off_a - off_b) > kSameAngle ? off_a < off_b : a.front > b.front + kSameAngle;
}

/// Into (−π/2, π/2], and to whole fractions of a right angle where only rounding keeps it from them.
double as_direction(double angle) {
  angle = std::remainder(angle, std::numbers::pi);
  if (angle <= -0.5 * std::numbers::pi + kSameAngle) angle += std::numbers::pi;
  return std::abs(angle) < kSameAngle ? 0.0 : angle;
}

}  // namespace

int Symmetry::num_paired() const {
  return static_cast<int>(std::ranges::count_if(partner, [](int i) { return i >= 0; }));
}

double layout_radius(const std::vector<Vector2>& hips) {
  Vector2 middle = Vector2::Zero();
  for (const Vector2& hip : hips) middle += hip / static_cast<double>(hips.size());
  double radius = 0.0;
  for (const Vector2& hip : hips) radius = std::max(radius, (hip - middle).norm());
  return radius;
}

Symmetry find_symmetry(const std::vector<Vector2>& hips) {
  const double tolerance = kMirrored * layout_radius(hips);
  Symmetry best{0.0, 0.0, std::vector<int>(hips.size(), -1)};
  for (std::size_t i = 0; i < hips.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Vector2 apart = hips[i] - hips[j], middle = 0.5 * (hips[i] + hips[j]);
      if (!(apart.norm() > 2.0 * tolerance)) continue;
      const double front =
          as_direction(portable::atan2(apart.y(), apart.x()) - 0.5 * std::numbers::pi);
      const double offset = perpendicular(unit_vector(front)).dot(middle);
      const Symmetry found = symmetry_about(hips, front, offset, tolerance);
      if (is_better(hips, found, best)) best = found;
    }
  return best;
}

Symmetry symmetry_along(const std::vector<Vector2>& hips, double front) {
  const double tolerance = kMirrored * layout_radius(hips);
  const Vector2 left = perpendicular(unit_vector(front));
  Symmetry best{front, 0.0, std::vector<int>(hips.size(), -1)};
  for (std::size_t i = 0; i < hips.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Symmetry found =
          symmetry_about(hips, front, 0.5 * left.dot(hips[i] + hips[j]), tolerance);
      if (found.num_paired() > best.num_paired()) best = found;
    }
  return best;
}

}  // namespace hexagait

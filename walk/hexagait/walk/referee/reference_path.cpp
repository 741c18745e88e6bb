// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <hexagait/math/trigonometry.hpp>
#include <hexagait/walk/referee/reference_path.hpp>

namespace hexagait::walk {
namespace {

// Below this curvature an arc is a line: they differ by less than 1 µm in 40 m [1/m].
constexpr double kStraight = 1e-9;

}  // namespace

void ReferencePath::follow(const heading_control::Heading& heading) {
  // The ideal heading of a turn in place is the base's heading at its end.
  const bool was_spinning = moving_ && std::isinf(curvature_);
  start_ = ideal_;
  if (was_spinning) start_.angle = last_.angle;
  ideal_ = start_;
  moving_ = heading.moving();
  curvature_ = heading.rho() > 0.0
                   ? heading.curvature()
                   : std::copysign(std::numeric_limits<double>::infinity(), heading.k());
  crab_ = heading.crab_angle();
  angle_ = 0.0;
}

ReferencePath::Deviation ReferencePath::deviation(const PlanarPose& X_WB) {
  last_ = X_WB;
  const Vector2 from_start = X_WB.shift - start_.shift;
  const double turned = wrap_angle(X_WB.angle - start_.angle);
  if (!moving_ || std::isinf(curvature_)) {
    const double heading = moving_ ? 0.0 : turned;
    return {from_start.norm(), heading, 0.0, turned};
  }

  const double direction = start_.angle + crab_;
  if (std::abs(curvature_) < kStraight) {
    const double progress = from_start.dot(unit_vector(direction));
    ideal_ = {start_.angle, start_.shift + progress * unit_vector(direction)};
    return {cross(unit_vector(direction), from_start), turned, progress, turned};
  }

  // A circle about a centre to the left (curvature > 0) or right of the direction of motion.
  const double radius = 1.0 / curvature_;
  const Vector2 centre = start_.shift + radius * perpendicular(unit_vector(direction));
  const Vector2 arm = X_WB.shift - centre;
  const double side = std::copysign(1.0, radius);
  const double at = angle_of(arm);
  const double angle = at - (direction - side * std::numbers::pi / 2.0);
  angle_ += wrap_angle(angle - angle_);
  ideal_ = {start_.angle + angle_, centre + std::abs(radius) * unit_vector(at)};
  return {side * (std::abs(radius) - arm.norm()), wrap_angle(X_WB.angle - ideal_.angle),
          side * angle_ * std::abs(radius), turned};
}

}  // namespace hexagait::walk

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/heading_control/path_tracker.hpp>
#include <hexagait/math/trigonometry.hpp>

namespace hexagait::heading_control {
double PathTracker::product(const PlanarTwist& a, const PlanarTwist& b) const noexcept {
  return a.v.dot(b.v) + turn_arm_ * turn_arm_ * a.w * b.w;
}

void PathTracker::reset(const PlanarPose& X_OB) {
  *this = PathTracker(turn_arm_);
  anchor_ = ideal_ = X_OB;
}

void PathTracker::follow(const PlanarTwist& per_metre) {
  anchor_ = ideal_;
  per_metre_ = per_metre;
  s_ = 0.0;
}

PlanarTwist PathTracker::update(const PlanarPose& X_OB) noexcept {
  // One Newton step along the curve is enough: the base moves by less than a millimetre per update.
  PlanarPose ahead = between(ideal_, X_OB);
  ahead.angle = wrap_angle(ahead.angle);
  const double norm = product(per_metre_, per_metre_);
  if (norm > 0.0) s_ += product(per_metre_, logarithm(ahead)) / norm;
  ideal_ = anchor_ * exponential(per_metre_, s_);

  PlanarPose back = between(X_OB, ideal_);
  back.angle = wrap_angle(back.angle);
  return logarithm(back);
}

PlanarTwist by_turning(const PlanarTwist& correction, const PlanarTwist& per_metre,
                       double arm) noexcept {
  const double way = per_metre.v.norm();
  if (!(way > 0.0)) return {Vector2::Zero(), correction.w};
  const Vector2 ahead = per_metre.v / way;
  const double left = cross(ahead, correction.v);
  return {ahead.dot(correction.v) * ahead, correction.w + portable::atan2(left, arm)};
}

}  // namespace hexagait::heading_control

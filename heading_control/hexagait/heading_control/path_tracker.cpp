// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/heading_control/path_tracker.hpp>

namespace hexagait::heading_control {
namespace {

// L² of the metric [m²]: about the square of the distance from the base to its feet, so that an
// angle counts as much as the motion of the feet that it causes.
constexpr double kTurnWeight = 0.25;

double product(const PlanarTwist& a, const PlanarTwist& b) {
  return a.v.dot(b.v) + kTurnWeight * a.w * b.w;
}

}  // namespace

void PathTracker::reset(const PlanarPose& X_OB) {
  *this = PathTracker{};
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

}  // namespace hexagait::heading_control

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/heading_control/path_tracker.hpp>

namespace hexagait::heading_control {
namespace {

// L² of the metric: how much a radian of heading counts against a metre [m²]. About the square of
// the distance from the base to its feet, so that a radian is what the feet see of it.
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
  // One Newton step along the curve: exact to second order, and the base moves by less than a
  // millimetre from one update to the next.
  PlanarPose ahead = ideal_.inverse() * X_OB;
  ahead.angle = wrap_angle(ahead.angle);
  const double norm = product(per_metre_, per_metre_);
  if (norm > 0.0) s_ += product(per_metre_, logarithm(ahead)) / norm;
  ideal_ = anchor_ * exponential(per_metre_, s_);

  PlanarPose back = X_OB.inverse() * ideal_;
  back.angle = wrap_angle(back.angle);
  return logarithm(back);
}

}  // namespace hexagait::heading_control

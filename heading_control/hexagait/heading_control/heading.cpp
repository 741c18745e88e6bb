// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <hexagait/heading_control/heading.hpp>
#include <hexagait/math/trigonometry.hpp>
#include <limits>
#include <stdexcept>
#include <string>

namespace hexagait::heading_control {
namespace {

void require_finite_crab_angle(double alpha) {
  if (std::isfinite(alpha)) return;
  throw std::invalid_argument("heading: crab angle must be finite [rad], is " +
                              std::to_string(alpha));
}

}  // namespace

Heading Heading::straight(double alpha) {
  return arc(std::numeric_limits<double>::infinity(), alpha);
}

Heading Heading::arc(double r, double alpha) {
  require_finite_crab_angle(alpha);
  if (std::isnan(r)) throw std::invalid_argument("heading: radius must be a number [m], is nan");
  if (r == 0.0)
    throw std::invalid_argument(
        "heading: radius 0 does not say which way to turn; use spin ccw or spin cw");
  if (std::isinf(r)) return {1.0, 0.0, wrap_angle(alpha)};
  const double size = portable::hypot(r, 1.0);
  return {std::abs(r) / size, std::copysign(1.0, r) / size, wrap_angle(alpha)};
}

Heading Heading::spin(Turn turn) noexcept { return {0.0, turn == Turn::ccw ? 1.0 : -1.0, 0.0}; }

Heading Heading::along(const Vector2& v, double w) noexcept {
  const double speed = portable::hypot(v.x(), v.y());
  const double size = portable::hypot(speed, w);
  if (!std::isfinite(size) || size == 0.0) return stop();
  if (speed == 0.0) return spin(w > 0.0 ? Turn::ccw : Turn::cw);
  return {speed / size, w / size, angle_of(v)};
}

Heading Heading::stopped() const noexcept {
  Heading heading = *this;
  heading.moving_ = false;
  return heading;
}

double Heading::radius() const noexcept {
  if (rho_ == 0.0) return 0.0;
  return k_ == 0.0 ? std::numeric_limits<double>::infinity() : rho_ / k_;
}

}  // namespace hexagait::heading_control

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/math/planar.hpp>
#include <hexagait/math/trigonometry.hpp>

namespace hexagait {
namespace {

// sin(x)/x and (1 − cos x)/x, by the half angle: nothing cancels.
struct Sincs {
  double s, c;
};
Sincs sincs(double x) {
  if (x == 0.0) return {1.0, 0.0};
  const double half = 0.5 * x;
  const auto [s, c] = portable::sincos(half);
  return {s / half * c, s / half * s};
}

}  // namespace

PlanarPose exponential(const PlanarTwist& twist, double s) {
  const double angle = twist.w * s;
  const Sincs sinc = sincs(angle);
  return {angle, s * (sinc.s * twist.v + sinc.c * perpendicular(twist.v))};
}

Vector2 carried(const Vector2& p, const PlanarTwist& twist, double s) {
  const Vector2 v = twist.v + twist.w * perpendicular(p);
  const Sincs sinc = sincs(twist.w * s);
  return p + s * (sinc.s * v + sinc.c * perpendicular(v));
}

PlanarTwist logarithm(const PlanarPose& pose) {
  const Sincs sinc = sincs(pose.angle);
  const double scale = 1.0 / (sinc.s * sinc.s + sinc.c * sinc.c);
  return {scale * (sinc.s * pose.shift - sinc.c * perpendicular(pose.shift)), pose.angle};
}

}  // namespace hexagait

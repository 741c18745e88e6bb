// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/math/planar.hpp>
#include <hexagait/math/trigonometry.hpp>

namespace hexagait {
namespace {

// sin(x)/x and (1 − cos x)/x. Below 1e-4 the series are accurate to 1e-17.
double sinc(double x) { return std::abs(x) < 1e-4 ? 1.0 - x * x / 6.0 : portable::sin(x) / x; }
double cosc(double x) {
  const double half = portable::sin(0.5 * x);
  return std::abs(x) < 1e-4 ? 0.5 * x * (1.0 - x * x / 12.0) : 2.0 * half * half / x;
}

}  // namespace

PlanarPose exponential(const PlanarTwist& twist, double s) {
  const double angle = twist.w * s;
  const double a = s * sinc(angle), b = s * cosc(angle);
  return {angle, a * twist.v + b * perpendicular(twist.v)};
}

PlanarTwist logarithm(const PlanarPose& pose) {
  const double a = sinc(pose.angle), b = cosc(pose.angle);
  const double scale = 1.0 / (a * a + b * b);
  return {scale * (a * pose.shift - b * perpendicular(pose.shift)), pose.angle};
}

}  // namespace hexagait

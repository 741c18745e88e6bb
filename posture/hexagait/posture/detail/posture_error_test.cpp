// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <functional>
#include <hexagait/posture/detail/posture_error.hpp>
#include <hexagait/sim/random.hpp>
#include <testing/random_feet.hpp>

namespace hexagait::posture {
namespace {

using Eigen::AngleAxisd;
using Eigen::Translation3d;
using testing::centres;
using Transform = Eigen::Isometry3d;

// Feet anywhere within 20 cm of their centres.
LegArray<Vector3> random_feet(RandomSequence& random) { return testing::random_feet(random, 0.2); }

LegArray<Vector3> moved(const Transform& X, LegArray<Vector3> p_BF) {
  for (Vector3& p : p_BF) p = X * p;
  return p_BF;
}

// [PC04] (5), from Eigen's own turns and shifts.
Transform printed_transform(double x, double y, double z, double roll, double pitch, double yaw) {
  return Translation3d(0, 0, z) * Translation3d(0, y, 0) * Translation3d(x, 0, 0) *
         AngleAxisd(yaw, Vector3::UnitZ()) * AngleAxisd(pitch, Vector3::UnitY()) *
         AngleAxisd(roll, Vector3::UnitX());
}

// [PC04] (4).
Transform printed_arc(double r, double alpha, double gamma) {
  return AngleAxisd(alpha, Vector3::UnitZ()) * Translation3d(0, r, 0) *
         AngleAxisd(gamma, Vector3::UnitZ()) * Translation3d(0, -r, 0) *
         AngleAxisd(-alpha, Vector3::UnitZ());
}

// Central difference of E along a one-parameter family of transforms of the feet. Third derivatives
// of E are below 10 r, rounding below 1e-15 / h: with h = 1e-5 the error is below 1e-8.
double slope_of_error(const LegArray<Vector3>& p_BF,
                      const std::function<Transform(double)>& transform) {
  constexpr double h = 1e-5;
  return (quadratic_error(moved(transform(h), p_BF), centres()) -
          quadratic_error(moved(transform(-h), p_BF), centres())) /
         (2.0 * h);
}
constexpr double kDifference = 1e-8;

TEST(QuadraticError, IsTheSumOfSquaredDistances) {
  LegArray<Vector3> p_BF = centres();
  EXPECT_EQ(quadratic_error(p_BF, centres()), 0.0);
  p_BF[1] += Vector3(0.3, 0.0, 0.4);
  p_BF[4] += Vector3(0.0, -0.1, 0.0);
  EXPECT_NEAR(quadratic_error(p_BF, centres()), 0.25 + 0.01, 1e-15);
}

TEST(Gradient, IsTheSlopeOfTheErrorUnderThePrintedTransform) {
  RandomSequence random{.seed = 1};
  for (int k = 0; k < 300; ++k) {
    const LegArray<Vector3> p = random_feet(random);
    const PostureGradient g = gradient(p, centres());
    const auto along = [&](int i) {
      return slope_of_error(p, [i](double h) {
        return printed_transform(i == 0 ? h : 0, i == 1 ? h : 0, i == 2 ? h : 0, i == 3 ? h : 0,
                                 i == 4 ? h : 0, i == 5 ? h : 0);
      });
    };
    EXPECT_NEAR(g.x, along(0), kDifference);
    EXPECT_NEAR(g.y, along(1), kDifference);
    EXPECT_NEAR(g.z, along(2), kDifference);
    EXPECT_NEAR(g.roll, along(3), kDifference);
    EXPECT_NEAR(g.pitch, along(4), kDifference);
    EXPECT_NEAR(g.yaw, along(5), kDifference);
  }
}

TEST(ArcGradient, IsTheSlopeOfTheErrorUnderThePrintedArc) {
  RandomSequence random{.seed = 2};
  for (int k = 0; k < 300; ++k) {
    const LegArray<Vector3> p = random_feet(random);
    const double r = random.uniform(-3, 3), alpha = random.uniform(-4, 4);
    const double slope =
        slope_of_error(p, [&](double gamma) { return printed_arc(r, alpha, gamma); });
    EXPECT_NEAR(arc_gradient(p, centres(), r, alpha), slope, 3 * kDifference);
  }
}

PlanarTwist random_twist(RandomSequence& random) {
  return {{random.uniform(-1, 1), random.uniform(-1, 1)}, random.uniform(-2, 2)};
}

Transform body_motion(const PlanarTwist& twist, double s) {
  const PlanarPose X = exponential(twist, s);
  return Translation3d(X.shift.x(), X.shift.y(), 0) * AngleAxisd(X.angle, Vector3::UnitZ());
}

// The body advances by s: feet on the ground go by the inverse.
TEST(AdvanceGradient, IsTheSlopeOfTheErrorAsTheBodyAdvances) {
  RandomSequence random{.seed = 3};
  for (int k = 0; k < 300; ++k) {
    const LegArray<Vector3> p = random_feet(random);
    PlanarTwist twist = random_twist(random);
    if (k % 3 == 0) twist.w = 0.0;
    const double slope =
        slope_of_error(p, [&](double s) -> Transform { return body_motion(twist, s).inverse(); });
    EXPECT_NEAR(advance_gradient(p, centres(), twist), slope, kDifference);
  }
}

// γ turns the feet, s moves the body, and the body turns by w s: ∂E/∂s = −w ∂E/∂γ.
TEST(AdvanceGradient, IsThePrintedOneWithTheOtherSign) {
  RandomSequence random{.seed = 4};
  for (int k = 0; k < 300; ++k) {
    const LegArray<Vector3> p = random_feet(random);
    const double r = random.uniform(-3, 3), alpha = random.uniform(-4, 4),
                 w = random.uniform(-2, 2);
    const PlanarTwist twist{w * r * Vector2(std::cos(alpha), std::sin(alpha)), w};
    EXPECT_NEAR(advance_gradient(p, centres(), twist), -w * arc_gradient(p, centres(), r, alpha),
                1e-14);
  }
}

// Feet all 1 cm behind on a straight line: ∂E/∂s = 2 · 6 · 0.01, the body is too far ahead.
TEST(AdvanceGradient, IsPositiveWhenFeetLag) {
  LegArray<Vector3> p = centres();
  for (Vector3& foot : p) foot.x() -= 0.01;
  EXPECT_NEAR(advance_gradient(p, centres(), {{1.0, 0.0}, 0.0}), 0.12, 1e-15);
}

// On a straight line a support foot moves 1 m per metre: H = 2 n_S, and it is the derivative of the
// gradient when all legs support.
TEST(AdvanceCurvature, CountsTheSupportLegsOnAStraightLine) {
  const PlanarTwist twist{{0.6, 0.8}, 0.0};
  EXPECT_NEAR(advance_curvature(centres(), LegSet(0b110110), twist), 8.0, 1e-14);
  EXPECT_EQ(advance_curvature(centres(), LegSet(), twist), 0.0);
}

// With all feet at their centres H is the second derivative of E exactly.
TEST(AdvanceCurvature, IsTheSlopeOfTheGradientAtTheCentres) {
  RandomSequence random{.seed = 5};
  for (int k = 0; k < 300; ++k) {
    const PlanarTwist twist = random_twist(random);
    const double h = 1e-5;
    const auto at = [&](double s) {
      return advance_gradient(moved(body_motion(twist, s).inverse(), centres()), centres(), twist);
    };
    EXPECT_NEAR(advance_curvature(centres(), LegSet::all(6), twist), (at(h) - at(-h)) / (2 * h),
                kDifference);
  }
}

// Seen in axes turned by β, x and y (and roll and pitch) turn as vectors; z and yaw stay.
TEST(Gradient, TurnsWithTheAxes) {
  RandomSequence random{.seed = 6};
  for (int k = 0; k < 100; ++k) {
    const Transform R(AngleAxisd(random.uniform(-3, 3), Vector3::UnitZ()));
    const LegArray<Vector3> p = random_feet(random);
    const PostureGradient a = gradient(p, centres());
    const PostureGradient b = gradient(moved(R, p), moved(R, centres()));
    EXPECT_NEAR((Vector3(b.x, b.y, b.z) - R * Vector3(a.x, a.y, a.z)).norm(), 0.0, 1e-14);
    EXPECT_NEAR((Vector3(b.roll, b.pitch, b.yaw) - R * Vector3(a.roll, a.pitch, a.yaw)).norm(), 0.0,
                1e-14);
  }
}

}  // namespace
}  // namespace hexagait::posture

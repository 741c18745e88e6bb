// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/posture/arc_optimum.hpp>
#include <hexagait/posture/detail/posture_error.hpp>
#include <hexagait/sim/random.hpp>
#include <testing/random_feet.hpp>

namespace hexagait::posture::arc_optimum_test {
namespace {

using testing::centres;
using testing::random_feet;
using enum ArcOptimum::Status;
const LegSet kAll = LegSet::all(6);
const LegSet kTripod = LegSet(0b011001);

PlanarTwist random_twist(RandomSequence& random, double w) {
  const double alpha = random.uniform(-std::numbers::pi, std::numbers::pi),
               speed = random.uniform(0.5, 1.0);
  return {speed * Vector2(std::cos(alpha), std::sin(alpha)), w};
}
LegSet random_support(RandomSequence& random) {
  return LegSet(1U + static_cast<std::uint32_t>(random.uniform(0.0, 63.0)));
}

// Feet as seen after the body has advanced by s: support feet stand, airborne ones go with the
// body.
LegArray<Vector3> feet_after(LegArray<Vector3> p_BF, LegSet support, const PlanarTwist& twist,
                             double s) {
  const PlanarPose back = exponential(twist, s).inverse();
  for (LegId leg = 0; leg < p_BF.size(); ++leg)
    if (support.contains(leg)) p_BF[leg].head<2>() = back * Vector2(p_BF[leg].head<2>());
  return p_BF;
}
double gradient_after(const LegArray<Vector3>& p_BF, LegSet support, const PlanarTwist& twist,
                      double s) {
  return advance_gradient(feet_after(p_BF, support, twist, s), centres(), twist);
}

// The slice rule: straight on, the body advances by the sum of all leads over the number of support
// legs. A tripod in the air at +25 cm and one on the ground at its centres: 3 · 0.25 / 3.
TEST(ArcOptimum, IsTheMeanLeadOnAStraightLine) {
  LegArray<Vector3> p = centres();
  for (const LegId leg : {1, 2, 5}) p[leg].x() += 0.25;
  const ArcOptimum optimum = arc_optimum(p, centres(), kTripod, {{1.0, 0.0}, 0.0});
  EXPECT_NEAR(optimum.advance, 0.25, 1e-15);
  EXPECT_EQ(optimum.status, found);
  for (const LegId leg : {0, 3, 4}) p[leg].x() -= 0.1;
  EXPECT_NEAR(arc_optimum(p, centres(), kTripod, {{1.0, 0.0}, 0.0}).advance, 0.15, 1e-15);
}

// All feet turned by γ about o = (0, 2) stand exactly under a body that turns by γ.
TEST(ArcOptimum, FindsTheBodyThatAllFeetBelongTo) {
  const PlanarTwist twist{{2.0, 0.0}, 1.0};
  for (const double gamma : {0.3, -1.2, 3.0}) {
    LegArray<Vector3> p = centres();
    const PlanarPose X = exponential(twist, gamma);
    for (Vector3& foot : p) foot.head<2>() = X * Vector2(foot.head<2>());
    EXPECT_NEAR(arc_optimum(p, centres(), kAll, twist).advance, gamma, 1e-14);
  }
}

TEST(ArcOptimum, MakesTheGradientVanish) {
  RandomSequence random{.seed = 1};
  for (int k = 0; k < 3000; ++k) {
    const PlanarTwist twist = random_twist(random, random.uniform(-3.0, 3.0));
    const LegArray<Vector3> p = random_feet(random, 0.2);
    const LegSet support = random_support(random);
    const ArcOptimum optimum = arc_optimum(p, centres(), support, twist);
    if (optimum.status != found) continue;
    EXPECT_NEAR(gradient_after(p, support, twist, optimum.advance), 0.0, 2e-14);
    // Stable: further on the feet lag (positive), further back they lead.
    EXPECT_GT(gradient_after(p, support, twist, optimum.advance + 1e-6), 0.0);
    EXPECT_LT(gradient_after(p, support, twist, optimum.advance - 1e-6), 0.0);
  }
}

// Half the gradient in long double, feet moved by the exponential with series where w s is small;
// its zero by Newton's method from 0. Shares nothing with the closed form.
using Real = long double;
using Vector2l = Eigen::Vector2<Real>;
Vector2l turned90(const Vector2l& a) { return {-a.y(), a.x()}; }
struct Oracle {
  LegArray<Vector3> p, c;
  LegSet support;
  Vector2l v;
  Real w;

  Vector2l velocity(const Vector2l& at) const { return v + w * turned90(at); }
  Vector2l foot(LegId leg, Real s) const {
    const Vector2l p0 = p[leg].head<2>().cast<Real>();
    if (!support.contains(leg)) return p0;
    const Real x = w * s;
    const Real sinc = std::abs(x) < 1e-4L ? 1.0L - x * x / 6.0L : std::sin(x) / x;
    const Real cosc = std::abs(x) < 1e-4L ? x / 2.0L - x * x * x / 24.0L : (1.0L - std::cos(x)) / x;
    return p0 - s * sinc * velocity(p0) + s * cosc * turned90(velocity(p0));
  }
  Real zero() const {
    Real s = 0.0L;
    for (int i = 0; i < 20; ++i) {
      Real f = 0.0L, slope = 0.0L;
      for (LegId leg = 0; leg < 6; ++leg) {
        const Vector2l centre = c[leg].head<2>().cast<Real>(), q = foot(leg, s);
        f += velocity(centre).dot(centre - q);
        if (support.contains(leg)) slope += velocity(centre).dot(velocity(q));
      }
      s -= f / slope;
    }
    return s;
  }
};

TEST(ArcOptimum, IsAccurateForEveryCurvature) {
  RandomSequence random{.seed = 2};
  for (int k = 0; k < 1000; ++k) {
    const double w = (k % 2 == 0 ? 1.0 : -1.0) * std::pow(10.0, random.uniform(-12.0, 1.0));
    const PlanarTwist twist = random_twist(random, w);
    const LegArray<Vector3> p = random_feet(random, 0.05);
    const LegSet support = LegSet(random_support(random).bits() | kTripod.bits());
    const ArcOptimum optimum = arc_optimum(p, centres(), support, twist);
    ASSERT_EQ(optimum.status, found);
    const Real s = Oracle{p, centres(), support, twist.v.cast<Real>(), w}.zero();
    EXPECT_LE(std::abs(optimum.advance - s), 1e-15L + 1e-13L * std::abs(s)) << "w = " << w;
  }
}

// γ = atan2(Σ_S a×b, Σ_S a·b) + asin(Σ_A a×b / hypot(…)), a = p − o, b = c − o, turns the feet; the
// body advances by −γ. In long double, since it loses digits as o recedes: 1e-19 · (r / 1 cm)².
TEST(ArcOptimum, IsTheClosedFormInAnglesAboutTheTurningCentre) {
  RandomSequence random{.seed = 3};
  for (int k = 0; k < 2000; ++k) {
    const double w = (k % 2 == 0 ? 1.0 : -1.0) * random.uniform(0.05, 3.0);
    const PlanarTwist twist = random_twist(random, w);
    const LegArray<Vector3> p = random_feet(random, 0.1);
    const Vector2l o = turned90(twist.v.cast<Real>()) / Real(w);
    Real cross_S = 0.0L, dot_S = 0.0L, cross_A = 0.0L;
    for (LegId leg = 0; leg < 6; ++leg) {
      const Vector2l a = p[leg].head<2>().cast<Real>() - o,
                     b = centres()[leg].head<2>().cast<Real>() - o;
      const Real a_cross_b = a.x() * b.y() - a.y() * b.x();
      (kTripod.contains(leg) ? cross_S : cross_A) += a_cross_b;
      if (kTripod.contains(leg)) dot_S += a.dot(b);
    }
    const Real gamma = std::atan2(cross_S, dot_S) + std::asin(cross_A / std::hypot(cross_S, dot_S));
    const ArcOptimum optimum = arc_optimum(p, centres(), kTripod, twist);
    ASSERT_EQ(optimum.status, found);
    EXPECT_NEAR(optimum.advance, static_cast<double>(-gamma / w), 2e-13);
  }
}

// With all legs on the ground it is the least E on the whole circle, found by trying 2000 places:
// none is lower, and the best of them is within one spacing.
TEST(ArcOptimum, IsTheLeastErrorOnTheWholeCircleWhenAllLegsSupport) {
  RandomSequence random{.seed = 4};
  for (int k = 0; k < 12; ++k) {
    const double w = random.uniform(0.5, 3.0);
    const PlanarTwist twist = random_twist(random, k % 2 == 0 ? w : -w);
    // Also feet on the far side of the turning centre.
    const LegArray<Vector3> p = random_feet(random, k % 4 < 2 ? 0.2 : 3.0);
    const auto error = [&](double s) {
      return quadratic_error(feet_after(p, kAll, twist, s), centres());
    };
    const double spacing = 2.0 * std::numbers::pi / w / 2000,
                 s = arc_optimum(p, centres(), kAll, twist).advance;
    double best = 0.0;
    for (int i = -1000; i < 1000; ++i)
      if (error(i * spacing) < error(best)) best = i * spacing;
    EXPECT_LE(error(s), error(best) + 1e-12);
    EXPECT_LE(std::abs(wrap_angle((s - best) * w)), spacing * w);
  }
}

// [PC04]'s way: small steps down the gradient end at the same place.
TEST(ArcOptimum, IsWhereDescendingTheGradientEnds) {
  RandomSequence random{.seed = 5};
  for (int k = 0; k < 100; ++k) {
    const PlanarTwist twist = random_twist(random, random.uniform(-1.5, 1.5));
    const LegArray<Vector3> p = random_feet(random, 0.1);
    double s = 0.0;
    for (int i = 0; i < 400; ++i) {
      const LegArray<Vector3> now = feet_after(p, kTripod, twist, s);
      s -= 0.2 * advance_gradient(now, centres(), twist) / advance_curvature(now, kTripod, twist);
    }
    EXPECT_NEAR(arc_optimum(p, centres(), kTripod, twist).advance, s, 1e-13);
  }
}

// q = −L/(D + √Δ): from w = 0 to w, s* changes by (∂s/∂w) w; a sweep in steps of 1e-4 may not jump.
// Feet within 10 cm: lags, ∂D/∂w and so |∂s/∂w| are of the order of 0.1 m · 0.5 m; bound 1 m².
TEST(ArcOptimum, DoesNotJumpAsTheLineBecomesStraight) {
  RandomSequence random{.seed = 6};
  const LegArray<Vector3> p = random_feet(random, 0.1);
  const auto at = [&](double w) {
    return arc_optimum(p, centres(), kTripod, {{0.8, 0.6}, w}).advance;
  };
  for (int i = -3000; i < 3000; ++i) EXPECT_LE(std::abs(at((i + 1) * 1e-4) - at(i * 1e-4)), 1e-4);
  for (const double w : {1e-300, 1e-17, 1e-9}) {
    EXPECT_NEAR(at(w), at(0.0), w);
    EXPECT_NEAR(at(-w), at(0.0), w);
  }
}

TEST(ArcOptimum, IsUnsupportedInTheAir) {
  RandomSequence random{.seed = 7};
  const ArcOptimum optimum =
      arc_optimum(random_feet(random, 0.1), centres(), LegSet(), {{1, 0}, 0.3});
  EXPECT_EQ(optimum.status, unsupported);
  EXPECT_EQ(optimum.advance, 0.0);
}

// One support leg, its centre at the turning centre, can't move the body whatever it does.
TEST(ArcOptimum, IsUnsupportedWhenTheOnlySupportLegIsWhereTheBodyTurns) {
  LegArray<Vector3> c = centres(), p = centres();
  c[2] = {0.0, 0.0, -0.25};
  p[2] = {0.1, 0.0, -0.25};
  p[0].x() += 0.1;
  EXPECT_EQ(arc_optimum(p, c, LegSet(0b100), {{0, 0}, 1.0}).status, unsupported);
}

// Airborne feet pull by more than the support legs can answer: the place of least |gradient|, found
// by trying all of the circle.
TEST(ArcOptimum, IsTheLeastGradientWhereNoneVanishes) {
  RandomSequence random{.seed = 8};
  int clamped_cases = 0;
  for (int k = 0; k < 400; ++k) {
    const double w = (k % 2 == 0 ? 1.0 : -1.0) * random.uniform(2.0, 10.0);
    const PlanarTwist twist = random_twist(random, w);
    const LegArray<Vector3> p = random_feet(random, 0.5);
    const LegSet support(0b000001);
    const ArcOptimum optimum = arc_optimum(p, centres(), support, twist);
    if (optimum.status != clamped) continue;
    ++clamped_cases;
    const double least = std::abs(gradient_after(p, support, twist, optimum.advance));
    for (int i = 0; i < 300; ++i)
      EXPECT_GE(std::abs(gradient_after(p, support, twist, 2 * std::numbers::pi / w * i / 300)),
                least - 1e-13);
  }
  EXPECT_GT(clamped_cases, 20);
}

// No zero of the gradient is nearer: 200 places between −s* and s* all have the sign it has at 0.
TEST(ArcOptimum, IsTheNearestZero) {
  RandomSequence random{.seed = 9};
  for (int k = 0; k < 200; ++k) {
    const PlanarTwist twist = random_twist(random, random.uniform(-2.0, 2.0));
    const LegArray<Vector3> p = random_feet(random, 0.2);
    const ArcOptimum optimum = arc_optimum(p, centres(), kTripod, twist);
    ASSERT_EQ(optimum.status, found);
    for (int i = -99; i < 100; ++i) {
      const double s = 1e-2 * i * optimum.advance;
      EXPECT_LT(gradient_after(p, kTripod, twist, s) * optimum.advance, 0.0);
    }
  }
}

// The same line run backwards, or with path counted in other units, or seen in a mirror.
TEST(ArcOptimum, DoesNotDependOnHowTheLineIsDescribed) {
  RandomSequence random{.seed = 10};
  for (int k = 0; k < 500; ++k) {
    const PlanarTwist twist = random_twist(random, random.uniform(-1.5, 1.5));
    const LegArray<Vector3> p = random_feet(random, 0.15);
    const double s = arc_optimum(p, centres(), kTripod, twist).advance;
    EXPECT_NEAR(arc_optimum(p, centres(), kTripod, {-twist.v, -twist.w}).advance, -s, 1e-15);
    EXPECT_NEAR(arc_optimum(p, centres(), kTripod, {3.0 * twist.v, 3.0 * twist.w}).advance, s / 3.0,
                1e-14);
    LegArray<Vector3> p_mirror = p, c_mirror = centres();
    for (Vector3& foot : p_mirror) foot.y() = -foot.y();
    for (Vector3& centre : c_mirror) centre.y() = -centre.y();
    const PlanarTwist mirrored{{twist.v.x(), -twist.v.y()}, -twist.w};
    EXPECT_NEAR(arc_optimum(p_mirror, c_mirror, kTripod, mirrored).advance, s, 1e-15);
  }
}

}  // namespace
}  // namespace hexagait::posture::arc_optimum_test

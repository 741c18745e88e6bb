// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/heading_control/path_arc.hpp>
#include <hexagait/sim/random.hpp>

// What a heading does near its awkward radii, ±∞ and 0. Bounds are derived, not tuned; `kRounding`
// is added for arithmetic.
namespace hexagait::heading_control {
namespace {

constexpr double kRounding = 1e-15;

// Corners at (±0.4, ±0.3): the centres' greatest distance ℓ from the origin is 0.5 m.
constexpr double kL = 0.5;
Stance six_legs() {
  Stance w{LegArray<Vector3>(6), LegArray<double>(6, 0.2)};
  for (LegId leg = 0; leg < 6; ++leg)
    w.p_BC[leg] = {0.4 * (1 - leg / 2), leg % 2 == 0 ? 0.3 : -0.3, -0.25};
  return w;
}

double greatest_difference(const PathArc& a, const PathArc& b, double s) {
  double greatest = 0.0;
  for (LegId leg = 0; leg < 6; ++leg)
    greatest = std::max(greatest, (aep(a, leg, s) - aep(b, leg, s)).norm());
  return greatest;
}

// With κ = 1/r, m/ρ = max |κ c − u| is within |κ| ℓ of 1. The velocity of a centre after σ of path
// is R(wσ) (e + κ z × c) ρ/m, e the straight direction and w = κ ρ/m, so it differs from e by at
// most |κ| (2ℓ + σ) / (1 − |κ| ℓ). Integrated over s: |κ| s (2ℓ + s/2) / (1 − |κ| ℓ).
TEST(StraightLine, IsTheLimitOfLargeRadiiOnBothSides) {
  const double s = 0.3;
  RandomSequence random{.seed = 1};
  for (int k = 0; k < 400; ++k) {
    const double alpha = random.uniform(-std::numbers::pi, std::numbers::pi);
    const double curvature = (k % 2 == 0 ? 1.0 : -1.0) * std::pow(10.0, -0.04 * k);
    const double size = std::abs(curvature);
    const double bound = size * s * (2.0 * kL + s / 2.0) / (1.0 - size * kL);
    EXPECT_LE(greatest_difference(path_arc(Heading::arc(1.0 / curvature, alpha), six_legs()),
                                  path_arc(Heading::straight(alpha), six_legs()), s),
              bound + kRounding);
  }
}

// A sweep κ = −0.5 … 0.5 through 0. In the velocity R(wσ) (e + κ z × c) / μ, μ = m/ρ ≥ 1 since the
// centres are symmetric, ∂/∂κ of the vector is at most ℓ/μ, that of 1/μ adds at most ℓ/μ, and
// |∂w/∂κ| = |1 + κ e·(z × c)| / μ³ ≤ 1.25. So a step dκ moves no AEP by more than
// dκ · s (2ℓ + 1.25 s/2).
TEST(StraightLine, IsCrossedWithoutAJump) {
  const double s = 0.3, step = 1e-3;
  for (int i = -500; i < 500; ++i) {
    const PathArc a = path_arc(Heading::arc(1.0 / (i * step), 0.4), six_legs());
    const PathArc b = path_arc(Heading::arc(1.0 / ((i + 1) * step), 0.4), six_legs());
    EXPECT_LE(greatest_difference(a, b, s), step * s * (2.0 * kL + 1.25 * s / 2.0) + kRounding);
  }
}

// R = max |c − o| is within |r| of ℓ. A centre's velocity differs from the spin's by at most
// |c| |r| / (R ℓ) + |r| / R at the start, and by σ |r| / (R ℓ) more after σ, so its place after s
// by |r| s (2 + s / (2ℓ)) / (ℓ − |r|), whatever the crab angle.
TEST(Spin, IsTheOneSidedLimitOfSmallRadii) {
  const double s = 0.3;
  RandomSequence random{.seed = 2};
  for (int k = 0; k < 200; ++k) {
    const double alpha = random.uniform(-std::numbers::pi, std::numbers::pi);
    const double r = 0.1 * std::pow(10.0, -0.08 * k);
    const double bound = r * s * (2.0 + s / (2.0 * kL)) / (kL - r);
    EXPECT_LE(greatest_difference(path_arc(Heading::arc(r, alpha), six_legs()),
                                  path_arc(Heading::spin(Turn::ccw), six_legs()), s),
              bound + kRounding);
    EXPECT_LE(greatest_difference(path_arc(Heading::arc(-r, alpha), six_legs()),
                                  path_arc(Heading::spin(Turn::cw), six_legs()), s),
              bound + kRounding);
  }
}

// From straight on to the spin, all the way: no centre moves more than s, and everything is finite.
TEST(PathArc, IsFiniteForEveryRadius) {
  const double s = 0.2;
  for (int e = -300; e <= 300; ++e) {
    for (const double sign : {1.0, -1.0}) {
      const PathArc arc = path_arc(Heading::arc(sign * std::pow(10.0, e), 1.0), six_legs());
      EXPECT_NEAR(direction_at(arc, arc.p_BC[arc.farthest]).norm(), 1.0, kRounding);
      for (LegId leg = 0; leg < 6; ++leg) {
        EXPECT_LE((aep(arc, leg, s) - arc.p_BC[leg]).norm(), s + kRounding);
        EXPECT_TRUE(std::isfinite(lag(arc, leg, {0.1, 0.2, 0.0})));
      }
    }
  }
}

}  // namespace
}  // namespace hexagait::heading_control

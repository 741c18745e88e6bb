// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/heading_control/path_arc.hpp>
#include <hexagait/sim/random.hpp>

namespace hexagait::heading_control::lag_test {
namespace {

constexpr double kReach = 0.2;

Stance six_legs() {
  Stance w{LegArray<Vector3>(6), LegArray<double>(6, kReach)};
  for (LegId leg = 0; leg < 6; ++leg)
    w.p_BC[leg] = {0.4 * (1 - leg / 2), leg % 2 == 0 ? 0.3 : -0.3, -0.25};
  return w;
}

Vector3 anywhere_in_the_disc(RandomSequence& random, const Vector3& centre) {
  const double angle = random.uniform(-std::numbers::pi, std::numbers::pi),
               distance = kReach * std::sqrt(random.u01());
  return centre + distance * Vector3(std::cos(angle), std::sin(angle), random.uniform(-1, 1));
}

TEST(Lag, IsTheDistanceBehindTheCentreOnAStraightLine) {
  const PathArc arc = path_arc(Heading::straight(std::numbers::pi / 2), six_legs());
  EXPECT_NEAR(lag(arc, 0, arc.p_BC[0] - Vector3(0.0, 0.07, 0.0)), 0.07, 1e-15);
  EXPECT_NEAR(lag(arc, 5, arc.p_BC[5] + Vector3(0.5, 0.02, 0.3)), -0.02, 1e-15);
}

TEST(Lag, IsNegativeAtTheAepAndZeroAtTheCentre) {
  RandomSequence random{.seed = 1};
  for (int k = 0; k < 500; ++k) {
    const double r = (k % 2 == 0 ? 1.0 : -1.0) * std::pow(10.0, random.uniform(-2.0, 2.0));
    const PathArc arc =
        path_arc(Heading::arc(r, random.uniform(-std::numbers::pi, std::numbers::pi)), six_legs());
    for (LegId leg = 0; leg < 6; ++leg) {
      EXPECT_LT(lag(arc, leg, aep(arc, leg, 0.05)), 0.0);
      EXPECT_GT(lag(arc, leg, aep(arc, leg, -0.05)), 0.0);
      EXPECT_EQ(lag(arc, leg, arc.p_BC[leg]), 0.0);
    }
  }
}

// Feet left behind together by s all turned by γ = s/R. A foot is then |c − o| sin γ behind its
// centre along the tangent there, times R / |c − o|: the lag of every leg is R sin γ, wherever it
// is.
TEST(Lag, IsEqualForFeetThatWereLeftBehindTogether) {
  for (const double r : {0.9, -0.9, 3.0, -40.0}) {
    const PathArc arc = path_arc(Heading::arc(r, 0.3), six_legs());
    const double s = 0.1, R = 1.0 / std::abs(arc.per_metre.w);
    for (LegId leg = 0; leg < 6; ++leg)
      EXPECT_NEAR(lag(arc, leg, advance(arc, arc.p_BC[leg], -s)), R * std::sin(s / R), 1e-14);
  }
}

// [PC04]'s angle from a = p − o to b = c − o, times R. Its tangent is a × b / a·b, and the lag is
// R a × b / |b|²; a·b = |b|² (1 + ε) with |ε| ≤ |a − b| / |b|, a few per cent here. So they agree
// to a relative error of 2 |a − b| / |b|.
TEST(Lag, IsTheAngleOfThePaperForSmallOffsets) {
  RandomSequence random{.seed = 2};
  for (int k = 0; k < 500; ++k) {
    const double r = (k % 2 == 0 ? 1.0 : -1.0) * random.uniform(1.0, 5.0);
    const double alpha = random.uniform(-std::numbers::pi, std::numbers::pi);
    const PathArc arc = path_arc(Heading::arc(r, alpha), six_legs());
    const Vector2 o(-r * std::sin(alpha), r * std::cos(alpha));
    const LegId leg = k % 6;
    const Vector3 p =
        arc.p_BC[leg] + 0.01 * Vector3(random.uniform(-1, 1), random.uniform(-1, 1), 0);
    const Vector2 a = p.head<2>() - o, b = arc.p_BC[leg].head<2>() - o;
    const double angle = std::copysign(1.0, r) * std::atan2(cross(a, b), a.dot(b));
    const double paper = angle / std::abs(arc.per_metre.w);
    EXPECT_NEAR(lag(arc, leg, p), paper, 2.0 * std::abs(paper) * (a - b).norm() / b.norm() + 1e-15);
  }
}

// The turning centre sweeps from far left to far right through the workspaces, straight over some
// of the centres. |lag| ≤ ρ + L (path_arc.hpp), L the distance to the farthest centre.
TEST(Lag, IsBoundedAsTheTurningCentreSweepsThroughTheWorkspaces) {
  RandomSequence random{.seed = 3};
  const Stance w = six_legs();
  const double L = std::hypot(0.8, 0.6);
  for (const double alpha : {0.0, std::atan2(-0.4, 0.3), std::numbers::pi / 2, -2.0}) {
    for (int i = -3000; i <= 3000; ++i) {
      const double r = 1e-3 * i;
      const PathArc arc = path_arc(i == 0 ? Heading::spin(Turn::ccw) : Heading::arc(r, alpha), w);
      for (LegId leg = 0; leg < 6; ++leg) {
        const double delta = lag(arc, leg, anywhere_in_the_disc(random, w.p_BC[leg]));
        EXPECT_TRUE(std::isfinite(delta));
        EXPECT_LE(std::abs(delta), kReach + L);
      }
    }
  }
}

// Within the disc the scale is R/ρ: o = (0, 0.25) is 5 cm from the middle left centre, whose disc
// is 20 cm wide; R = √(0.4² + 0.55²). Forward there is −x (beyond o), so 3 cm ahead in x is 3 cm of
// lag.
TEST(Lag, HasAScaleOfAtMostTheRadiusRatioNearTheTurningCentre) {
  const PathArc arc = path_arc(Heading::arc(0.25, 0.0), six_legs());
  EXPECT_NEAR(arc.lag_scale[2], std::hypot(0.4, 0.55) / kReach, 1e-14);
  EXPECT_NEAR(lag(arc, 2, arc.p_BC[2] + Vector3(0.03, 0.0, 0.0)),
              0.03 * std::hypot(0.4, 0.55) / kReach, 1e-14);
}

TEST(Lag, IsZeroForALegAtTheTurningCentre) {
  Stance w = six_legs();
  w.p_BC[2] = {0.0, 0.0, -0.25};
  const PathArc arc = path_arc(Heading::spin(Turn::cw), w);
  EXPECT_EQ(lag(arc, 2, {0.1, 0.1, 0.0}), 0.0);
}

TEST(Lag, IsKeptByAStop) {
  const Heading heading = Heading::arc(-1.5, 0.2);
  const PathArc moving = path_arc(heading, six_legs());
  const PathArc stopped = path_arc(heading.stopped(), six_legs());
  for (LegId leg = 0; leg < 6; ++leg)
    EXPECT_EQ(lag(moving, leg, {0.1, 0.2, 0.0}), lag(stopped, leg, {0.1, 0.2, 0.0}));
}

// y → −y with (r, α) → (−r, −α), and R(β) with α + β, leave every lag as it is.
TEST(Lag, IsUnchangedByMirroringOrTurningTheWholeProblem) {
  RandomSequence random{.seed = 4};
  const Matrix3 mirror = Vector3(1.0, -1.0, 1.0).asDiagonal();
  for (int k = 0; k < 500; ++k) {
    const double r = (k % 2 == 0 ? 1.0 : -1.0) * std::pow(10.0, random.uniform(-2.0, 3.0));
    const double alpha = random.uniform(-std::numbers::pi, std::numbers::pi),
                 beta = random.uniform(-std::numbers::pi, std::numbers::pi);
    Stance mirrored = six_legs(), turned = six_legs();
    for (Vector3& c : mirrored.p_BC) c = mirror * c;
    for (Vector3& c : turned.p_BC) c = rotation_z(beta) * c;
    LegArray<Vector3> p = six_legs().p_BC, p_mirrored(6), p_turned(6);
    for (LegId leg = 0; leg < 6; ++leg) {
      p[leg] = anywhere_in_the_disc(random, p[leg]);
      p_mirrored[leg] = mirror * p[leg];
      p_turned[leg] = rotation_z(beta) * p[leg];
    }
    const auto reference = lags(path_arc(Heading::arc(r, alpha), six_legs()), p);
    const auto a = lags(path_arc(Heading::arc(-r, -alpha), mirrored), p_mirrored);
    const auto b = lags(path_arc(Heading::arc(r, alpha + beta), turned), p_turned);
    for (LegId leg = 0; leg < 6; ++leg) {
      EXPECT_NEAR(a[leg], reference[leg], 1e-14);
      EXPECT_NEAR(b[leg], reference[leg], 1e-12);
    }
  }
}

}  // namespace
}  // namespace hexagait::heading_control::lag_test

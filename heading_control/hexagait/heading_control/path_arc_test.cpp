// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/heading_control/path_arc.hpp>
#include <hexagait/sim/random.hpp>

namespace hexagait::heading_control::path_arc_test {
namespace {

// Six legs, two by two: x = 0.4, 0, −0.4; y = ±0.3.
Stance six_legs() {
  Stance w{LegArray<Vector3>(6), LegArray<double>(6, 0.2)};
  for (LegId leg = 0; leg < 6; ++leg)
    w.p_BC[leg] = {0.4 * (1 - leg / 2), leg % 2 == 0 ? 0.3 : -0.3, -0.25};
  return w;
}

Stance random_stance(RandomSequence& random, int n) {
  Stance w{LegArray<Vector3>(n), LegArray<double>(n)};
  for (LegId leg = 0; leg < n; ++leg) {
    w.p_BC[leg] = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 0)};
    w.radius[leg] = random.uniform(0.05, 0.3);
  }
  return w;
}

double random_radius(RandomSequence& random) {
  const double sign = random.u01() < 0.5 ? 1.0 : -1.0;
  return sign * std::pow(10.0, random.uniform(-3.0, 3.0));
}

void expect_near(const Vector3& a, const Vector3& b, double tolerance) {
  EXPECT_LE((a - b).norm(), tolerance) << a.transpose() << " and " << b.transpose();
}

// With crab angle 0 and r = 2 m the centre is (0, 2), on the left; the body's point there rests,
// and what is nearer to it moves slower. The origin moves ahead.
TEST(TurningCentre, IsOnTheLeftForPositiveRadius) {
  const PathArc arc = path_arc(Heading::arc(2.0, 0.0), six_legs());
  EXPECT_NEAR(direction_at(arc, {0.0, 2.0, 0.0}).norm(), 0.0, 1e-15);
  EXPECT_GT(arc.per_metre.w, 0.0);
  EXPECT_GT(direction_at(arc, Vector3::Zero()).x(), 0.0);
  EXPECT_LT(direction_at(arc, arc.p_BC[2]).norm(), direction_at(arc, arc.p_BC[3]).norm());
}

// o = r (−sin α, cos α) rests for every r and α, and γ has the sign of r.
TEST(TurningCentre, IsAtRest) {
  RandomSequence random{.seed = 1};
  for (int k = 0; k < 1000; ++k) {
    const double r = random_radius(random),
                 alpha = random.uniform(-std::numbers::pi, std::numbers::pi);
    const PathArc arc = path_arc(Heading::arc(r, alpha), six_legs());
    const Vector3 o(-r * std::sin(alpha), r * std::cos(alpha), 0.0);
    EXPECT_LE(direction_at(arc, o).norm(), 1e-14);
    EXPECT_GT(arc.per_metre.w * r, 0.0);
  }
}

// r = 1.2, α = 0: o = (0, 1.2), farthest centres (±0.4, −0.3), R = √(0.4² + 1.5²), w = 1/R, v
// = 1.2/R.
TEST(PathArc, MeasuresAtTheFarthestCentre) {
  const double R = std::hypot(0.4, 1.5);
  const PathArc arc = path_arc(Heading::arc(1.2, 0.0), six_legs());
  EXPECT_NEAR(arc.per_metre.w, 1.0 / R, 1e-15);
  EXPECT_NEAR((arc.per_metre.v - Vector2(1.2 / R, 0.0)).norm(), 0.0, 1e-15);
  EXPECT_EQ(arc.farthest, 1);
}

// The length of the way of every centre, by adding 500 chords: the farthest goes s, up to γ²/24 of
// it for chords that span γ, and no other goes more.
TEST(PathArc, NoWorkspaceCentreGoesFartherThanThePath) {
  RandomSequence random{.seed = 2};
  for (int k = 0; k < 50; ++k) {
    const Stance w = random_stance(random, 4 + 2 * (k % 5));
    const PathArc arc = path_arc(Heading::arc(random_radius(random), random.uniform(-4, 4)), w);
    const double s = 0.3, step = s / 500, gamma = arc.per_metre.w * step;
    for (LegId leg = 0; leg < w.p_BC.size(); ++leg) {
      double length = 0.0;
      for (int i = 0; i < 500; ++i)
        length += (advance(arc, w.p_BC[leg], (i + 1) * step) - advance(arc, w.p_BC[leg], i * step))
                      .norm();
      EXPECT_LE(length, s * (1.0 + 1e-12));
      if (leg != arc.farthest) continue;
      EXPECT_GE(length, s * (1.0 - gamma * gamma / 24.0 - 1e-12));
    }
  }
}

TEST(Aep, IsAheadAlongAStraightLine) {
  const PathArc arc = path_arc(Heading::straight(0.5), six_legs());
  for (LegId leg = 0; leg < 6; ++leg)
    expect_near(aep(arc, leg, 0.1),
                arc.p_BC[leg] + 0.1 * Vector3(std::cos(0.5), std::sin(0.5), 0.0), 1e-15);
}

// α = π walks backwards: AEPs are behind. Turning left then has its centre on the body's right.
TEST(Aep, IsBehindWhenWalkingBackwards) {
  const PathArc straight = path_arc(Heading::straight(std::numbers::pi), six_legs());
  expect_near(aep(straight, 0, 0.1), straight.p_BC[0] - Vector3(0.1, 0.0, 0.0), 1e-15);
  const PathArc arc = path_arc(Heading::arc(2.0, std::numbers::pi), six_legs());
  EXPECT_NEAR(direction_at(arc, {0.0, -2.0, 0.0}).norm(), 0.0, 1e-15);
  EXPECT_GT(arc.per_metre.w, 0.0);
  EXPECT_LT(direction_at(arc, Vector3::Zero()).x(), 0.0);
}

// Spinning, all centres turn about the origin; the corners, at R = 0.5 m, by s / R.
TEST(Aep, TurnsAboutTheOriginOnASpin) {
  for (const double sign : {1.0, -1.0}) {
    const PathArc arc = path_arc(Heading::spin(sign > 0.0 ? Turn::ccw : Turn::cw), six_legs());
    for (LegId leg = 0; leg < 6; ++leg)
      expect_near(aep(arc, leg, 0.1), rotation_z(sign * 0.1 / 0.5) * arc.p_BC[leg], 1e-15);
  }
}

TEST(Aep, IsTheCentreWhenStopped) {
  const PathArc arc = path_arc(Heading::arc(1.0, 0.2).stopped(), six_legs());
  expect_near(aep(arc, 3, 0.1), arc.p_BC[3], 0.0);
  EXPECT_EQ(path_arc(Heading::arc(1.0, 0.2), six_legs()).per_metre.w, arc.per_metre.w);
}

// The printed product (4), from homogeneous 4×4 matrices in long double, with γ = ± s / R_max.
using Matrix4l = Eigen::Matrix<long double, 4, 4>;
Matrix4l Rz(long double angle) {
  Matrix4l M = Matrix4l::Identity();
  M(0, 0) = M(1, 1) = std::cos(angle);
  M(1, 0) = std::sin(angle);
  M(0, 1) = -M(1, 0);
  return M;
}
Matrix4l Ty(long double y) {
  Matrix4l M = Matrix4l::Identity();
  M(1, 3) = y;
  return M;
}

TEST(Displacement, IsThePrintedProductOfTurnsAndShifts) {
  RandomSequence random{.seed = 3};
  for (int k = 0; k < 1000; ++k) {
    const Stance w = random_stance(random, 6);
    const double r = random_radius(random),
                 alpha = random.uniform(-std::numbers::pi, std::numbers::pi);
    const PathArc arc = path_arc(Heading::arc(r, alpha), w);
    const double s = random.uniform(-0.5, 0.5);
    const Eigen::Vector2<long double> o(-r * std::sin(alpha + 0.0L), r * std::cos(alpha + 0.0L));
    long double R_max = 0.0L;
    for (const Vector3& c : w.p_BC)
      R_max = std::max(R_max, (c.head<2>().cast<long double>() - o).norm());
    const long double gamma = std::copysign(1.0, r) * s / R_max;
    const Matrix4l M = Rz(alpha) * Ty(r) * Rz(gamma) * Ty(-r) * Rz(-alpha);

    const Vector3 p(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    const Eigen::Vector<long double, 4> q = M * p.homogeneous().cast<long double>();
    expect_near(advance(arc, p, s), q.head<3>().cast<double>(), 4e-15);
  }
}

TEST(Displacement, AddsUpAlongThePathAndIsUndoneBackwards) {
  RandomSequence random{.seed = 4};
  for (int k = 0; k < 1000; ++k) {
    const PathArc arc =
        path_arc(Heading::arc(random_radius(random), random.uniform(-4, 4)), six_legs());
    const double a = random.uniform(-1, 1), b = random.uniform(-1, 1);
    const Vector3 p(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    expect_near(advance(arc, advance(arc, p, a), b), advance(arc, p, a + b), 1e-14);
    expect_near(advance(arc, advance(arc, p, a), -a), p, 1e-14);
  }
}

// direction_at() is what advance() moves by: central difference, error h²|w|² / 6 per metre.
TEST(DirectionAt, IsTheRateOfAdvance) {
  RandomSequence random{.seed = 5};
  for (int k = 0; k < 1000; ++k) {
    const PathArc arc =
        path_arc(Heading::arc(random_radius(random), random.uniform(-4, 4)), six_legs());
    const Vector3 p(random.uniform(-1, 1), random.uniform(-1, 1), 0.0);
    const double h = 1e-5;
    const Vector3 rate = (advance(arc, p, h) - advance(arc, p, -h)) / (2.0 * h);
    EXPECT_LE((rate.head<2>() - direction_at(arc, p)).norm(), 1e-9);
  }
}

struct Problem {
  double r, alpha, s;
  Stance w;
};

Problem random_problem(RandomSequence& random) {
  const Stance w = random_stance(random, 6);
  const double r = random_radius(random),
               alpha = random.uniform(-std::numbers::pi, std::numbers::pi);
  return {r, alpha, random.uniform(-0.4, 0.4), w};
}

// Turning the robot by β and α by β turns the answer by β.
TEST(Aep, TurnsWithTheWholeProblem) {
  RandomSequence random{.seed = 6};
  for (int k = 0; k < 500; ++k) {
    const Problem q = random_problem(random);
    const Matrix3 R = rotation_z(random.uniform(-std::numbers::pi, std::numbers::pi));
    Stance turned = q.w;
    for (Vector3& c : turned.p_BC) c = R * c;
    const double beta = std::atan2(R(1, 0), R(0, 0));
    const PathArc a = path_arc(Heading::arc(q.r, q.alpha), q.w);
    const PathArc b = path_arc(Heading::arc(q.r, q.alpha + beta), turned);
    for (LegId leg = 0; leg < 6; ++leg) expect_near(aep(b, leg, q.s), R * aep(a, leg, q.s), 1e-14);
  }
}

// Left and right exchanged: y → −y with (r, α) → (−r, −α).
TEST(Aep, IsMirroredWithTheWholeProblem) {
  const Matrix3 mirror = Vector3(1.0, -1.0, 1.0).asDiagonal();
  RandomSequence random{.seed = 7};
  for (int k = 0; k < 500; ++k) {
    const Problem q = random_problem(random);
    Stance mirrored = q.w;
    for (Vector3& c : mirrored.p_BC) c = mirror * c;
    const PathArc a = path_arc(Heading::arc(q.r, q.alpha), q.w);
    const PathArc b = path_arc(Heading::arc(-q.r, -q.alpha), mirrored);
    for (LegId leg = 0; leg < 6; ++leg)
      expect_near(aep(b, leg, q.s), mirror * aep(a, leg, q.s), 1e-15);
  }
}

// The 1 m in ρ² + k² = 1 is of no consequence: with all lengths multiplied, so is the answer.
TEST(Aep, ScalesWithTheWholeProblem) {
  RandomSequence random{.seed = 8};
  for (int k = 0; k < 500; ++k) {
    const Problem q = random_problem(random);
    const double scale = std::pow(10.0, random.uniform(-2.0, 2.0));
    Stance scaled = q.w;
    for (Vector3& c : scaled.p_BC) c *= scale;
    const PathArc a = path_arc(Heading::arc(q.r, q.alpha), q.w);
    const PathArc b = path_arc(Heading::arc(scale * q.r, q.alpha), scaled);
    for (LegId leg = 0; leg < 6; ++leg)
      expect_near(aep(b, leg, scale * q.s) / scale, aep(a, leg, q.s), 1e-14);
  }
}

}  // namespace
}  // namespace hexagait::heading_control::path_arc_test

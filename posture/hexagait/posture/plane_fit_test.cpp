// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/QR>
#include <hexagait/posture/detail/posture_error.hpp>
#include <hexagait/posture/plane_fit.hpp>
#include <hexagait/sim/random.hpp>
#include <testing/random_feet.hpp>

namespace hexagait::posture {
namespace {

using testing::centres;
using testing::random_feet;
const LegSet kAll = LegSet::all(6);

// Feet as seen after the body has done what the fit says.
LegArray<Vector3> feet_after(const PlaneFit& fit, LegArray<Vector3> p_BF) {
  const Pose X{rotation({0, fit.pitch, 0}) * rotation({fit.roll, 0, 0}), {0, 0, fit.height}};
  for (Vector3& p : p_BF) p = X.inverse() * p;
  return p_BF;
}

// All feet 1 cm lower than their centres: the body stands too high, so down by 1 cm.
TEST(PlaneFit, LowersTheBodyWhenTheFeetAreTooLow) {
  LegArray<Vector3> p = centres();
  for (Vector3& foot : p) foot.z() -= 0.01;
  const PlaneFit fit = plane_fit(p, centres(), kAll);
  EXPECT_NEAR(fit.height, -0.01, 1e-15);
  EXPECT_NEAR(fit.roll, 0.0, 1e-15);
  EXPECT_NEAR(fit.pitch, 0.0, 1e-15);
  EXPECT_EQ(fit.rank, 3);
}

// Ground that rises to the left by 0.1: left side up, roll > 0 (x ahead, from y towards z).
TEST(PlaneFit, RollsTheLeftSideUpWhenTheGroundRisesToTheLeft) {
  LegArray<Vector3> p = centres();
  for (Vector3& foot : p) foot.z() += 0.1 * foot.y();
  const PlaneFit fit = plane_fit(p, centres(), kAll);
  EXPECT_NEAR(fit.roll, 0.1, 1e-15);
  EXPECT_NEAR(fit.pitch, 0.0, 1e-15);
  EXPECT_NEAR(fit.height, 0.0, 1e-15);
}

// Ground that rises ahead by 0.1: nose up, pitch < 0 (y left, from z towards x).
TEST(PlaneFit, PitchesTheNoseUpWhenTheGroundRisesAhead) {
  LegArray<Vector3> p = centres();
  for (Vector3& foot : p) foot.z() += 0.1 * foot.x();
  const PlaneFit fit = plane_fit(p, centres(), kAll);
  EXPECT_NEAR(fit.pitch, -0.1, 1e-15);
  EXPECT_NEAR(fit.roll, 0.0, 1e-15);
  EXPECT_NEAR(fit.height, 0.0, 1e-15);
}

// Flat ground is found exactly wherever the feet stand on it, by any tripod.
TEST(PlaneFit, FindsFlatGroundWhereverTheFeetStand) {
  RandomSequence random{.seed = 1};
  for (int k = 0; k < 500; ++k) {
    const double h = random.uniform(-0.1, 0.1), a = random.uniform(-0.3, 0.3),
                 b = random.uniform(-0.3, 0.3);
    LegArray<Vector3> p = random_feet(random, 0.2);
    for (Vector3& foot : p) foot.z() = -0.25 + h + a * foot.x() + b * foot.y();
    const PlaneFit fit = plane_fit(p, centres(), k % 2 == 0 ? kAll : LegSet(0b011001));
    EXPECT_NEAR(fit.height, h, 1e-14);
    EXPECT_NEAR(fit.roll, b, 1e-14);
    EXPECT_NEAR(fit.pitch, -a, 1e-14);
  }
}

// The least-squares problem itself, by Eigen's QR on the n × 3 matrix (1, x, y). The moments'
// condition is at most 1e4 (feet nearer to a line are treated as on it), so rounding at most 1e-12.
TEST(PlaneFit, IsTheLeastSquaresPlane) {
  RandomSequence random{.seed = 2};
  for (int k = 0; k < 1000; ++k) {
    const LegArray<Vector3> p = random_feet(random, 0.2);
    const LegSet legs = k % 2 == 0 ? kAll : LegSet(0b101101);
    Eigen::MatrixXd A(legs.size(), 3);
    Eigen::VectorXd e(legs.size());
    for (LegId leg = 0, row = 0; leg < 6; ++leg) {
      if (!legs.contains(leg)) continue;
      A.row(row) << 1.0, p[leg].x(), p[leg].y();
      e[row++] = p[leg].z() - centres()[leg].z();
    }
    const Vector3 plane = A.colPivHouseholderQr().solve(e);
    const PlaneFit fit = plane_fit(p, centres(), legs);
    EXPECT_NEAR(fit.height, plane[0], 1e-12);
    EXPECT_NEAR(fit.pitch, -plane[1], 1e-12);
    EXPECT_NEAR(fit.roll, plane[2], 1e-12);
  }
}

// Doing what it says leaves second-order terms: with angles up to ε and heights within 0.25 m, feet
// within 0.6 m, what the next fit finds is below ε² (cos ε − 1 and the shift of p_x, p_y by ε p_z).
TEST(PlaneFit, LeavesOnlySecondOrderTermsWhenFollowed) {
  RandomSequence random{.seed = 3};
  for (int k = 0; k < 300; ++k) {
    const double size = k % 2 == 0 ? 0.05 : 0.0005;
    LegArray<Vector3> p = random_feet(random, 0.1);
    for (Vector3& foot : p) foot.z() = -0.25 + random.uniform(-size, size);
    const PlaneFit first = plane_fit(p, centres(), kAll);
    const PlaneFit second = plane_fit(feet_after(first, p), centres(), kAll);
    const double bound = 20.0 * size * size;
    EXPECT_LE(std::abs(second.height), bound);
    EXPECT_LE(std::abs(second.roll), bound);
    EXPECT_LE(std::abs(second.pitch), bound);
  }
}

// Why it is the walker's default: level ground, all feet 10 cm behind. Nothing to correct, but the
// printed pitch gradient 2 Σ(c_z p_x − c_x p_z) = 2 · 6 · 0.25 · 0.1 is not zero.
TEST(PlaneFit, DoesNotTiltForFeetThatLag) {
  LegArray<Vector3> p = centres();
  for (Vector3& foot : p) foot.x() -= 0.1;
  const PlaneFit fit = plane_fit(p, centres(), kAll);
  EXPECT_NEAR(fit.pitch, 0.0, 1e-15);
  EXPECT_NEAR(fit.height, 0.0, 1e-15);
  EXPECT_NEAR(gradient(p, centres()).pitch, 0.3, 1e-15);
}

// Centres of unequal height (a robot that stands on uneven feet by design) are what "level" means.
TEST(PlaneFit, IsZeroWhenEveryFootIsAtItsOwnHeight) {
  LegArray<Vector3> c = centres();
  for (LegId leg = 0; leg < 6; ++leg) c[leg].z() += 0.03 * leg;
  const PlaneFit fit = plane_fit(c, c, kAll);
  EXPECT_EQ(fit.height, 0.0);
  EXPECT_EQ(fit.roll, 0.0);
  EXPECT_EQ(fit.pitch, 0.0);
}

// Seen in axes turned by β about z, (roll, pitch) turns as a vector and the height stays.
TEST(PlaneFit, TurnsWithTheAxes) {
  RandomSequence random{.seed = 4};
  for (int k = 0; k < 300; ++k) {
    const double beta = random.uniform(-3, 3);
    // On a line at every second try, where only the slope along it is answered.
    const LegSet legs = k % 2 == 0 ? kAll : LegSet(0b010001);
    LegArray<Vector3> p = random_feet(random, 0.2), turned = p;
    for (Vector3& foot : turned) foot = rotation_z(beta) * foot;
    const PlaneFit a = plane_fit(p, centres(), legs), b = plane_fit(turned, centres(), legs);
    const Vector3 expected = rotation_z(beta) * Vector3(a.roll, a.pitch, a.height);
    EXPECT_NEAR((Vector3(b.roll, b.pitch, b.height) - expected).norm(), 0.0, 1e-14);
    EXPECT_EQ(a.rank, b.rank);
  }
}

// The left legs alone, on a line along x that rises ahead: pitch is answered, roll is left at 0.
TEST(PlaneFit, LeavesOpenWhatTheFeetDoNotSay) {
  LegArray<Vector3> p = centres();
  for (Vector3& foot : p) foot.z() += 0.01 + 0.1 * foot.x() + 0.2 * foot.y();
  const PlaneFit line = plane_fit(p, centres(), LegSet(0b010101));
  EXPECT_NEAR(line.pitch, -0.1, 1e-15);
  EXPECT_NEAR(line.roll, 0.0, 1e-15);
  EXPECT_NEAR(line.height, 0.01 + 0.2 * 0.3, 1e-15);
  EXPECT_EQ(line.rank, 2);

  const PlaneFit point = plane_fit(p, centres(), LegSet(0b000100));
  EXPECT_NEAR(point.height, 0.07, 1e-15);
  EXPECT_EQ(point.pitch, 0.0);
  EXPECT_EQ(point.rank, 1);

  const PlaneFit nothing = plane_fit(p, centres(), LegSet());
  EXPECT_EQ(nothing.height, 0.0);
  EXPECT_EQ(nothing.rank, 0);
}

}  // namespace
}  // namespace hexagait::posture

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/balance/load_sharing.hpp>
#include <hexagait/sim/random.hpp>
#include <numbers>
#include <numeric>

namespace hexagait {
namespace {

constexpr double kWeight = 490.5;  // [N]

LegArray<Vector3> regular_polygon(int n, double radius) {
  LegArray<Vector3> feet(n);
  for (LegId i = 0; i < n; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / n;
    feet[i] = {radius * std::cos(angle), radius * std::sin(angle), -0.3};
  }
  return feet;
}

double sum(const LegArray<double>& force) {
  return std::accumulate(force.begin(), force.end(), 0.0);
}

/// Of the forces about the centre of mass [N m].
Vector2 moment(const LegArray<double>& force, const LegArray<Vector3>& feet, const Vector3& p_M) {
  Vector2 moment = Vector2::Zero();
  for (LegId i = 0; i < feet.size(); ++i) moment += force[i] * (feet[i] - p_M).head<2>();
  return moment;
}

TEST(SharedLoad, IsAThirdOnEachOfThreeFeetAroundTheCentreOfMass) {
  for (const double force :
       shared_load(regular_polygon(3, 0.5), Vector3::Zero(), LegArray<double>(3, 1.0), kWeight))
    EXPECT_NEAR(force, kWeight / 3.0, 1e-9);
}

// Three feet leave no choice: the forces are the barycentric coordinates of the centre of mass. The
// regularisation, 1e-6 m² beside 0.1, errs by 1e-5.
TEST(SharedLoad, IsBarycentricOnThreeFeet) {
  const LegArray<Vector3> feet = regular_polygon(3, 0.5);
  const Vector3 p_M = 0.5 * feet[0] + 0.3 * feet[1] + 0.2 * feet[2];
  const LegArray<double> force = shared_load(feet, p_M, LegArray<double>(3, 1.0), kWeight);
  EXPECT_NEAR(force[0], 0.5 * kWeight, 1e-5 * kWeight);
  EXPECT_NEAR(force[1], 0.3 * kWeight, 1e-5 * kWeight);
  EXPECT_NEAR(force[2], 0.2 * kWeight, 1e-5 * kWeight);
}

TEST(SharedLoad, IsAllOnAFootUnderTheCentreOfMass) {
  const LegArray<Vector3> feet = regular_polygon(3, 0.5);
  const LegArray<double> force = shared_load(feet, feet[1], LegArray<double>(3, 1.0), kWeight);
  EXPECT_NEAR(force[0], 0.0, 1e-4 * kWeight);
  EXPECT_NEAR(force[1], kWeight, 1e-4 * kWeight);
  EXPECT_NEAR(force[2], 0.0, 1e-4 * kWeight);
}

// The lever rule: 0.3 m and 0.7 m from the centre of mass.
TEST(SharedLoad, IsThatOfALeverOnTwoFeet) {
  LegArray<Vector3> feet(6, Vector3(9.0, 9.0, 9.0));
  feet[1] = {0.3, 0.0, 0.0}, feet[4] = {-0.7, 0.0, 0.0};
  LegArray<double> share(6, 0.0);
  share[1] = share[4] = 1.0;
  const LegArray<double> force = shared_load(feet, Vector3::Zero(), share, kWeight);
  EXPECT_NEAR(force[1], 0.7 * kWeight, 1e-5 * kWeight);
  EXPECT_NEAR(force[4], 0.3 * kWeight, 1e-5 * kWeight);
  EXPECT_EQ(force[0], 0.0);
}

TEST(SharedLoad, IsAllOnTheOnlyFootAndNothingOnNone) {
  const LegArray<Vector3> feet = regular_polygon(6, 0.5);
  LegArray<double> share(6, 0.0);
  EXPECT_EQ(sum(shared_load(feet, Vector3::Zero(), share, kWeight)), 0.0);
  share[2] = 0.3;
  EXPECT_NEAR(shared_load(feet, Vector3::Zero(), share, kWeight)[2], kWeight, 1e-9);
}

// Its definition: the weight, no moment about the centre of mass, and F/w affine in (x, y). Feet
// around the centre of mass by pairs opposite to each other within 10 %, so that nobody pulls.
TEST(SharedLoad, BalancesWeightAndMomentsWithForcesAffineInPosition) {
  RandomSequence random{.seed = 2};
  for (int trial = 0; trial < 1000; ++trial) {
    const int n = 4 + 2 * (trial % 5);
    LegArray<Vector3> feet = regular_polygon(n, 0.5);
    LegArray<double> share(n);
    for (LegId i = 0; i < n; ++i) {
      feet[i] += Vector3(random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05), random.u01());
      share[i] = random.uniform(0.6, 1.0);
    }
    const Vector3 p_M(random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02), 0.0);
    const LegArray<double> force = shared_load(feet, p_M, share, kWeight);
    ASSERT_NEAR(sum(force), kWeight, 1e-9);
    ASSERT_LT(moment(force, feet, p_M).norm(), 1e-5 * kWeight);

    // a + b x + c y from the first three, checked on the others.
    Matrix3 rows;
    Vector3 values;
    for (LegId i = 0; i < 3; ++i) {
      rows.row(i) << 1.0, feet[i].x(), feet[i].y();
      values[i] = force[i] / share[i];
    }
    const Vector3 abc = rows.colPivHouseholderQr().solve(values);
    for (LegId i = 3; i < n; ++i)
      ASSERT_NEAR(force[i] / share[i], abc.dot(Vector3(1.0, feet[i].x(), feet[i].y())), 1e-6);
  }
}

TEST(SharedLoad, CarriesTheWeightAndNeverPullsWhereverTheCentreOfMassIs) {
  RandomSequence random{.seed = 3};
  for (int trial = 0; trial < 2000; ++trial) {
    const LegArray<Vector3> feet = regular_polygon(6, 0.5);
    LegArray<double> share(6);
    for (double& w : share) w = random.u01() < 0.4 ? 0.0 : random.u01();
    share[trial % 6] = 1.0;
    const Vector3 p_M(random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5), 0.0);
    const LegArray<double> force = shared_load(feet, p_M, share, kWeight);
    ASSERT_NEAR(sum(force), kWeight, 1e-9);
    for (LegId i = 0; i < 6; ++i) {
      ASSERT_GE(force[i], 0.0);
      if (share[i] == 0.0) {
        ASSERT_EQ(force[i], 0.0);
      }
    }
  }
}

// Continuity: with the share in steps of ε the largest change of a force is ≤ L ε. So it halves
// with ε. L = 2 W is generous: no force exceeds W, and all change in less than half of the ramp.
TEST(SharedLoad, ChangesWithoutAJumpAsALegIsUnloaded) {
  const LegArray<Vector3> feet = regular_polygon(6, 0.5);
  const Vector3 p_M(0.05, -0.02, 0.0);
  for (const int steps : {20, 200, 2000}) {
    LegArray<double> share(6, 1.0);
    share[5] = 0.0;
    LegArray<double> before = shared_load(feet, p_M, share, kWeight);
    for (int k = steps - 1; k >= 0; --k) {
      share[0] = share[3] = static_cast<double>(k) / steps;
      const LegArray<double> force = shared_load(feet, p_M, share, kWeight);
      for (LegId i = 0; i < 6 && k < steps - 1; ++i) {
        ASSERT_LT(std::abs(force[i] - before[i]), 2.0 * kWeight / steps);
      }
      before = force;
    }
    EXPECT_EQ(before[0], 0.0);
  }
}

}  // namespace
}  // namespace hexagait

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <hexagait/posture/detail/posture_error.hpp>
#include <hexagait/posture/free_optimum.hpp>
#include <hexagait/sim/random.hpp>
#include <testing/random_feet.hpp>

namespace hexagait::posture::free_optimum_test {
namespace {

using testing::centres;
using testing::random_feet;
using testing::random_vector;
const LegSet kAll = LegSet::all(6);

Pose random_pose(RandomSequence& random, double angle) {
  return {rotation(random_vector(random, angle)), random_vector(random, 0.3)};
}
LegArray<Vector3> moved(const Pose& X, LegArray<Vector3> points) {
  for (Vector3& p : points) p = X * p;
  return points;
}
double distance(const Pose& a, const Pose& b) { return (a.R - b.R).norm() + (a.p - b.p).norm(); }

// Feet 1 cm ahead of, and 2 cm above, all centres: so is the desired body.
TEST(FreeOptimum, PutsTheBodyWhereTheFeetAre) {
  LegArray<Vector3> p = centres();
  for (Vector3& foot : p) foot += Vector3(0.01, 0.0, 0.02);
  EXPECT_LE(distance(free_optimum(p, centres(), kAll), {Matrix3::Identity(), {0.01, 0.0, 0.02}}),
            1e-15);
}

// Feet at the centres of a body at X: that body, for any turn (the coefficients of the quaternion
// have an error of rounding over the eigenvalue gap, here 2 Σ over the two smaller spreads, O(1)).
TEST(FreeOptimum, RecoversThePoseFromWhichTheFeetWereMade) {
  RandomSequence random{.seed = 1};
  for (int k = 0; k < 500; ++k) {
    const Pose X = random_pose(random, k % 2 == 0 ? 0.2 : 1.7);
    EXPECT_LE(distance(free_optimum(moved(X, centres()), centres(), kAll), X), 1e-13);
  }
}

TEST(FreeOptimum, IsUmeyamasRegistration) {
  RandomSequence random{.seed = 2};
  for (int k = 0; k < 500; ++k) {
    const LegArray<Vector3> p = moved(random_pose(random, 1.0), random_feet(random, 0.1));
    Eigen::Matrix<double, 3, 6> from, to;
    for (LegId leg = 0; leg < 6; ++leg) {
      from.col(leg) = centres()[leg];
      to.col(leg) = p[leg];
    }
    const Eigen::Matrix4d T = Eigen::umeyama(from, to, false);
    const Pose X{T.topLeftCorner<3, 3>(), T.topRightCorner<3, 1>()};
    EXPECT_LE(distance(free_optimum(p, centres(), kAll), X), 1e-12);
  }
}

TEST(FreeOptimum, MakesAllSixPrintedGradientsVanish) {
  RandomSequence random{.seed = 3};
  for (int k = 0; k < 500; ++k) {
    const LegArray<Vector3> p = moved(random_pose(random, 1.0), random_feet(random, 0.1));
    const Pose X = free_optimum(p, centres(), kAll);
    const PostureGradient g = gradient(moved(X.inverse(), p), centres());
    EXPECT_LE(Vector3(g.x, g.y, g.z).norm(), 1e-14);
    EXPECT_LE(Vector3(g.roll, g.pitch, g.yaw).norm(), 1e-14);
  }
}

// [PC04]'s way: feet moved down the six gradients, a little each time. With spreads of 0.3 m and
// six feet, E's curvatures are 12 per metre² and some 0.5 to 3 per rad²: these steps converge.
TEST(FreeOptimum, IsWhereDescendingTheSixGradientsEnds) {
  RandomSequence random{.seed = 4};
  for (int k = 0; k < 30; ++k) {
    const LegArray<Vector3> p = random_feet(random, 0.1);
    Pose feet_motion;
    for (int i = 0; i < 2000; ++i) {
      const PostureGradient g = gradient(moved(feet_motion, p), centres());
      const Pose step{rotation(-0.1 * Vector3(g.roll, g.pitch, g.yaw)),
                      -0.05 * Vector3(g.x, g.y, g.z)};
      feet_motion = step * feet_motion;
    }
    EXPECT_LE(distance(free_optimum(p, centres(), kAll), feet_motion.inverse()), 1e-11);
  }
}

// Moving the ground with all feet on it moves the desired body with it.
TEST(FreeOptimum, MovesWithTheGround) {
  RandomSequence random{.seed = 5};
  for (int k = 0; k < 200; ++k) {
    const LegArray<Vector3> p = random_feet(random, 0.1);
    const Pose Y = random_pose(random, 1.7);
    EXPECT_LE(
        distance(free_optimum(moved(Y, p), centres(), kAll), Y * free_optimum(p, centres(), kAll)),
        1e-12);
  }
}

TEST(FreeOptimum, HeedsOnlyTheLegsThatCount) {
  RandomSequence random{.seed = 6};
  LegArray<Vector3> p = random_feet(random, 0.1);
  const Pose X = free_optimum(p, centres(), LegSet(0b011001));
  for (const LegId leg : {1, 2, 5}) p[leg] = random_vector(random, 10.0);
  EXPECT_EQ(distance(free_optimum(p, centres(), LegSet(0b011001)), X), 0.0);
}

// Left and right exchanged, the nearest fit of a flat set of feet is a reflection; a body can't do
// it.
TEST(FreeOptimum, IsNeverAReflection) {
  LegArray<Vector3> p = centres();
  p[0].z() += 0.1;
  for (Vector3& foot : p) foot.z() = -foot.z();
  EXPECT_NEAR(free_optimum(p, centres(), kAll).R.determinant(), 1.0, 1e-14);
}

TEST(FreeOptimum, StaysIfNoLegCounts) {
  EXPECT_EQ(distance(free_optimum(centres(), centres(), LegSet()), Pose{}), 0.0);
}

TEST(FreeOptimum, ShiftsWithoutTurningForOneLeg) {
  LegArray<Vector3> p = centres();
  p[3] += Vector3(0.1, 0.2, -0.3);
  const Pose X = free_optimum(p, centres(), LegSet(0b001000));
  EXPECT_LE(distance(X, {Matrix3::Identity(), {0.1, 0.2, -0.3}}), 1e-15);
}

// Three centres on a line along d, and feet on a line that is turned about an axis normal to d by
// less than half a turn: a turn about the line itself would add to the angle, so this one is the
// least.
TEST(FreeOptimum, TurnsTheLeastForFeetOnALine) {
  RandomSequence random{.seed = 7};
  for (int k = 0; k < 300; ++k) {
    const Vector3 d = random_vector(random, 1.0),
                  axis = d.cross(random_vector(random, 1.0)).normalized();
    const Pose X{rotation(random.uniform(0.0, 2.5) * axis), random_vector(random, 0.3)};
    LegArray<Vector3> c = centres();
    for (LegId leg = 0; leg < 6; ++leg) c[leg] = (leg / 2 - 0.7) * d + Vector3(0.1, 0.2, 0.3);
    EXPECT_LE(distance(free_optimum(moved(X, c), c, LegSet(0b010101)), X), 1e-7);
  }
}

}  // namespace
}  // namespace hexagait::posture::free_optimum_test

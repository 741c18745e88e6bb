// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/math/geometry.hpp>
#include <hexagait/math/planar.hpp>
#include <hexagait/sim/random.hpp>

namespace hexagait {
namespace {

// A quarter turn on the unit circle to the left: from (0,0) heading x to (1,1) heading y.
TEST(PlanarExponential, FollowsTheUnitCircle) {
  const PlanarPose pose = exponential({{1.0, 0.0}, 1.0}, std::numbers::pi / 2);
  EXPECT_NEAR(pose.angle, std::numbers::pi / 2, 1e-15);
  EXPECT_NEAR(pose.shift.x(), 1.0, 1e-15);
  EXPECT_NEAR(pose.shift.y(), 1.0, 1e-15);
}

TEST(PlanarExponential, IsContinuousWhereTheSeriesTakesOver) {
  for (const double w : {9.99999e-5, 1.000001e-4}) {
    const PlanarPose pose = exponential({{1.0, 0.0}, w}, 1.0);
    EXPECT_NEAR(pose.shift.x(), 1.0 - w * w / 6.0, 2.3e-16);  // one ulp of 1
    EXPECT_NEAR(pose.shift.y(), w / 2.0 - w * w * w / 24.0, 1e-16);
  }
}

TEST(PlanarExponential, IsUndoneByTheLogarithm) {
  RandomSequence random{.seed = 1};
  for (int k = 0; k < 1000; ++k) {
    const double size = k % 2 == 0 ? 1.0 : 1e-8;
    const PlanarTwist twist{{random.uniform(-2, 2), random.uniform(-2, 2)},
                            size * random.uniform(-3.1, 3.1)};
    const PlanarTwist back = logarithm(exponential(twist, 1.0));
    EXPECT_NEAR((back.v - twist.v).norm(), 0.0, 1e-12);
    EXPECT_NEAR(back.w, twist.w, 1e-15);
  }
}

TEST(PlanarExponential, CarriesPoints) {
  RandomSequence random{.seed = 3};
  for (int k = 0; k < 1000; ++k) {
    const PlanarTwist twist{{random.uniform(-2, 2), random.uniform(-2, 2)},
                            k % 3 == 0 ? 0.0 : random.uniform(-3.1, 3.1)};
    const Vector2 p(random.uniform(-2, 2), random.uniform(-2, 2));
    const double s = random.uniform(-1, 1);
    EXPECT_NEAR((carried(p, twist, s) - exponential(twist, s) * p).norm(), 0.0, 1e-14);
  }
}

TEST(PlanarPose, TimesItsInverseIsTheIdentity) {
  const PlanarPose pose{0.7, {0.3, -2.0}};
  const PlanarPose identity = pose * pose.inverse();
  EXPECT_NEAR(identity.angle, 0.0, 1e-15);
  EXPECT_NEAR(identity.shift.norm(), 0.0, 1e-15);
}

TEST(PlanarPose, FromAnotherIsSeenThroughItsInverse) {
  const PlanarPose a{0.7, {0.3, -2.0}}, b{-0.4, {1.1, 0.6}};
  const PlanarPose seen = between(a, b), expected = a.inverse() * b;
  EXPECT_NEAR(seen.angle, expected.angle, 1e-15);
  EXPECT_NEAR((seen.shift - expected.shift).norm(), 0.0, 1e-15);
}

TEST(Rotation, IsUndoneByItsVector) {
  RandomSequence random{.seed = 2};
  for (int k = 0; k < 1000; ++k) {
    const double size = k % 2 == 0 ? 1.0 : 1e-8;
    const Vector3 w = size * Vector3(random.uniform(-1.7, 1.7), random.uniform(-1.7, 1.7),
                                     random.uniform(-1.7, 1.7));
    EXPECT_NEAR((rotation_vector(rotation(w)) - w).norm(), 0.0, 1e-13);
  }
}

// Rz(0.3) Ry(0.2) Rx(0.1), built from three turns about coordinate axes.
TEST(RollPitchYaw, ReadsTheAnglesOfAProductOfTurns) {
  const Matrix3 R = rotation({0, 0, 0.3}) * rotation({0, 0.2, 0}) * rotation({0.1, 0, 0});
  EXPECT_NEAR((roll_pitch_yaw(R) - Vector3(0.1, 0.2, 0.3)).norm(), 0.0, 1e-15);
}

// Known-answer vector of Philox4x32-10 with key 0, counter 0 (Random123): first words 6627e8d5
// e169c58d.
TEST(Random, IsPhilox4x32) {
  EXPECT_EQ(random_u01(0, static_cast<RandomStream>(0), 0, 0),
            static_cast<double>(0x6627e8d5e169c58dULL >> 11) * 0x1.0p-53);
}

TEST(Random, DiffersBetweenStreamsTrialsAndDraws) {
  const double reference = random_u01(7, RandomStream::terrain, 3, 11);
  EXPECT_NE(reference, random_u01(8, RandomStream::terrain, 3, 11));
  EXPECT_NE(reference, random_u01(7, RandomStream::posture, 3, 11));
  EXPECT_NE(reference, random_u01(7, RandomStream::terrain, 4, 11));
  EXPECT_NE(reference, random_u01(7, RandomStream::terrain, 3, 12));
  EXPECT_EQ(reference, random_u01(7, RandomStream::terrain, 3, 11));
}

}  // namespace
}  // namespace hexagait

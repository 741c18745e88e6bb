// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <hexagait/math/geometry.hpp>
#include <hexagait/posture/lean.hpp>

namespace hexagait::posture::lean_test {
namespace {

const Vector3 kMass(0.02, -0.01, -0.02);

LegArray<Vector3> centres() {
  LegArray<Vector3> p(6);
  for (LegId i = 0; i < 6; ++i) p[i] = {0.4 * (1 - i / 2), i % 2 == 0 ? 0.5 : -0.5, -0.3};
  return p;
}

// Where the centre of mass is over the plane of the feet, seen along gravity, from their middle.
Vector2 seen_along_gravity(const Matrix3& R_WB, const LegArray<Vector3>& feet) {
  const Vector3 up_B = R_WB.row(2);
  Vector3 middle = Vector3::Zero();
  for (const Vector3& p : feet) middle += p / feet.size();
  const double down = (kMass.z() - middle.z()) / up_B.z();
  return (kMass - down * up_B - middle).head<2>();
}

TEST(Lean, IsNoneOnLevelGround) {
  EXPECT_EQ(lean(centres(), kMass, Vector3::UnitZ(), 1.0), Vector2(Vector2::Zero()));
}

TEST(Lean, LeavesTheCentreOfMassWhereItIsOverTheFeetOfALevelRobot) {
  const Vector2 level = seen_along_gravity(Matrix3::Identity(), centres());
  for (const Vector3& turn :
       {Vector3(0.0, 0.3, 0.0), Vector3(-0.2, 0.0, 0.0), Vector3(0.2, -0.4, 1.0)}) {
    const Matrix3 R_WB = rotation(turn);
    LegArray<Vector3> leant = centres();
    for (Vector3& p : leant) p.head<2>() += lean(centres(), kMass, R_WB.row(2), 1.0);
    EXPECT_NEAR((seen_along_gravity(R_WB, leant) - level).norm(), 0.0, 1e-12) << turn;
  }
}

// Nose up: the feet go back in the body frame, so the body goes uphill.
TEST(Lean, IsUphill) {
  const Matrix3 R_WB = rotation(Vector3(0.0, -0.2, 0.0));
  EXPECT_LT(lean(centres(), kMass, R_WB.row(2), 1.0).x(), -0.05);
}

TEST(Lean, IsBounded) {
  const Matrix3 R_WB = rotation(Vector3(0.5, -1.4, 0.0));
  EXPECT_NEAR(lean(centres(), kMass, R_WB.row(2), 0.11).norm(), 0.11, 1e-12);
}

}  // namespace
}  // namespace hexagait::posture::lean_test

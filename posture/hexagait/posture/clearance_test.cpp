// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <hexagait/math/leg.hpp>
#include <hexagait/posture/clearance.hpp>

namespace hexagait::posture::clearance_test {
namespace {

// Feet of a robot whose body is 0.3 m above them.
LegArray<Vector3> centres() {
  LegArray<Vector3> p(6);
  for (LegId i = 0; i < 6; ++i) p[i] = {0.4 * (1 - i / 2), i % 2 == 0 ? 0.5 : -0.5, -0.3};
  return p;
}

TEST(Clearance, IsNoneOnAnyPlane) {
  LegArray<Vector3> ground = centres();
  for (Vector3& g : ground) g.z() += 0.05 + 0.2 * g.x() - 0.1 * g.y();
  const PlaneFit plane = plane_fit(ground, centres(), LegSet::all(6));
  EXPECT_NEAR(clearance(ground, centres(), plane, LegSet::all(6)), 0.0, 1e-12);
}

TEST(Clearance, IsHalfOfWhatTheHighestGroundIsAboveThePlane) {
  LegArray<Vector3> ground = centres();
  const PlaneFit level = plane_fit(ground, centres(), LegSet::all(6));
  ground[2].z() += 0.12;
  ground[5].z() += 0.04;
  EXPECT_NEAR(clearance(ground, centres(), level, LegSet::all(6)), 0.06, 1e-12);
}

// By the fit's own residuals: nothing else of the slope matters.
TEST(Clearance, IsMeasuredFromTheTiltedPlane) {
  LegArray<Vector3> ground = centres();
  const double bumps[] = {0.1, -0.1, -0.1, 0.1, 0.1, -0.1};
  for (LegId i = 0; i < 6; ++i) ground[i].z() += bumps[i];
  const PlaneFit level = plane_fit(ground, centres(), LegSet::all(6));
  LegArray<Vector3> tilted = ground;
  for (Vector3& g : tilted) g.z() += 0.15 * g.x() + 0.2 * g.y();
  const PlaneFit slope = plane_fit(tilted, centres(), LegSet::all(6));
  EXPECT_GT(clearance(ground, centres(), level, LegSet::all(6)), 0.02);
  EXPECT_NEAR(clearance(tilted, centres(), slope, LegSet::all(6)),
              clearance(ground, centres(), level, LegSet::all(6)), 1e-12);
}

TEST(Clearance, IsAtMostAThirdOfTheHeight) {
  LegArray<Vector3> ground = centres();
  ground[0].z() += 1.0;
  EXPECT_NEAR(clearance(ground, centres(), {}, LegSet::all(6)), 0.1, 1e-12);
}

TEST(Clearance, DoesNotCountLegsThatAreLost) {
  LegArray<Vector3> ground = centres();
  ground[3].z() += 0.1;
  LegSet others = LegSet::all(6);
  others.erase(3);
  EXPECT_EQ(clearance(ground, centres(), {}, others), 0.0);
}

}  // namespace
}  // namespace hexagait::posture::clearance_test

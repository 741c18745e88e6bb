// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/footstep_gen/print_plane.hpp>

namespace hexagait::footstep_gen {
namespace {

LegArray<Vector3> prints(double a, double b) {
  LegArray<Vector3> prints(6);
  const double x[] = {0.5, 0.4, 0.05, -0.1, -0.45, -0.5},
               y[] = {0.5, -0.5, 0.53, -0.5, 0.48, -0.52};
  for (LegId i = 0; i < 6; ++i) prints[i] = {3.0 + x[i], y[i], 0.2 + a * x[i] + b * y[i]};
  return prints;
}

TEST(PrintPlane, GoesThroughPrintsOnASlope) {
  const PrintPlane plane = plane_through(prints(0.1, -0.2));
  EXPECT_NEAR(plane.at({3.0, 0.0}), 0.2, 1e-12);
  EXPECT_NEAR(plane.at({3.5, 0.5}), 0.15, 1e-12);
  EXPECT_NEAR(plane.off, 0.0, 1e-12);
}

TEST(PrintPlane, TellsHowFarAPrintIsOff) {
  LegArray<Vector3> all = prints(0.1, -0.2);
  all[2].z() -= 0.01;
  const PrintPlane plane = plane_through(all);
  EXPECT_GT(plane.off, 0.005);
  EXPECT_LT(plane.off, 0.01);
}

TEST(PrintPlane, OfPrintsInALineIsLevel) {
  LegArray<Vector3> all(4);
  for (LegId i = 0; i < 4; ++i) all[i] = {1.0 * i, 0.0, i == 1 ? 0.04 : 0.0};
  const PrintPlane plane = plane_through(all);
  EXPECT_EQ(plane.slope, Vector2(Vector2::Zero()));
  EXPECT_NEAR(plane.off, 0.03, 1e-12);
}

}  // namespace
}  // namespace hexagait::footstep_gen

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/walk/referee/path_judge.hpp>
#include <numbers>

namespace hexagait::walk {
namespace {

using path_following::Path;
using path_following::PathTask;
using path_following::Shape;

// 2 m ahead, 1 m to the left, seen from where a robot stands at (5, 1) and looks along y.
const PlanarPose kStart = {0.5 * std::numbers::pi, {5.0, 1.0}};
PathTask corner() {
  return {Path({{{0.0, 0.0}}, {{2.0, 0.0}}, {{2.0, 1.0}}}, Shape::lines, false), {}, 1, 0.2};
}

// Along the first piece, 3 cm to its left; odometry takes it to be 1 cm to its right.
TEST(PathJudge, MeasuresFromThePathWhereverItLies) {
  const PathTask task = corner();
  PathJudge judge(task, kStart);
  ReferencePath::Deviation deviation;
  for (int k = 0; k <= 100; ++k)
    deviation = judge.observe(kStart * PlanarPose{0.1, {0.01 * k, 0.03}}, {0.0, {0.01 * k, -0.01}});
  EXPECT_NEAR(deviation.lateral, 0.03, 1e-9);
  EXPECT_NEAR(deviation.progress, 1.0, 1e-9);
  EXPECT_NEAR(deviation.heading, 0.1, 1e-9);
  const PathSummary summary = judge.summary();
  EXPECT_NEAR(summary.done, 1.0, 1e-9);
  EXPECT_NEAR(summary.length, 3.0, 1e-9);
  EXPECT_NEAR(summary.believed_mean, 0.01, 1e-9);
  EXPECT_NEAR(summary.missed, 0.03, 1e-9);
  EXPECT_TRUE(judge.ideal().shift.isApprox(Vector2(5.0, 2.0)));
}

// It cuts the corner from (1.8, 0) to (2, 0.2): misses it by 0.2 / √2.
TEST(PathJudge, SeesACornerThatWasCut) {
  const PathTask task = corner();
  PathJudge judge(task, kStart);
  const auto walk = [&](const Vector2& from, const Vector2& to) {
    for (int k = 0; k <= 100; ++k) {
      const PlanarPose X_PB{0.0, from + 0.01 * k * (to - from)};
      static_cast<void>(judge.observe(kStart * X_PB, X_PB));
    }
  };
  walk({0.0, 0.0}, {1.8, 0.0});
  walk({1.8, 0.0}, {2.0, 0.2});
  walk({2.0, 0.2}, {2.0, 1.0});
  EXPECT_NEAR(judge.summary().missed, 0.2 / std::sqrt(2.0), 0.003);
  EXPECT_NEAR(judge.summary().done, 3.0, 1e-9);
  EXPECT_NEAR(judge.summary().off_end, 0.0, 1e-9);
}

// Before it is at the first point it is not judged, and gets on as it comes nearer.
TEST(PathJudge, WaitsForTheFirstPoint) {
  PathTask task = corner();
  PathJudge judge(task, {});
  const auto far = judge.observe({0.0, {-1.0, 0.0}}, {}),
             near = judge.observe({0.0, {-0.5, 0.0}}, {});
  EXPECT_FALSE(judge.on_path());
  EXPECT_EQ(far.lateral, 0.0);
  EXPECT_NEAR(near.progress - far.progress, 0.5, 1e-12);
  static_cast<void>(judge.observe({0.0, {0.0, 0.01}}, {}));
  EXPECT_TRUE(judge.on_path());
}

}  // namespace
}  // namespace hexagait::walk

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <hexagait/urdf/urdf.hpp>
#include <string>
#include <testing/executor_scene.hpp>
#include <testing/source_path.hpp>

namespace hexagait {
namespace {

using testing::kDt;
using testing::Scene;

// A standing robot of which one measured foot is below its set point, and what the tick makes of the
// set points, along the body's z.
LegArray<double> changes_with_a_low_foot(LegId low, double by, double rate, LegSet in_air = {},
                                         const char* robot = "argos") {
  const RobotModel model =
      load_urdf(testing::source_path("robots/" + std::string(robot) + ".urdf"));
  const LegId n = model.num_legs();
  Scene scene(model);
  ExecutorParams params;
  params.swing.even_load_rate = rate;
  scene.executor = Executor(model, params);
  scene.executor.reset(scene.state);
  for (LegId i = 0; i < n; ++i)
    if (in_air.contains(i))
      scene.executor.command(FootstepCommand{i, scene.state.p_OF[i], 0.1}, scene.state);
  for (int tick = 0; tick < 60; ++tick) {  // all feet are where they should be
    for (LegId i = 0; i < n; ++i) scene.state.p_BF[i] = scene.executor.legs()[i].p_BF;
    static_cast<void>(scene.executor.advance(scene.state, kDt));
  }
  LegArray<double> before(n), change(n);
  for (LegId i = 0; i < n; ++i) {
    scene.state.p_BF[i] = scene.executor.legs()[i].p_BF;
    before[i] = scene.executor.legs()[i].p_BF.z();
  }
  scene.state.p_BF[low].z() -= by;
  static_cast<void>(scene.executor.advance(scene.state, kDt));
  for (LegId i = 0; i < n; ++i) change[i] = scene.executor.legs()[i].p_BF.z() - before[i];
  return change;
}

TEST(EvenLoads, LowerAFootThatCarriesTooLittle) {
  const LegArray<double> change = changes_with_a_low_foot(2, 0.003, 2.0);
  const double share = 1.0 - std::exp(-2.0 * kDt);
  for (LegId i = 0; i < 6; ++i)
    EXPECT_NEAR(change[i], share * 0.003 * (i == 2 ? -5.0 / 6.0 : 1.0 / 6.0), 1e-9) << i;
  for (const double none : changes_with_a_low_foot(2, 0.003, 0.0)) EXPECT_EQ(none, 0.0);
}

TEST(EvenLoads, LeaveTheMeanHeightOfTheFeet) {
  for (LegId low = 0; low < 6; ++low) {
    double sum = 0.0;
    for (const double change : changes_with_a_low_foot(low, 0.004, 20.0)) sum += change;
    EXPECT_NEAR(sum, 0.0, 1e-12) << low;
  }
}

// The share of the low foot is that among the three feet that stand.
TEST(EvenLoads, AreTakenOverTheFeetThatBear) {
  LegSet in_air;
  for (const LegId i : {0, 3, 4}) in_air.insert(i);
  const LegArray<double> change = changes_with_a_low_foot(1, 0.003, 2.0, in_air);
  const double share = 1.0 - std::exp(-2.0 * kDt);
  for (const LegId i : {1, 2, 5})
    EXPECT_NEAR(change[i], share * 0.003 * (i == 1 ? -2.0 / 3.0 : 1.0 / 3.0), 1e-9) << i;
}

// Three feet can't share their loads otherwise. On all four it evens them out as on six.
TEST(EvenLoads, AreLeftToTheThreeFeetOfACrawl) {
  for (const LegId i : {0, 1, 3})
    EXPECT_EQ(changes_with_a_low_foot(1, 0.003, 20.0, LegSet(1U << 2), "quadruped")[i], 0.0) << i;
  const LegArray<double> on_four = changes_with_a_low_foot(1, 0.003, 2.0, {}, "quadruped");
  const double share = 1.0 - std::exp(-2.0 * kDt);
  for (LegId i = 0; i < 4; ++i)
    EXPECT_NEAR(on_four[i], share * 0.003 * (i == 1 ? -3.0 / 4.0 : 1.0 / 4.0), 1e-9) << i;
}

}  // namespace
}  // namespace hexagait

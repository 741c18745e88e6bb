// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/sim2d/genghis_controller.hpp>
#include <testing/counted_allocations.hpp>

namespace hexagait::sim2d {
namespace {

using hexagait::testing::allocations;
using hexagait::testing::deallocations;

TEST(Counter, SeesAnAllocation) {
  const long before = allocations;
  double* volatile block = new double(1.0);
  EXPECT_EQ(allocations, before + 1);
  delete block;
}

// Every gait, over a step, where all reflexes act; the world's own allocations are not counted.
TEST(GenghisController, NeitherAllocatesNorFreesInATick) {
  const GenghisModel model;
  LegArray<GenghisJoints> q(kGenghisLegs);
  for (LegId i = 0; i < kGenghisLegs; ++i) q[i] = joints_for(model, i, centre(model, i));
  for (const char* gait : {"free", "unadjusted", "literal", "tripod", "wave:0.6"}) {
    GenghisWorld world(model, parse_terrain2d("step:0.1"), {}, q);
    GenghisParams params;
    params.gait = gait_state::parse_gait_choice(gait).value();
    GenghisController controller(model, params);
    GenghisMeasurement measurement;
    world.read(measurement);
    controller.start(measurement);
    long in_ticks = 0;
    int lifts = 0;
    for (int k = 0; k < 4000; ++k) {
      const long before = allocations + deallocations;
      const GenghisRecord& record = controller.tick(measurement);
      in_ticks += allocations + deallocations - before;
      lifts += record.decision.lifts.size();
      world.write(record.targets);
      world.read(measurement);
    }
    EXPECT_EQ(in_ticks, 0) << gait;
    EXPECT_GT(lifts, 5) << gait;
  }
}

}  // namespace
}  // namespace hexagait::sim2d

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <hexagait/model/kinematics.hpp>
#include <hexagait/sim3d/world.hpp>
#include <testing/argos.hpp>
#include <testing/counted_allocations.hpp>

namespace hexagait::sim3d {
namespace {

// What ODE takes from its allocator, and anyone from operator new.
using hexagait::testing::allocations;

TEST(World, AllocatesNothingOnceItHasMadeItsFirstContacts) {
  const RobotModel robot = testing::argos();
  LegArray<LegJoints> q(6, LegJoints::Zero());
  for (LegId leg = 0; leg < 6; ++leg) {
    q[leg] = inverse_kinematics(robot.legs[leg], robot.legs[leg].p_BC).q;
  }
  dSetAllocHandler(&testing::counted_malloc);
  for (const char* terrain : {"flat", "boxes:0.05"}) {
    World world(robot, parse_terrain(terrain), {}, q);
    JointTargets targets{q, LegArray<LegJoints>(6, LegJoints::Zero()),
                         LegArray<LegJoints>(6, LegJoints::Zero())};
    Measurement measurement;
    for (int k = 0; k < 50; ++k) world.write(targets);

    const long before = allocations;
    EXPECT_GT(before, 0);
    for (int k = 0; k < 500; ++k) {
      world.read(measurement);
      targets.q[0][1] = q[0][1] - (k % 100 < 50 ? 0.2 : 0.0);  // one leg steps on the spot
      world.write(targets);
    }
    EXPECT_EQ(allocations, before);
  }
  dSetAllocHandler(nullptr);
}

}  // namespace
}  // namespace hexagait::sim3d

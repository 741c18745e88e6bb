// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/footstep_gen/walker.hpp>
#include <limits>
#include <memory>
#include <testing/counted_allocations.hpp>
#include <testing/kinematic_plant.hpp>

namespace hexagait::footstep_gen {
namespace {

using heading_control::Heading;
using hexagait::testing::allocations;
using hexagait::testing::deallocations;

// Does the counter count? (The pointer is volatile, so that no optimiser removes the pair.)
TEST(Counter, SeesAnAllocation) {
  const long before = allocations;
  double* volatile block = new double(1.0);
  EXPECT_EQ(allocations, before + 1);
  delete block;
}

// 2000 ticks, of which the first is the first after start: headings change, in the middle of steps
// too, the gait is turned, periods are late, the walker stops and goes on and comes to a fault.
TEST(Walker, NeitherAllocatesNorFreesInATick) {
  for (const int n : {6, 12}) {
    const RobotModel robot = testing::robot_of(n);
    testing::KinematicPlant plant(robot, 0.7, {.seed = 15});
    RandomSequence random{.seed = 15, .stream = RandomStream::commands};
    Walker walker(robot);
    walker.start(plant.measurement);
    int lifts = 0;
    const long allocated = allocations, freed = deallocations;
    Heading heading = Heading::straight(0.0);
    for (int k = 0; k < 2000; ++k) {
      if (k % 170 == 0) heading = Heading::arc(random.uniform(0.1, 2.0), random.uniform(-3, 3));
      if (k % 400 == 200)
        walker.set_stepping({.stepping = static_cast<gait_state::Stepping>(k / 400 % 3),
                             .duty_factor = random.uniform(0.5, 0.9)});
      if (k % 300 == 299) heading = heading.stopped();
      const PlantStatus status = k % 50 == 49 ? PlantStatus::late : PlantStatus::fresh;
      plant.follow(walker.tick(status, plant.measurement, heading), 0.002);
      lifts += walker.record().lifts.size();
    }
    const Fault fault = walker.record().fault;
    plant.measurement.q[1][1] = std::numeric_limits<double>::quiet_NaN();
    walker.tick(PlantStatus::fresh, plant.measurement, heading);
    const long allocated_now = allocations, freed_now = deallocations;
    EXPECT_EQ(allocated_now, allocated) << n << " legs";
    EXPECT_EQ(freed_now, freed) << n << " legs";
    EXPECT_EQ(fault, Fault::none);
    EXPECT_EQ(walker.record().fault, Fault::bad_measurement);
    EXPECT_GT(lifts, 5) << "it did walk";
  }
}

}  // namespace
}  // namespace hexagait::footstep_gen

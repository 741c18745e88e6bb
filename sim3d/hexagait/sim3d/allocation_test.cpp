// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <atomic>
#include <cstdlib>
#include <hexagait/core/kinematics.hpp>
#include <hexagait/sim3d/world.hpp>
#include <new>

// Counts what ODE takes from its allocator and what anyone takes from operator new.

namespace {

std::atomic<long> allocations = 0;

void* counted(std::size_t size) {
  ++allocations;
  return std::malloc(size);
}

}  // namespace

// Not inlined: GCC would see free() meet operator new, and warn.
[[gnu::noinline]] void* operator new(std::size_t size) {
  if (void* block = counted(size)) return block;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return counted(size);
}
[[gnu::noinline]] void operator delete(void* block) noexcept { std::free(block); }
[[gnu::noinline]] void operator delete(void* block, std::size_t) noexcept { std::free(block); }

namespace hexagait::sim3d {
namespace {

TEST(World, AllocatesNothingOnceItHasMadeItsFirstContacts) {
  const RobotModel robot = load_urdf(HEXAGAIT_SOURCE_DIR "/robots/argos.urdf");
  LegArray<LegJoints> q(6, Vector3::Zero());
  for (LegId leg = 0; leg < 6; ++leg) {
    q[leg] = inverse_kinematics(robot.legs[leg], robot.legs[leg].p_BC).q;
  }
  dSetAllocHandler(&counted);
  for (const char* terrain : {"flat", "boxes:0.05"}) {
    World world(robot, parse_terrain(terrain), {}, q);
    JointTargets targets{q, LegArray<LegJoints>(6, Vector3::Zero()),
                         LegArray<LegJoints>(6, Vector3::Zero())};
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

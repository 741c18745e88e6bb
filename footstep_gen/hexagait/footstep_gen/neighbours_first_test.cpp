// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/footstep_gen/neighbours_first.hpp>

namespace hexagait::footstep_gen::neighbours_first_test {
namespace {

constexpr LegId kLF = 0, kLM = 2, kLR = 4, kRR = 5;
constexpr LegSet one(LegId leg) { return LegSet(1U << leg); }

struct Scene {
  gait_state::Ring ring = 6;
  NeighboursFirst first;

  LegSet tick(LegSet in_air = {}) { return first.update(without(ring.present(), in_air), ring); }
  LegSet step(LegId leg) {
    tick(one(leg));
    return tick();
  }
};

TEST(NeighboursFirst, HoldALegUntilBothOfThemHaveStepped) {
  Scene scene;
  scene.first.hold(one(kLM), scene.ring);
  EXPECT_EQ(scene.tick(), one(kLM));
  EXPECT_EQ(scene.step(kRR), one(kLM)) << "no neighbour";
  EXPECT_EQ(scene.step(kLF), one(kLM));
  EXPECT_EQ(scene.tick(one(kLR)), one(kLM)) << "it does not stand yet";
  EXPECT_TRUE(scene.tick().empty());
}

TEST(NeighboursFirst, DoNotWaitForEachOther) {
  Scene scene;
  scene.first.hold(one(kLM) | one(kLR), scene.ring);
  EXPECT_EQ(scene.step(kLF), one(kLR));
  EXPECT_TRUE(scene.step(kRR).empty());
}

TEST(NeighboursFirst, BeginAnewWhenALegIsHeldAgain) {
  Scene scene;
  for (int time = 0; time < 2; ++time) {
    scene.first.hold(one(kLM), scene.ring);
    EXPECT_EQ(scene.step(kLF), one(kLM));
    EXPECT_TRUE(scene.step(kLR).empty());
  }
}

TEST(NeighboursFirst, DoNotWaitForALegThatIsLost) {
  Scene scene;
  scene.first.hold(one(kLM), scene.ring);
  EXPECT_EQ(scene.step(kLF), one(kLM));
  scene.ring.lost = one(kLR);
  EXPECT_TRUE(scene.tick().empty());
  scene.first.hold(one(kLM), scene.ring);
  EXPECT_EQ(scene.step(kLF), one(kLM));
  EXPECT_TRUE(scene.step(kRR).empty()) << "the ring has closed";
}

TEST(NeighboursFirst, ReleaseWhoIsToWaitNoLonger) {
  Scene scene;
  scene.first.hold(one(kLM) | one(kRR), scene.ring);
  scene.first.release(one(kLM));
  EXPECT_EQ(scene.tick(), one(kRR));
}

}  // namespace
}  // namespace hexagait::footstep_gen::neighbours_first_test

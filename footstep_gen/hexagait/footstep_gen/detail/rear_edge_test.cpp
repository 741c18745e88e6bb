// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/footstep_gen/detail/rear_edge.hpp>
#include <hexagait/gait_state/ring.hpp>
#include <hexagait/gait_state/stepper.hpp>
#include <testing/kinematic_plant.hpp>
#include <vector>

namespace hexagait::footstep_gen {
namespace {

using heading_control::Heading;
using heading_control::Turn;

const Stance& stance_of(int n) {
  static const auto all = [] {
    std::vector<Stance> robots(kMaxLegs + 1);
    for (std::size_t legs = 4; legs <= kMaxLegs; legs += 2)
      robots[legs] = nominal_stance(testing::robot_of(static_cast<int>(legs)));
    return robots;
  }();
  return all[static_cast<std::size_t>(n)];
}

int edge_for(const Heading& heading, int n, int present) {
  return rear_edge(path_arc(heading, stance_of(n)), present);
}

LegSet pair_at(int edge, int n) {
  LegSet legs;
  legs.insert(gait_state::leg_at(edge, n));
  legs.insert(gait_state::leg_at((edge + 1) % n, n));
  return legs;
}

// Legs are numbered from the front: ahead, the rear ones are the last two; backwards, the first.
TEST(RearEdge, JoinsTheTwoLegsFarthestAgainstTheMotion) {
  for (const int n : {4, 6, 8, 10, 12}) {
    EXPECT_EQ(edge_for(Heading::straight(0.0), n, 0), gait_state::hindmost_edge(n));
    EXPECT_EQ(pair_at(edge_for(Heading::straight(0.0), n, 0), n).bits(), 0b11U << (n - 2));
    EXPECT_EQ(pair_at(edge_for(Heading::straight(std::numbers::pi), n, 2), n).bits(), 0b11U);
  }
}

// Crabbing to the left leaves the right legs behind, which are the odd ones; to the right, the
// left.
TEST(RearEdge, LiesOnTheSideFromWhichTheRobotCrabs) {
  for (const int n : {4, 6, 8, 10, 12}) {
    const std::uint32_t right = 0xAAAU, left = 0x555U;
    EXPECT_EQ(
        pair_at(edge_for(Heading::straight(0.5 * std::numbers::pi), n, n / 2), n).bits() & left,
        0U);
    EXPECT_EQ(
        pair_at(edge_for(Heading::straight(-0.5 * std::numbers::pi), n, n / 2), n).bits() & right,
        0U);
  }
}

TEST(RearEdge, StaysOnASpinWhereNoLegIsBehind) {
  for (const int n : {4, 6, 12})
    for (int present = 0; present < n; ++present) {
      EXPECT_EQ(edge_for(Heading::spin(Turn::ccw), n, present), present);
      EXPECT_EQ(edge_for(Heading::arc(0.001, 0.0), n, present), present);
    }
}

// Once round the compass and back again, in steps of a degree. Each of the pairs that are ever the
// rear one hands over once each way, and later than half-way: what it was, it stays a little
// longer.
TEST(RearEdge, HandsOverLateSoThatNoDirectionMakesItFlicker) {
  for (const int n : {4, 6, 8}) {
    int edge = edge_for(Heading::straight(0.0), n, 0);
    const int start = edge;
    std::vector<int> there, back;
    for (int degree = 0; degree <= 720; ++degree) {
      const double alpha = std::numbers::pi / 180.0 * (degree <= 360 ? degree : 720 - degree);
      const int now = edge_for(Heading::straight(alpha), n, edge);
      if (now != edge)
        (degree <= 360 ? there : back).push_back(degree <= 360 ? degree : 720 - degree);
      edge = now;
      EXPECT_EQ(edge_for(Heading::straight(alpha), n, edge), edge) << "settled at once";
    }
    EXPECT_EQ(edge, start);
    EXPECT_GE(there.size(), 2U) << "forwards and backwards have other rear legs";
    ASSERT_EQ(there.size(), back.size()) << n;
    for (std::size_t k = 0; k < there.size(); ++k) {
      const int on_the_way_back = back[back.size() - 1 - k];
      EXPECT_GT(there[k], on_the_way_back + 2) << n << " legs, change " << k;
    }
  }
}

}  // namespace
}  // namespace hexagait::footstep_gen

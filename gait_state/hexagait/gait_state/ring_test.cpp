// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdlib>
#include <hexagait/gait_state/ring.hpp>
#include <vector>

namespace hexagait::gait_state::ring_test {
namespace {

constexpr int kRings[] = {4, 6, 8, 10, 12};

// Neighbours by what they are on the robot, not by the ring: one behind the other on the same side,
// or the two of the front or of the rear row.
bool are_neighbours(LegId a, LegId b, int n) {
  const bool same_row = a / 2 == b / 2;
  const bool end_row = a / 2 == 0 || a / 2 == n / 2 - 1;
  return std::abs(a - b) == 2 || (a != b && same_row && end_row);
}

// [PC04] Fig. 2: 1, 2, 4, 6, 5, 3; our legs count from 0.
TEST(Ring, OfSixLegsIsThePapersCircuit) {
  constexpr LegId kPaper[] = {1, 2, 4, 6, 5, 3};
  for (int k = 0; k < 6; ++k) EXPECT_EQ(leg_at(k, 6) + 1, kPaper[k]) << "position " << k;
}

TEST(Ring, IsUsableInConstantExpressions) {
  static_assert(leg_at(3, 6) == 5 && position_of(5, 6) == 3);
  static_assert(first_tripod(6) == LegSet(0b011001) && second_tripod(6) == LegSet(0b100110));
  static_assert(breaks_rule_1(LegSet(0b000011), 6) && !breaks_rule_1(first_tripod(6), 6));
  static_assert(!is_ring_size(2) && is_ring_size(4) && !is_ring_size(7) && is_ring_size(12));
}

// Clockwise from above with leg 0 front left: the next leg is front right, the last one middle
// left.
TEST(Ring, VisitsEachLegOnceFromNeighbourToNeighbourClockwise) {
  for (const int n : kRings) {
    LegSet visited;
    for (int k = 0; k < n; ++k) {
      visited.insert(leg_at(k, n));
      EXPECT_EQ(position_of(leg_at(k, n), n), k);
      EXPECT_TRUE(are_neighbours(leg_at(k, n), leg_at((k + 1) % n, n), n)) << n << " legs, " << k;
    }
    EXPECT_EQ(visited, LegSet::all(n));
    EXPECT_EQ(leg_at(0, n), 0);
    EXPECT_EQ(leg_at(1, n), 1);
  }
}

TEST(Ring, NeighboursAreThoseBesideTheLeg) {
  for (const int n : kRings) {
    for (LegId leg = 0; leg < n; ++leg) {
      LegSet expected;
      for (LegId other = 0; other < n; ++other) {
        if (are_neighbours(leg, other, n)) expected.insert(other);
      }
      const Neighbours both = neighbours_of(leg, n);
      EXPECT_EQ(LegSet((1U << both.before) | (1U << both.after)), expected);
      EXPECT_EQ(neighbours_of(LegSet(1U << leg), n), expected);
      EXPECT_EQ(neighbours_of(both.before, n).after, leg);
      EXPECT_EQ(neighbours_of(both.after, n).before, leg);
    }
  }
}

TEST(Ring, NeighboursOfASetAreTheUnionOfItsMembersNeighbours) {
  for (const int n : kRings) {
    for (std::uint32_t bits = 0; bits < (1U << n); ++bits) {
      LegSet expected;
      for (LegId leg = 0; leg < n; ++leg) {
        if (LegSet(bits).contains(leg)) expected = expected | neighbours_of(LegSet(1U << leg), n);
      }
      ASSERT_EQ(neighbours_of(LegSet(bits), n), expected);
    }
  }
}

TEST(Rule1, IsBrokenExactlyByTwoNeighboursInTheAir) {
  for (const int n : kRings) {
    for (std::uint32_t bits = 0; bits < (1U << n); ++bits) {
      bool expected = false;
      for (LegId a = 0; a < n; ++a) {
        for (LegId b = 0; b < a; ++b) {
          const bool both = LegSet(bits).contains(a) && LegSet(bits).contains(b);
          expected |= both && are_neighbours(a, b, n);
        }
      }
      ASSERT_EQ(breaks_rule_1(LegSet(bits), n), expected) << n << " legs, set " << bits;
    }
  }
}

// Of the sets that keep rule 1 only the two tripods have n/2 legs: each of the n/2 disjoint pairs
// of neighbours gives at most one.
TEST(Tripods, AreTheTwoLargestSetsThatKeepRule1) {
  for (const int n : kRings) {
    for (std::uint32_t bits = 0; bits < (1U << n); ++bits) {
      const LegSet set(bits);
      const bool is_tripod = set == first_tripod(n) || set == second_tripod(n);
      ASSERT_EQ(!breaks_rule_1(set, n) && set.size() >= n / 2, is_tripod);
    }
    EXPECT_EQ(first_tripod(n) | second_tripod(n), LegSet::all(n));
    EXPECT_TRUE(first_tripod(n).contains(0));
  }
}

TEST(Ring, ConvertsSetsOfLegsToPositionsAndBack) {
  for (const int n : kRings) {
    for (std::uint32_t bits = 0; bits < (1U << n); ++bits) {
      ASSERT_EQ(legs_at(ring_bits(LegSet(bits), n), n), LegSet(bits));
    }
  }
}

// Independently of bits: the order of the whole ring, without those that are lost.
TEST(Ring, ClosesOverLostLegsInTheSameOrder) {
  for (const int n : {4, 6, 8}) {
    for (std::uint32_t lost = 0; lost < (1U << n); ++lost) {
      const Ring ring(n, LegSet(lost));
      if (ring.size() < 3) continue;
      std::vector<LegId> order;
      for (int k = 0; k < n; ++k)
        if (!ring.lost.contains(leg_at(k, n))) order.push_back(leg_at(k, n));
      ASSERT_EQ(static_cast<int>(order.size()), ring.size());
      std::vector<LegId> backwards;
      for_each_backwards(ring, [&](LegId leg) { backwards.insert(backwards.begin(), leg); });
      EXPECT_EQ(backwards, order) << n << " legs, lost " << lost;
      for (int k = 0; k < ring.size(); ++k) {
        const auto at = [&](int j) {
          return order[static_cast<std::size_t>((j + ring.size()) % ring.size())];
        };
        EXPECT_EQ(leg_at(k, ring), at(k)) << n << " legs, lost " << lost;
        EXPECT_EQ(position_of(at(k), ring), k);
        EXPECT_EQ(neighbours_of(at(k), ring).before, at(k - 1));
        EXPECT_EQ(neighbours_of(at(k), ring).after, at(k + 1));
      }
    }
  }
}

// Without leg 3 (right middle) legs 1 and 5 are neighbours, and leg 3 counts for nothing.
TEST(Ring, LegsBesideALostOneAreNeighbours) {
  constexpr Ring kRing(6, LegSet(0b001000));
  static_assert(kRing.size() == 5 && kRing.present() == LegSet(0b110111));
  static_assert(breaks_rule_1(LegSet(0b100010), kRing) && !breaks_rule_1(LegSet(0b100010), 6));
  static_assert(!breaks_rule_1(LegSet(0b001010), kRing) && breaks_rule_1(LegSet(0b001010), 6));
  static_assert(legs_at(ring_bits(LegSet(0b111111), kRing), kRing) == kRing.present());
  static_assert(neighbours_of(LegSet(0b000010), kRing) == LegSet(0b100001));
}

}  // namespace
}  // namespace hexagait::gait_state::ring_test

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/math/leg.hpp>
#include <string>

namespace hexagait {
namespace {

/// Counts how often one of them is copied.
struct Counted {
  Counted() = default;
  Counted(const Counted&) { ++copies; }
  Counted& operator=(const Counted&) {
    ++copies;
    return *this;
  }
  static inline int copies = 0;
};

TEST(InlineArray, IsCopiedAsFarAsItIsUsed) {
  const LegArray<Counted> six(6);
  Counted::copies = 0;
  LegArray<Counted> copy = six;
  EXPECT_EQ(Counted::copies, 6);
  EXPECT_EQ(copy.size(), 6);
  copy = LegArray<Counted>(4);
  EXPECT_EQ(Counted::copies, 10);
  EXPECT_EQ(copy.size(), 4);
}

TEST(InlineArray, HoldsItsOwnValues) {
  JointArray<std::string> names(3, "hip, of a name that is too long to be stored in place");
  JointArray<std::string> copy = names;
  names[1] = "knee";
  EXPECT_EQ(copy[1], copy[0]);
  copy = names;
  EXPECT_EQ(copy[1], "knee");
  const JointArray<std::string>& itself = copy;
  copy = itself;
  EXPECT_EQ(copy[1], "knee");
  const JointArray<std::string> moved = std::move(copy);
  EXPECT_EQ(moved[1], "knee");
  EXPECT_EQ(moved.size(), 3);
}

TEST(InlineArray, OfNumbersBeginsWithZeros) {
  for (const double value : LegArray<double>(kMaxLegs)) EXPECT_EQ(value, 0.0);
  for (const bool value : LegArray<bool>(kMaxLegs)) EXPECT_FALSE(value);
}

}  // namespace
}  // namespace hexagait

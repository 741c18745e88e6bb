// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/executor/felt_while_held.hpp>

namespace hexagait {
namespace {

constexpr LegSet kNone, kLF(0b000001), kRF(0b000010), kAll(0b111111);
const Vector3 kRoll(0.003, 0.0, 0.0), kPitch(0.0, 0.004, 0.0);

Vector3 sum_of(FeltWhileHeld& felt, int ticks, LegSet held, LegSet stand) {
  Vector3 sum = Vector3::Zero();
  for (int k = 0; k < ticks; ++k) sum += felt.update(kRoll, held, stand, kNone);
  return sum;
}

TEST(FeltWhileHeld, PassesAllOnWhileNoLegIsHeld) {
  FeltWhileHeld felt(6);
  EXPECT_NEAR(sum_of(felt, 100, kNone, without(kAll, kLF)).x(), 0.3, 1e-12);
  EXPECT_EQ(felt.update(Vector3::Zero(), kNone, kAll, kLF), Vector3::Zero()) << "it was not held";
}

// Also in ticks in which it follows: it tries again and again.
TEST(FeltWhileHeld, IsBoundedFromTheFirstTimeThatALegIsHeldUntilItStands) {
  FeltWhileHeld felt(6);
  const double before = sum_of(felt, 5, kLF, without(kAll, kLF)).x();
  const double after = sum_of(felt, 100, kNone, without(kAll, kLF)).x();
  EXPECT_NEAR(before + after, 0.039, 1e-12);
  EXPECT_EQ(felt.update(-kRoll, kNone, without(kAll, kLF), kNone), -kRoll) << "back is possible";
  EXPECT_NEAR(sum_of(felt, 100, kNone, kAll).x(), 0.3, 1e-12);
}

TEST(FeltWhileHeld, TakesBackWhatWasFeltWhileALegWasHeldThatIsLost) {
  FeltWhileHeld felt(6);
  (void)felt.update(kPitch, kNone, without(kAll, kLF), kNone);
  Vector3 sum = felt.update(kRoll, kLF, without(kAll, kLF | kRF), kNone);
  sum += felt.update(kPitch, kRF, without(kAll, kLF | kRF), kNone);
  EXPECT_EQ(sum, kRoll + kPitch);
  EXPECT_EQ(felt.update(kPitch, kLF, without(kAll, kLF | kRF), kLF), -sum + kPitch);
  EXPECT_EQ(felt.update(kPitch, kLF, without(kAll, kLF | kRF), kLF), kPitch) << "once";
}

}  // namespace
}  // namespace hexagait

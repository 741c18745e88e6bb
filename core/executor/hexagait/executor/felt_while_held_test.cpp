// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/executor/felt_while_held.hpp>

namespace hexagait {
namespace {

constexpr LegSet kNone, kLF(0b000001), kRF(0b000010), kAll(0b111111);
constexpr double kTick = 0.002, kFoundAfter = 1.0;
const Vector3 kRoll(0.003, 0.0, 0.0), kPitch(0.0, 0.004, 0.0);

Vector3 sum_of(FeltWhileHeld& felt, int ticks, LegSet held, LegSet stand) {
  Vector3 sum = Vector3::Zero();
  for (int k = 0; k < ticks; ++k) sum += felt.update(kRoll, held, stand, kNone, kTick, kFoundAfter);
  return sum;
}

TEST(FeltWhileHeld, PassesAllOnWhileNoLegIsHeld) {
  FeltWhileHeld felt(6);
  EXPECT_NEAR(sum_of(felt, 100, kNone, without(kAll, kLF)).x(), 0.3, 1e-12);
  EXPECT_EQ(felt.update(Vector3::Zero(), kNone, kAll, kLF, kTick, kFoundAfter), Vector3::Zero())
      << "it was not held";
}

// Also in ticks in which it follows: it tries again and again.
TEST(FeltWhileHeld, IsBoundedFromTheFirstTimeThatALegIsHeldUntilItStands) {
  FeltWhileHeld felt(6);
  const double before = sum_of(felt, 5, kLF, without(kAll, kLF)).x();
  const double after = sum_of(felt, 100, kNone, without(kAll, kLF)).x();
  EXPECT_NEAR(before + after, 0.039, 1e-12);
  EXPECT_EQ(felt.update(-kRoll, kNone, without(kAll, kLF), kNone, kTick, kFoundAfter), -kRoll)
      << "back is possible";
  EXPECT_NEAR(sum_of(felt, 100, kNone, kAll).x(), 0.3, 1e-12);
}

// A caught leg hangs for long: a robot whose up is wrong would not get free of it.
TEST(FeltWhileHeld, FeelsAllOnceALegIsHeldForLongerThanALostOneWouldBe) {
  for (const double dt : {0.001, 0.002, 0.02}) {
    FeltWhileHeld felt(6);
    const auto x = [&](double seconds) {
      Vector3 sum = Vector3::Zero();
      for (int k = 0; k < static_cast<int>(seconds / dt); ++k)
        sum += felt.update(kRoll, kLF, without(kAll, kLF), kNone, dt, kFoundAfter);
      return sum.x();
    };
    EXPECT_NEAR(x(0.96), 0.039, 1e-12) << dt;
    EXPECT_GT(x(4.0), 3.8 / dt * kRoll.x()) << dt;
  }
}

TEST(FeltWhileHeld, TakesBackWhatWasFeltWhileALegWasHeldThatIsLost) {
  FeltWhileHeld felt(6);
  (void)felt.update(kPitch, kNone, without(kAll, kLF), kNone, kTick, kFoundAfter);
  Vector3 sum = felt.update(kRoll, kLF, without(kAll, kLF | kRF), kNone, kTick, kFoundAfter);
  sum += felt.update(kPitch, kRF, without(kAll, kLF | kRF), kNone, kTick, kFoundAfter);
  EXPECT_EQ(sum, kRoll + kPitch);
  EXPECT_EQ(felt.update(kPitch, kLF, without(kAll, kLF | kRF), kLF, kTick, kFoundAfter),
            -sum + kPitch);
  EXPECT_EQ(felt.update(kPitch, kLF, without(kAll, kLF | kRF), kLF, kTick, kFoundAfter), kPitch)
      << "once";
}

}  // namespace
}  // namespace hexagait

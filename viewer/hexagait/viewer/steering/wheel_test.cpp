// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/viewer/steering/wheel.hpp>

namespace hexagait::viewer {
namespace {

using std::chrono::milliseconds;

const Clock::time_point kStart = Clock::time_point() + std::chrono::hours(1);

// Two clients, of which the first steers.
Wheel wheel() {
  Wheel result;
  result.enter(1, kStart);
  result.enter(2, kStart);
  EXPECT_TRUE(result.take(1, kStart));
  return result;
}

TEST(Wheel, IsHeldByTheFirstWhoSteers) {
  Wheel w = wheel();
  EXPECT_FALSE(w.take(2, kStart + milliseconds(100)));
  EXPECT_TRUE(w.take(1, kStart + milliseconds(100)));
  EXPECT_EQ(w.holder(), 1U);
}

TEST(Wheel, IsFreeOnceItsHolderLetsGoOrLeaves) {
  Wheel w = wheel();
  w.release(2);  // it does not hold it
  EXPECT_EQ(w.holder(), 1U);
  w.release(1);
  EXPECT_TRUE(w.take(2, kStart));
  EXPECT_FALSE(w.leave(1));
  EXPECT_TRUE(w.leave(2));
  EXPECT_EQ(w.holder(), 0U);
}

TEST(Wheel, NoticesSilenceAfterHalfASecond) {
  Wheel w = wheel();
  EXPECT_FALSE(w.is_silent(kStart + milliseconds(500)));
  EXPECT_TRUE(w.is_silent(kStart + milliseconds(501)));
  EXPECT_TRUE(w.hear(1, kStart + milliseconds(600)));
  EXPECT_FALSE(w.is_silent(kStart + milliseconds(1100)));
  EXPECT_TRUE(w.hear(2, kStart + milliseconds(1100)));  // another one's beat is none of its
  EXPECT_TRUE(w.is_silent(kStart + milliseconds(1101)));
}

TEST(Wheel, NobodyIsSilentWhereNobodySteers) {
  Wheel w;
  w.enter(1, kStart);
  EXPECT_FALSE(w.is_silent(kStart + std::chrono::hours(1)));
}

TEST(Wheel, IsTakenFromWhoIsGone) {
  Wheel w = wheel();
  EXPECT_FALSE(w.take(2, kStart + milliseconds(3000)));
  EXPECT_TRUE(w.take(2, kStart + milliseconds(3001)));
}

// 240 at once; then 120 in a second.
TEST(Wheel, HearsNoMoreThanItsRate) {
  Wheel w = wheel();
  int heard = 0;
  for (int k = 0; k < 1000; ++k) heard += w.hear(1, kStart) ? 1 : 0;
  EXPECT_EQ(heard, 240);
  for (int k = 0; k < 1000; ++k) heard += w.hear(1, kStart + milliseconds(k)) ? 1 : 0;
  EXPECT_NEAR(heard, 360, 2);
  EXPECT_FALSE(w.hear(7, kStart));
}

}  // namespace
}  // namespace hexagait::viewer

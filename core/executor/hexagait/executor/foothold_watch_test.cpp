// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <hexagait/executor/foothold_watch.hpp>
#include <testing/round_params.hpp>

namespace hexagait {
namespace {

// Six feet that stand, of which foot 2 slides.
struct SlidingFoot {
  double dt = 0.002;
  SwingParams params = testing::round_params().swing;
  FootholdWatch watch{6};
  LegArray<Vector3> slide_O{6, Vector3::Zero()};
  LegSet stand = LegSet::all(6);

  // Slides with this velocity for so long. Returns when its foothold was first found to give way [s],
  // or a negative number.
  double slide(const Vector3& v, double seconds) {
    double found = -1.0;
    const auto ticks = static_cast<int>(std::lround(seconds / dt));
    for (int k = 1; k <= ticks; ++k) {
      slide_O[2] += dt * v;
      watch.watch(slide_O, stand, dt, params);
      if (found < 0.0 && watch.giving_way().contains(2)) found = k * dt;
    }
    return found;
  }
};

// A foot that slides at v is ahead of its mean by v T (1 − exp(−t/T)): with v = 2 d/T it is by d at
// t = T ln 2, whichever way it goes and whatever the period.
TEST(FootholdWatch, FindsAFootThatSlidesSteadily) {
  for (const double dt : {0.001, 0.002, 0.010, 0.020}) {
    for (const Vector3& way : {Vector3(1.0, 0.0, 0.0), Vector3(0.0, -0.6, -0.8)}) {
      SlidingFoot foot;
      foot.dt = dt;
      const double v = 2.0 * foot.params.slide_distance / foot.params.slide_time;
      EXPECT_NEAR(foot.slide(v * way, 0.3), foot.params.slide_time * std::log(2.0), 1.1 * dt) << dt;
      EXPECT_EQ(foot.watch.giving_way(), LegSet(0b000100)) << "no other";
    }
  }
}

// Half as fast as can ever be found: v T = d/2.
TEST(FootholdWatch, LetsAFootSettleSlowly) {
  SlidingFoot foot;
  const double v = 0.5 * foot.params.slide_distance / foot.params.slide_time;
  EXPECT_LT(foot.slide({v, 0.0, 0.0}, 5.0), 0.0);
}

// After 3 d at once, s − s̄ falls to d within T ln 3.
TEST(FootholdWatch, ForgetsAFootThatStandsAgain) {
  SlidingFoot foot;
  foot.slide_O[2].y() += 3.0 * foot.params.slide_distance;
  EXPECT_GT(foot.slide(Vector3::Zero(), foot.dt), 0.0);
  static_cast<void>(foot.slide(Vector3::Zero(), 0.9 * foot.params.slide_time * std::log(3.0)));
  EXPECT_TRUE(foot.watch.giving_way().contains(2));
  static_cast<void>(foot.slide(Vector3::Zero(), 0.2 * foot.params.slide_time * std::log(3.0)));
  EXPECT_TRUE(foot.watch.giving_way().empty());
}

// What a foot slides while it is put down or lifted says nothing about its next foothold.
TEST(FootholdWatch, BeginsAnewWithEveryFoothold) {
  SlidingFoot foot;
  foot.stand.erase(2);
  EXPECT_LT(foot.slide({1.0, 0.0, 0.0}, 0.1), 0.0);
  foot.stand.insert(2);
  EXPECT_LT(foot.slide(Vector3::Zero(), 0.1), 0.0);
}

// On ice every foot slides, always: the robot must not wait for ever. The patience is each
// foothold's own.
TEST(FootholdWatch, LosesPatienceWithAFootThatSlidesOn) {
  for (const double dt : {0.001, 0.020}) {
    SlidingFoot foot;
    foot.dt = dt;
    const Vector3 v(10.0 * foot.params.slide_distance / foot.params.slide_time, 0.0, 0.0);
    const double found = foot.slide(v, 0.5 * foot.params.slide_patience);
    EXPECT_TRUE(foot.watch.giving_way().contains(2));
    static_cast<void>(foot.slide(v, 0.5 * foot.params.slide_patience + found - 2.0 * dt));
    EXPECT_TRUE(foot.watch.giving_way().contains(2));
    EXPECT_TRUE(foot.watch.bad().empty());
    static_cast<void>(foot.slide(v, 3.0 * dt));
    EXPECT_TRUE(foot.watch.giving_way().empty());
    EXPECT_EQ(foot.watch.bad(), LegSet(1U << 2)) << "it is to leave it";
    static_cast<void>(foot.slide(v, 5.0 * foot.params.slide_patience));
    EXPECT_TRUE(foot.watch.giving_way().empty());

    foot.stand.erase(2);
    static_cast<void>(foot.slide(v, dt));
    EXPECT_TRUE(foot.watch.bad().empty());
    foot.stand.insert(2);
    EXPECT_GT(foot.slide(v, 0.5 * foot.params.slide_patience), 0.0) << "the next foothold";
  }
}

TEST(FootholdWatch, AccusesNobodyIfSlidesAreNotKnown) {
  SlidingFoot foot;
  EXPECT_GT(foot.slide({1.0, 0.0, 0.0}, 0.1), 0.0);
  foot.watch.watch({}, foot.stand, foot.dt, foot.params);
  EXPECT_TRUE(foot.watch.giving_way().empty());
}

}  // namespace
}  // namespace hexagait

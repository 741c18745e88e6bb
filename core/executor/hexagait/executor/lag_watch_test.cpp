// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/executor/lag_watch.hpp>
#include <hexagait/math/quintic.hpp>

namespace hexagait {
namespace {

/// One foot that swings to and fro by 0.35 m in 0.38 s each, behind a drive of a given lag.
struct SwingingFoot {
  double lag;
  double dt;
  LagWatch watch{1, 0.3};
  Vector3 p = Vector3::Zero(), set_point = Vector3::Zero();
  double t = 0.0, worst = 0.0;

  /// @param stopped_at  the foot cannot pass this x [m]
  void tick(double stopped_at = 1.0) {
    watch.watch(0, p, set_point, true, dt);
    worst = std::max(worst, watch.error(0));
    t += dt;
    const double T = 0.38, phase = std::fmod(t, 2.0 * T);
    PointState there;
    there.p.x() = 0.35;
    set_point = phase < T ? quintic({}, there, T, phase).p : quintic(there, {}, T, phase - T).p;
    // The drive within the tick, in small steps.
    for (int k = 0; k < 100; ++k) p += (dt / 100.0) / (lag + dt / 100.0) * (set_point - p);
    p.x() = std::min(p.x(), stopped_at);
  }
  void swing(double seconds) {
    for (const double end = t + seconds; t < end;) tick();
  }
};

// Peak speed 1.73 m/s: with 40 ms the foot is 7 cm behind. Half a centimetre is left for that the
// estimate is a mean, and for the part of a tick.
TEST(LagWatch, TakesNoLagForAnObstacle) {
  for (const double dt : {0.001, 0.002, 0.005, 0.010, 0.020}) {
    for (const double lag : {0.0, 0.005, 0.02, 0.04}) {
      SwingingFoot foot{lag, dt};
      foot.swing(3.0);
      const double before = foot.worst;
      foot.worst = 0.0;
      foot.swing(3.0);
      EXPECT_LT(foot.worst, 0.015) << lag << " s, period " << dt;
      EXPECT_LT(before, 0.03) << "from the start on: " << lag << " s, period " << dt;
    }
  }
}

// Stopped in the middle of the way, at 1.7 m/s: 3 cm behind after 18 ms without lag, and later by at
// most the lag, and some ticks.
TEST(LagWatch, FindsARealObstacleWithinTheLagAndTheTimeForItsError) {
  for (const double dt : {0.001, 0.002, 0.010, 0.020}) {
    for (const double lag : {0.0, 0.02, 0.04}) {
      SwingingFoot foot{lag, dt};
      foot.swing(8 * 0.76);
      double blocked = -1.0, t = 0.0;
      while (foot.watch.error(0) < 0.03 && t < 0.38) {
        foot.tick(0.17);
        t += dt;
        if (blocked < 0.0 && foot.p.x() >= 0.17) blocked = t;
      }
      EXPECT_GE(blocked, 0.0);
      EXPECT_LT(t - blocked, 0.018 + 1.5 * lag + 0.02 + 2.0 * dt) << lag << " s, period " << dt;
    }
  }
}

TEST(LagWatch, KnowsTheLagAfterSomeSwings) {
  for (const double dt : {0.002, 0.020}) {
    for (const double lag : {0.005, 0.02, 0.04}) {
      SwingingFoot foot{lag, dt};
      foot.swing(4.0);
      EXPECT_NEAR(foot.watch.lag(), lag, 0.2 * lag + 0.5 * dt);
    }
  }
}

// (lag 3) From the first tick on, at every lag; and a drive without lag that is blocked for half a swing has not
// become late.
TEST(LagWatch, TakesNoDriveForLaterThanItIs) {
  for (const double dt : {0.001, 0.002, 0.010, 0.020}) {
    for (const double lag : {0.0, 0.005, 0.02, 0.04}) {
      SwingingFoot foot{lag, dt};
      for (const double end = foot.t + 8.0; foot.t < end;) {
        foot.tick();
        ASSERT_LE(foot.watch.least_lag(), 1.2 * lag + 0.5 * dt) << lag << " s, period " << dt;
      }
      EXPECT_GE(foot.watch.least_lag(), 0.6 * lag - 0.7 * dt) << lag << " s, period " << dt;
    }
    SwingingFoot blocked{0.0, dt};
    blocked.swing(4 * 0.76);
    const double before = blocked.watch.lag();
    for (const double end = blocked.t + 0.25; blocked.t < end;) blocked.tick(0.1);
    EXPECT_LT(blocked.watch.least_lag(), 0.3 * (blocked.watch.lag() - before)) << "period " << dt;
  }
}

}  // namespace
}  // namespace hexagait

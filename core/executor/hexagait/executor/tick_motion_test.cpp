// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <hexagait/executor/tick_motion.hpp>
#include <hexagait/math/quintic.hpp>
#include <hexagait/sim/random.hpp>

namespace hexagait {
namespace {

constexpr double kPeriods[] = {0.001, 0.002, 0.004, 0.005, 0.010, 0.020};

struct Axis {
  double p = 0.0, v = 0.0, a = 0.0;
  void go(const AxisMotion& m) { p += m.way, v = m.v, a = m.a; }
};

// While the time to go falls by dt each tick, every tick continues the same quintic. Rounding: its
// terms are of the order of e; errors of p are divided by T² for a.
TEST(MinimumJerk, IsOneQuinticWhateverThePeriod) {
  RandomSequence random{.seed = 7};
  for (int run = 0; run < 200; ++run) {
    const double T = 0.4, target = random.uniform(-0.4, 0.4);
    const Axis start{0.0, random.uniform(-1.0, 1.0), random.uniform(-5.0, 5.0)};
    PointState from, to;
    from.v.x() = start.v, from.a.x() = start.a, to.p.x() = target;
    for (const double dt : kPeriods) {
      Axis axis = start;
      for (int k = 1; k * dt < T - kMinTimeToGo + 1e-9; ++k) {
        axis.go(minimum_jerk_tick(target - axis.p, axis.v, axis.a, T - (k - 1) * dt, dt));
        const PointState exact = quintic(from, to, T, k * dt);
        ASSERT_NEAR(axis.p, exact.p.x(), 1e-12);
        ASSERT_NEAR(axis.v, exact.v.x(), 1e-10);
        ASSERT_NEAR(axis.a, exact.a.x(), 1e-8);
      }
    }
  }
}

/// The map of one tick at constant T, from (e, v T, a T²) to the same a tick later.
std::array<std::array<double, 3>, 3> tick_map(double dt) {
  const double T = kMinTimeToGo;
  std::array<std::array<double, 3>, 3> M{};
  for (std::size_t j = 0; j < 3; ++j) {
    const double e = j == 0, v = j == 1, a = j == 2;
    const AxisMotion m = minimum_jerk_tick(e, v / T, a / (T * T), T, dt);
    M[0][j] = e - m.way, M[1][j] = m.v * T, M[2][j] = m.a * T * T;
  }
  return M;
}

// Characteristic polynomial λ³ − τ λ² + σ λ − δ. All its roots are within the unit circle if and
// only if (Jury) |τ + δ| < 1 + σ and |σ − τ δ| < 1 − δ². Theory: δ = (1 − s)⁹.
TEST(MinimumJerk, AtConstantTimeToGoIsStableForEveryPeriod) {
  for (double s = 0.002; s < 1.5; s += 0.002) {
    const auto M = tick_map(s * kMinTimeToGo);
    const auto minor = [&](std::size_t i, std::size_t j) {
      return M[i][i] * M[j][j] - M[i][j] * M[j][i];
    };
    const double trace = M[0][0] + M[1][1] + M[2][2];
    const double sum = minor(0, 1) + minor(0, 2) + minor(1, 2);
    const double det = M[0][0] * minor(1, 2) - M[0][1] * (M[1][0] * M[2][2] - M[1][2] * M[2][0]) +
                       M[0][2] * (M[1][0] * M[2][1] - M[1][1] * M[2][0]);
    ASSERT_NEAR(det, std::pow(std::max(0.0, 1.0 - s), 9), 1e-9) << s;
    ASSERT_LT(std::abs(trace + det), 1.0 + sum) << s;
    ASSERT_LT(std::abs(sum - trace * det), 1.0 - det * det) << s;
  }
}

// From rest it passes its target by at most 5.9 % of the way (at s = 0.56), and by 2.4 % with the
// longest control period, s = 0.4.
TEST(MinimumJerk, PassesItsTargetByFewPercent) {
  for (double s = 0.01; s < 1.5; s += 0.01) {
    Axis axis;
    double farthest = 0.0;
    for (int k = 0; k < 2000; ++k) {
      axis.go(minimum_jerk_tick(1.0 - axis.p, axis.v, axis.a, 0.0, s * kMinTimeToGo));
      farthest = std::max(farthest, axis.p);
    }
    ASSERT_NEAR(axis.p, 1.0, 1e-6) << s;
    ASSERT_LE(farthest, s <= 0.401 ? 1.024 : 1.059) << s;
  }
}

// The way is the integral of the velocity: Simpson's rule is exact for a cubic.
TEST(Braking, EndsAtRestAfterTheIntegralOfItsVelocity) {
  for (const double dt : kPeriods) {
    const AxisMotion half = braking_tick(0.3, -2.0, 0.5 * dt), whole = braking_tick(0.3, -2.0, dt);
    EXPECT_NEAR(whole.way, dt / 6.0 * (0.3 + 4.0 * half.v + whole.v), 1e-15);
    Axis axis{0.0, 0.3, -2.0};
    for (int k = 0; k * dt < 0.3; ++k) axis.go(braking_tick(axis.v, axis.a, dt));
    EXPECT_NEAR(axis.v, 0.0, 1e-4) << dt;
    EXPECT_GT(axis.p, 0.0);
    EXPECT_LT(axis.p, 0.3 * kMinTimeToGo);
  }
  EXPECT_EQ(braking_tick(0.3, -2.0, 0.02).v != 0.0, true);
  EXPECT_EQ(braking_tick(0.3, -2.0, 0.05).v, 0.0);
}

TEST(Slewing, IsTheSameInOneTickAsInMany) {
  for (const double wanted : {-0.3, 0.05, 0.2}) {
    const AxisMotion once = slewing_tick(0.1, wanted, 6.0, 0.02);
    Axis axis{0.0, 0.1, 0.0};
    for (int k = 0; k < 20; ++k) axis.go(slewing_tick(axis.v, wanted, 6.0, 0.001));
    EXPECT_NEAR(once.way, axis.p, 1e-15);
    EXPECT_NEAR(once.v, axis.v, 1e-15);
  }
}

TEST(DecayShare, IsThatOfAnExponential) {
  for (double x = 1e-6; x < 0.25; x *= 1.3) EXPECT_NEAR(decay_share(x), -std::expm1(-x), 2e-6);
  for (double x = 0.1; x < 1e6; x *= 1.3) EXPECT_LT(decay_share(x), 1.0);
}

// Braking at the law's speed never asks for more than the deceleration a, and never passes the
// goal, whatever the period.
TEST(ApproachSpeed, StopsAtTheGoalWithinItsDeceleration) {
  RandomSequence random{.seed = 3};
  for (int run = 0; run < 2000; ++run) {
    const double dt = random.uniform(0.001, 0.05), a = random.uniform(0.1, 5.0);
    const double rate = random.u01() < 0.5 ? 1e9 : random.uniform(0.0, 200.0);
    double d = random.uniform(-1.0, 1.0), v_before = 0.0;
    const double sign = std::copysign(1.0, d);
    for (int k = 0; k < 500; ++k) {
      const double v = sign * approach_speed(d, a, rate, 1e9, dt);
      ASSERT_GE(v, 0.0);
      if (k > 0 && rate > 1e8) {
        ASSERT_LE(v_before - v, a * dt * (1.0 + 1e-9));
      }
      d -= sign * v * dt, v_before = v;
      ASSERT_GE(sign * d, -1e-12);
    }
  }
}

}  // namespace
}  // namespace hexagait

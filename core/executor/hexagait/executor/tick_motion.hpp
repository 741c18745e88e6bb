// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

/// The laws of motion along one axis, solved over one control period. None of them integrates
/// step by step, so each is stable and gives the same motion for any period.
namespace hexagait {

/// Least time-to-go of the minimum-jerk law [s]. Shorter: a target that moves by odometry's noise
/// accelerates the foot more. It is 2.5 of the longest control periods.
inline constexpr double kMinTimeToGo = 0.05;

/// The instants of timers are multiples of the control period; this covers their rounding [s].
inline constexpr double kTimeTolerance = 1e-9;

/// Has a timer that counts in control periods reached its time?
[[nodiscard]] constexpr bool elapsed(double time, double limit) noexcept {
  return time > limit - kTimeTolerance;
}

/// Motion along one axis.
struct AxisMotion {
  double way = 0.0;  ///< displacement in the tick [m]
  double v = 0.0;    ///< velocity at its end [m/s]
  double a = 0.0;    ///< acceleration at its end [m/s²]
};

/// (swing 1): one tick on the minimum-jerk motion from (0, v, a) to rest at `error` in T. It is
/// solved anew in each tick, so that the target may move. With e the way left, s = dt/T:
///
///     e(s) = (1 − s)³ (A + B s + C s²),   A = e,  B = 3e − v T,  C = 6e − 3 v T − a T²/2
///
/// As long as T falls by dt each tick, a target at rest is reached on one and the same quintic,
/// whatever dt. At the least T the law becomes a feedback of constant gains; it is stable for all
/// s in (0, 1], and with dt ≥ T it comes to rest at the target within the tick (docs/theory.md 5).
///
/// @param error  from the point to its target [m]
/// @param T      time to go [s]; at least kMinTimeToGo is used
[[nodiscard]] inline AxisMotion minimum_jerk_tick(double error, double v, double a, double T,
                                                  double dt) noexcept {
  T = std::max(T, kMinTimeToGo);
  if (dt >= T) return {error, 0.0, 0.0};
  const double s = dt / T, u = 1.0 - s;
  const double B = 3.0 * error - v * T, C = 6.0 * error - 3.0 * v * T - 0.5 * a * T * T;
  const double g = error + s * (B + s * C), g1 = B + 2.0 * s * C;
  return {error - u * u * u * g, u * u * (3.0 * g - u * g1) / T,
          u * (-6.0 * g + u * (6.0 * g1 - 2.0 * u * C)) / (T * T)};
}

/// One tick of braking to rest, wherever that is, in kMinTimeToGo/2: the velocity follows the cubic
/// from (v, a) to (0, 0), the minimum-jerk motion with a free end. Solved anew in each tick.
///
///     v(s) = (1 − s)² (v + (2v + a T) s)                                              (swing 2)
[[nodiscard]] inline AxisMotion braking_tick(double v, double a, double dt) noexcept {
  const double T = 0.5 * kMinTimeToGo, b = 2.0 * v + a * T;
  const double s = std::min(1.0, dt / T), u = 1.0 - s;
  const double u3 = u * u * u;
  const double way = T * (v * (1.0 - u3) / 3.0 + b * (1.0 - u3 * (1.0 + 3.0 * s)) / 12.0);
  return {way, u * u * (v + b * s), u * (u * b - 2.0 * (v + b * s)) / T};
}

/// One tick of a velocity that changes at the rate `most` until it is `wanted`.
[[nodiscard]] inline AxisMotion slewing_tick(double v, double wanted, double most,
                                             double dt) noexcept {
  const double change = wanted - v, time = std::abs(change) / most;
  if (time <= dt) return {0.5 * (v + wanted) * time + wanted * (dt - time), wanted, 0.0};
  const double a = std::copysign(most, change);
  return {(v + 0.5 * a * dt) * dt, v + a * dt, a};
}

/// The fraction of a deviation by which it decays in a tick at a rate k: 1 − exp(−x), x = k dt, as
/// a Padé approximant. Off by less than 1e-6 up to x = 0.25, and below 1 for any x: it never
/// overshoots.
[[nodiscard]] inline double decay_share(double x) noexcept {
  return x / (1.0 + x * (0.5 + x / 12.0));
}

/// The velocity over this tick of a point that approaches a goal, (base 1): it stops there with at
/// most the deceleration `a`, and decays at the rate k when it is near.
///
///     ṡ dt ≤ d (1 − exp(−k dt)),   ṡ² ≤ 2 a (d − ṡ dt)                               (base 1)
///
/// The second law is for what is left at the end of the tick. So no period makes it overshoot.
/// @param distance  to the goal, with its sign [m]
[[nodiscard]] inline double approach_speed(double distance, double a, double k, double bound,
                                           double dt) noexcept {
  const double d = std::abs(distance), step = a * dt;
  const double brake = 2.0 * a * d / (step + std::sqrt(step * step + 2.0 * a * d) + 1e-300);
  return std::copysign(std::min({brake, decay_share(k * dt) / dt * d, bound}), distance);
}

}  // namespace hexagait

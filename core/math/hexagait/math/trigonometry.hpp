// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Trigonometry with the same bits on any processor.
///
/// The C library chooses its sin, cos, atan2, … by processor: with fused multiply-add their last bits
/// differ from those without. These here consist of IEEE additions, multiplications, divisions and
/// square roots, which are rounded correctly everywhere. What may reach a robot, a simulator or a
/// number of a sweep uses them. They need the rounding mode "to nearest" and -ffp-contract=off.
///
/// Of the C library, these are exact or correctly rounded, and as safe: sqrt, fabs, copysign, fmin,
/// fmax, fmod, remainder, floor, ceil, trunc, round, lround, rint, frexp, ldexp, nextafter, fma.
///
/// Errors are measured against long double in the tests; an ulp is that of the result. All are
/// noexcept, and total: NaN for NaN and where there is no value.
namespace hexagait::portable {

struct SinCos {
  double s = 0.0, c = 1.0;
};

/// Sine and cosine of x [rad]: reduction by multiples of π/2 to |r| ≤ π/4, then Taylor polynomials.
///
/// Error: at most 1.5e-16 for |x| < 1e6 rad, and 1 ulp for |x| ≤ π/4; beyond 1e6 rad 1e-16 |x|, as
/// if x had been rounded to its neighbour. Infinite x gives NaN.
[[nodiscard]] SinCos sincos(double x) noexcept;
[[nodiscard]] inline double sin(double x) noexcept { return sincos(x).s; }
[[nodiscard]] inline double cos(double x) noexcept { return sincos(x).c; }

/// Angle of the vector (x, y), in [−π, π] [rad]; signs of zeros and infinities as in the C library.
///
/// With t = min/max of |x|, |y| and c the eighth that is nearest to t,
///
///     atan t = atan c + atan u,   u = (t − c) / (1 + c t),   |u| ≤ 1/16
///
/// Error: at most 2 ulp, 4e-16.
[[nodiscard]] double atan2(double y, double x) noexcept;
[[nodiscard]] inline double atan(double x) noexcept { return atan2(x, 1.0); }

/// By way of atan2; error: at most 5e-16. NaN for |x| > 1.
[[nodiscard]] double asin(double x) noexcept;
[[nodiscard]] double acos(double x) noexcept;

/// √(x² + y²) without overflow; error: at most 1.5 ulp, as long as the result is not subnormal.
[[nodiscard]] double hypot(double x, double y) noexcept;

}  // namespace hexagait::portable

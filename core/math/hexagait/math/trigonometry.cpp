// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <bit>
#include <cmath>
#include <cstdint>
#include <hexagait/math/lane_sincos.hpp>
#include <hexagait/math/trigonometry.hpp>
#include <limits>
#include <numbers>

namespace hexagait::portable {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// π/2 in two parts. The first has 33 bits, so k times it is exact for |k| ≤ 2²⁰; together they are
// π/2 up to 4e-27.
constexpr double kHalfPiHead = 0x1.921fb544p+0, kHalfPiTail = 0x1.0b4611a626331p-34;
constexpr double kTwoOverPi = 0x1.45f306dc9c883p-1;
constexpr double kFewTurns = 1e6;  // |k| < 2²⁰ [rad]

// A sum with this has units in its last place: it is rounded to whole numbers, and its lowest bits
// are theirs.
constexpr double kRounder = 0x1.8p+52;

// Both polynomials at once, a lane each, with z = r²: (sin r − r) / r³ = −1/3! + z/5! − …, to r¹⁷, and
// (cos r − 1 + z/2) / z² = 1/4! − z/6! + …, to r¹⁸. For |r| ≤ π/4 the rests are below 1e-19.
constexpr double kSine[] = {
    -1.0 / 6,        1.0 / 120,        -1.0 / 5040,          1.0 / 362880,
    -1.0 / 39916800, 1.0 / 6227020800, -1.0 / 1307674368000, 1.0 / 355687428096000};
constexpr double kCosine[] = {
    1.0 / 24,        -1.0 / 720,         1.0 / 40320,          -1.0 / 3628800,
    1.0 / 479001600, -1.0 / 87178291200, 1.0 / 20922789888000, -1.0 / 6402373705728000};
Lanes sin_cos_tails(double z) {
  constexpr Lanes k3_4 = {kSine[0], kCosine[0]}, k5_6 = {kSine[1], kCosine[1]};
  constexpr Lanes k7_8 = {kSine[2], kCosine[2]}, k9_10 = {kSine[3], kCosine[3]};
  constexpr Lanes k11_12 = {kSine[4], kCosine[4]}, k13_14 = {kSine[5], kCosine[5]};
  constexpr Lanes k15_16 = {kSine[6], kCosine[6]}, k17_18 = {kSine[7], kCosine[7]};
  const Lanes zz = both(z);
  return k3_4 +
         zz * (k5_6 +
               zz * (k7_8 +
                     zz * (k9_10 + zz * (k11_12 + zz * (k13_14 + zz * (k15_16 + zz * k17_18))))));
}

// The angle of k/8 in two parts: together exact up to 1e-33.
struct TwoParts {
  double head, tail;
};
constexpr TwoParts kAtanOfEighths[] = {
    {0.0, 0.0},
    {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
    {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
    {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
    {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
    {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
    {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
    {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
    {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55},
};
constexpr TwoParts kHalfPi = {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
constexpr TwoParts kPi = {0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};

// atan u = u − u³/3 + …, to u¹³: for |u| ≤ 1/16 the rest is below 4e-18 u.
double atan_polynomial(double u) {
  constexpr double k3 = -1.0 / 3, k5 = 1.0 / 5, k7 = -1.0 / 7, k9 = 1.0 / 9, k11 = -1.0 / 11;
  constexpr double k13 = 1.0 / 13;
  const double z = u * u;
  return u + u * (z * (k3 + z * (k5 + z * (k7 + z * (k9 + z * (k11 + z * k13))))));
}

// Sums |x| + |y| for which nothing in atan2() overflows, or underflows so that it matters.
constexpr double kSmallSum = 1e-280, kLargeSum = 1e300;

// The same for the squares in hypot().
constexpr double kSmallSquare = 1e-140, kLargeSquare = 1e150;

// atan2 of all other pairs.
double atan2_of_extremes(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return kNaN;
  const double sum = std::abs(x) + std::abs(y);
  if (sum == 0.0) return std::copysign(std::signbit(x) ? kPi.head : 0.0, y);
  if (std::isinf(x) || std::isinf(y)) {
    const auto unit = [](double v) { return std::copysign(std::isinf(v) ? 1.0 : 0.0, v); };
    return atan2(unit(y), unit(x));
  }
  const double scale = sum < 1.0 ? 0x1p+500 : 0x1p-500;
  return atan2(scale * y, scale * x);
}

}  // namespace

constinit const SinCosTerms kSinCosTerms = {
    .few_turns = both(kFewTurns),
    .two_over_pi = both(kTwoOverPi),
    .rounder = both(kRounder),
    .half_pi_head = both(kHalfPiHead),
    .half_pi_tail = both(kHalfPiTail),
    .half = both(0.5),
    .one = both(1.0),
    .sine = {both(kSine[0]), both(kSine[1]), both(kSine[2]), both(kSine[3]), both(kSine[4]),
             both(kSine[5]), both(kSine[6]), both(kSine[7])},
    .cosine = {both(kCosine[0]), both(kCosine[1]), both(kCosine[2]), both(kCosine[3]),
               both(kCosine[4]), both(kCosine[5]), both(kCosine[6]), both(kCosine[7])}};

SinCos sincos(double x) noexcept {
  if (!(std::abs(x) < kFewTurns)) x = std::remainder(x, 2.0 * std::numbers::pi);

  // x = k π/2 + r; the first difference is exact.
  const double shifted = x * kTwoOverPi + kRounder, k = shifted - kRounder;
  const double r = (x - k * kHalfPiHead) - k * kHalfPiTail;
  const double z = r * r;
  const Lanes tails = sin_cos_tails(z);
  const double s = r + r * (z * tails[0]), c = 1.0 - (0.5 * z - z * z * tails[1]);

  switch (std::bit_cast<std::uint64_t>(shifted) & 3U) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

double atan2(double y, double x) noexcept {
  const double ax = std::abs(x), ay = std::abs(y);
  if (!(kSmallSum < ax + ay && ax + ay < kLargeSum)) return atan2_of_extremes(y, x);

  // The angle of the shorter leg over the longer one, in [0, π/4].
  const bool steep = ay > ax, back = std::signbit(x);
  const double large = steep ? ay : ax, small = steep ? ax : ay;
  // NOLINTNEXTLINE(bugprone-incorrect-roundings): at a tie either neighbour will do.
  const int k = static_cast<int>(8.0 * (small / large) + 0.5);
  const double c = 0.125 * k;
  const double u = (small - c * large) / (large + c * small);
  const TwoParts& start = kAtanOfEighths[k];
  const double a = start.head + (start.tail + atan_polynomial(u));

  const double turned = steep != back ? -a : a;
  const TwoParts from = steep ? kHalfPi : back ? kPi : TwoParts{0.0, 0.0};
  return std::copysign(from.head + (from.tail + turned), y);
}

double asin(double x) noexcept { return atan2(x, std::sqrt((1.0 - x) * (1.0 + x))); }
double acos(double x) noexcept { return atan2(std::sqrt((1.0 - x) * (1.0 + x)), x); }

double hypot(double x, double y) noexcept {
  const double sum = std::abs(x) + std::abs(y);
  if (kSmallSquare < sum && sum < kLargeSquare) return std::sqrt(x * x + y * y);
  if (sum == 0.0 || std::isinf(x) || std::isinf(y)) return sum;
  const double scale = sum < 1.0 ? 0x1p+600 : 0x1p-600;
  return std::sqrt((scale * x) * (scale * x) + (scale * y) * (scale * y)) / scale;
}

}  // namespace hexagait::portable

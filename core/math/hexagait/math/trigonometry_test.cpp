// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <hexagait/math/lane_sincos.hpp>
#include <hexagait/math/trigonometry.hpp>
#include <hexagait/sim/random.hpp>
#include <limits>
#include <numbers>

namespace hexagait {
namespace {

constexpr int kDraws = 200000;
constexpr double kInf = std::numeric_limits<double>::infinity();

// The C library's long double has 11 bits more, so it is an oracle for the last bit of a double.
using Exact = long double;

double error(double value, Exact exact) { return static_cast<double>(std::abs(value - exact)); }

// In units of the last place of the exact value.
double ulps(double value, Exact exact) {
  const double size = std::abs(static_cast<double>(exact));
  return error(value, exact) / (std::nextafter(size, kInf) - size);
}

double spread(RandomSequence& random, double decades) {
  return random.uniform(-1.0, 1.0) * std::pow(10.0, random.uniform(-decades, decades));
}

TEST(PortableSincos, IsWithinOneUlpOfTheFirstOctantsAndCloseForAMillionRadians) {
  RandomSequence random{.seed = 1};
  for (const double range : {std::numbers::pi / 4.0, 1.0, 4.0, 1e3, 1e6}) {
    for (int k = 0; k < kDraws; ++k) {
      const double x = random.uniform(-range, range);
      const portable::SinCos value = portable::sincos(x);
      const Exact s = std::sin(Exact{x}), c = std::cos(Exact{x});
      ASSERT_LE(error(value.s, s), 1.5e-16) << x;
      ASSERT_LE(error(value.c, c), 1.5e-16) << x;
      if (range > std::numbers::pi / 4.0) continue;
      ASSERT_LE(ulps(value.s, s), 1.0) << x;
      ASSERT_LE(ulps(value.c, c), 1.0) << x;
    }
  }
}

// Each lane, whatever the other one holds.
TEST(PortableSincos, OfTwoAnglesHasTheBitsOfEach) {
  RandomSequence random{.seed = 7};
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  for (int k = 0; k < kDraws; ++k) {
    const double range = k % 3 == 0 ? 1e7 : k % 3 == 1 ? 10.0 : 1.0;
    const double x[] = {k % 1000 == 0 ? kInf : random.uniform(-range, range),
                        k % 1001 == 0 ? -0.0 : random.uniform(-8.0, 8.0)};
    const portable::LaneSinCos pair = portable::sincos(Lanes{x[0], x[1]});
    for (int lane = 0; lane < 2; ++lane) {
      const portable::SinCos one = portable::sincos(x[lane]);
      ASSERT_EQ(bits(pair.s[lane]), bits(one.s)) << x[lane];
      ASSERT_EQ(bits(pair.c[lane]), bits(one.c)) << x[lane];
    }
  }
}

// Beyond a million radians 2π has the error of its double, 2.5e-16, in each of x/2π turns.
TEST(PortableSincos, LosesBeyondNoMoreThanTheArgumentHas) {
  RandomSequence random{.seed = 2};
  for (const double range : {1e7, 1e10, 1e14}) {
    for (int k = 0; k < kDraws; ++k) {
      const double x = random.uniform(-range, range);
      const portable::SinCos value = portable::sincos(x);
      ASSERT_LE(error(value.s, std::sin(Exact{x})), 2e-16 + 1e-16 * std::abs(x)) << x;
      ASSERT_LE(error(value.c, std::cos(Exact{x})), 2e-16 + 1e-16 * std::abs(x)) << x;
    }
  }
}

// Around each multiple of π/4 the reduction changes its quadrant, or the result its sign.
TEST(PortableSincos, IsRightOnBothSidesOfEachQuadrant) {
  for (int k = -5000; k <= 5000; ++k) {
    const double middle = k * (std::numbers::pi / 4.0);
    for (const double x :
         {std::nextafter(middle, -kInf), middle, std::nextafter(middle, kInf), middle + 1e-9}) {
      const portable::SinCos value = portable::sincos(x);
      ASSERT_LE(error(value.s, std::sin(Exact{x})), 1.5e-16) << x;
      ASSERT_LE(error(value.c, std::cos(Exact{x})), 1.5e-16) << x;
    }
  }
}

TEST(PortableSincos, HasTheSpecialValues) {
  EXPECT_EQ(portable::sin(0.0), 0.0);
  EXPECT_EQ(portable::cos(0.0), 1.0);
  EXPECT_EQ(portable::sin(1e-300), 1e-300);
  for (const double x : {kInf, -kInf, std::nan("")}) {
    EXPECT_TRUE(std::isnan(portable::sin(x)));
    EXPECT_TRUE(std::isnan(portable::cos(x)));
  }
}

TEST(PortableAtan2, IsWithinTwoUlp) {
  RandomSequence random{.seed = 3};
  for (const double decades : {0.0, 1.0, 10.0, 290.0}) {
    for (int k = 0; k < kDraws; ++k) {
      const double x = spread(random, decades), y = spread(random, decades);
      const Exact exact = std::atan2(Exact{y}, Exact{x});
      ASSERT_LE(error(portable::atan2(y, x), exact), 4e-16) << y << ' ' << x;
      if (std::abs(exact) < 1e-300L) continue;  // where doubles have fewer digits
      ASSERT_LE(ulps(portable::atan2(y, x), exact), 2.0) << y << ' ' << x;
    }
  }
}

// Where t is halfway between two eighths, another angle is the start.
TEST(PortableAtan2, IsRightOnBothSidesOfEachStart) {
  for (int k = 0; k <= 16; ++k) {
    const double middle = k / 16.0;
    for (const double t :
         {std::nextafter(middle, 0.0), middle, std::min(1.0, std::nextafter(middle, 2.0))}) {
      ASSERT_LE(ulps(portable::atan2(t, 1.0), std::atan(Exact{t})), 2.0) << t;
      ASSERT_LE(ulps(portable::atan2(1.0, t), std::atan2(1.0L, Exact{t})), 2.0) << t;
    }
  }
}

// The C library's answers for zeros, infinities, and what is nearly so, are prescribed.
TEST(PortableAtan2, HasTheSpecialValues) {
  const std::array values = {0.0, -0.0, 1.0, -1.0, kInf, -kInf, 5e-324, -5e-324, 1e308, -1e308};
  for (const double y : values)
    for (const double x : values) {
      const double expected = static_cast<double>(std::atan2(Exact{y}, Exact{x}));
      EXPECT_NEAR(portable::atan2(y, x), expected, 4e-16) << y << ' ' << x;
      EXPECT_EQ(std::signbit(portable::atan2(y, x)), std::signbit(expected)) << y << ' ' << x;
    }
  EXPECT_TRUE(std::isnan(portable::atan2(std::nan(""), 1.0)));
  EXPECT_TRUE(std::isnan(portable::atan2(1.0, std::nan(""))));
  EXPECT_TRUE(std::isnan(portable::atan2(kInf, std::nan(""))));
}

TEST(PortableAsinAndAcos, AreCloseAndNaNOutside) {
  RandomSequence random{.seed = 4};
  for (int k = 0; k < kDraws; ++k) {
    const double x = random.uniform(-1.0, 1.0);
    ASSERT_LE(error(portable::asin(x), std::asin(Exact{x})), 5e-16) << x;
    ASSERT_LE(error(portable::acos(x), std::acos(Exact{x})), 5e-16) << x;
  }
  EXPECT_EQ(portable::asin(1.0), std::numbers::pi / 2.0);
  EXPECT_EQ(portable::acos(-1.0), std::numbers::pi);
  EXPECT_TRUE(std::isnan(portable::asin(1.0 + 1e-15)));
  EXPECT_TRUE(std::isnan(portable::acos(-1.0 - 1e-15)));
}

TEST(PortableHypot, IsWithinOneAndAHalfUlpAtAnySize) {
  RandomSequence random{.seed = 5};
  for (const double decades : {0.0, 10.0, 290.0}) {
    for (int k = 0; k < kDraws; ++k) {
      const double x = spread(random, decades), y = spread(random, decades);
      const Exact exact = std::hypot(Exact{x}, Exact{y});
      ASSERT_LE(ulps(portable::hypot(x, y), exact), 1.5) << x << ' ' << y;
    }
  }
  EXPECT_EQ(portable::hypot(0.0, 0.0), 0.0);
  EXPECT_EQ(portable::hypot(1e308, 0.0), 1e308);
  EXPECT_EQ(portable::hypot(-kInf, 1.0), kInf);
  EXPECT_TRUE(std::isnan(portable::hypot(std::nan(""), 1.0)));
}

// The bits of 100 000 results, as computed with and without fused multiply-add: they depend on
// nothing but IEEE arithmetic, so every compiler and every processor must find them.
TEST(Portable, HasTheBitsThatItHasEverywhere) {
  RandomSequence random{.seed = 6};
  std::uint64_t sum = 0;
  const auto add = [&](double v) { sum = std::rotl(sum, 7) ^ std::bit_cast<std::uint64_t>(v); };
  for (int k = 0; k < 100000; ++k) {
    const double x = random.uniform(-4.0, 4.0), y = random.uniform(-4.0, 4.0);
    const portable::SinCos value = portable::sincos(x);
    add(value.s);
    add(value.c);
    add(portable::atan2(y, x));
    add(portable::asin(0.25 * x));
    add(portable::hypot(x, y));
  }
  EXPECT_EQ(sum, 8844124736386317583U);
}

}  // namespace
}  // namespace hexagait

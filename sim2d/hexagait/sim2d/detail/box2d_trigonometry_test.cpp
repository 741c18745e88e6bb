// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <hexagait/sim/random.hpp>
#include <hexagait/sim2d/detail/box2d_trigonometry.hpp>

namespace hexagait::sim2d::detail {
namespace {

TEST(Box2dTrigonometry, IsOurs) {
  link_portable_trigonometry();
  EXPECT_TRUE(box2d_is_portable());
}

// They stand in for the C library's in all of a program: within the rounding to float.
TEST(Box2dTrigonometry, IsWithinOneUlpOfTheExactValue) {
  RandomSequence random{.seed = 1};
  for (int k = 0; k < 100000; ++k) {
    const float x = static_cast<float>(random.uniform(-1e3, 1e3));
    const float y = static_cast<float>(random.uniform(-1.0, 1.0));
    float s = 0.0F, c = 0.0F;
    ::sincosf(x, &s, &c);
    ASSERT_NEAR(::sinf(x), std::sin(double{x}), 6e-8) << x;
    ASSERT_NEAR(::cosf(x), std::cos(double{x}), 6e-8) << x;
    ASSERT_EQ(s, ::sinf(x));
    ASSERT_EQ(c, ::cosf(x));
    ASSERT_NEAR(::atan2f(y, x), std::atan2(double{y}, double{x}), 1.2e-7) << y << x;
  }
}

}  // namespace
}  // namespace hexagait::sim2d::detail

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/figures/panel.hpp>

namespace hexagait::figures {
namespace {

// A panel of 400 px × 100 px. 2 m × 1 m need 1/100 m per pixel upwards, so 4 m are seen across.
TEST(Box, IsWidenedToThePanelsProportionsAboutItsMiddle) {
  Box box;
  box.include({1.0, 0.0});
  box.include({3.0, 1.0});
  const Box fitted = box.fitted({0.1, 0.5, 0.2, 0.4}, 1000, 500);
  EXPECT_TRUE(fitted.least.isApprox(Vector2(0.0, 0.0)));
  EXPECT_TRUE(fitted.greatest.isApprox(Vector2(4.0, 1.0)));
}

TEST(Box, HasRoomAroundWhatItIncludes) {
  Box box;
  box.include({1.0, 2.0});
  EXPECT_EQ(box.grown(0.5).size(), Vector2(1.0, 1.0));
}

}  // namespace
}  // namespace hexagait::figures

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/figures/csv.hpp>
#include <limits>

namespace hexagait::figures {
namespace {

TEST(Csv, HasARowPerCallAndACellPerCoordinate) {
  Csv csv("time_s,x_m,y_m,leg,stands");
  csv.row(0.5, Vector2(1.0, -2.25), 3, true);
  EXPECT_EQ(csv.text(), "time_s,x_m,y_m,leg,stands\n0.5,1,-2.25,3,1\n");
}

// RFC 4180, 2.5 to 2.7.
TEST(Csv, QuotesCommasQuotesAndLineBreaks) {
  Csv csv;
  csv.row("plain", "a, b", "say \"no\"", "two\nlines", "");
  EXPECT_EQ(csv.text(), "plain,\"a, b\",\"say \"\"no\"\"\",\"two\nlines\",\n");
}

TEST(Csv, LeavesTheCellOfWhatIsNotKnownEmpty) {
  Csv csv;
  csv.row(1, std::numeric_limits<double>::quiet_NaN(), 'A');
  csv.gap();
  csv.row(std::uint64_t{18446744073709551615U}, 1.0 / 3.0);
  EXPECT_EQ(csv.text(), "1,,A\n\n18446744073709551615,0.333333333\n");
}

}  // namespace
}  // namespace hexagait::figures

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdint>
#include <hexagait/text/parse_number.hpp>

namespace hexagait {
namespace {

// 2^64 − 1 has 20 digits, which a double has not.
TEST(ParseNumber, ReadsAWholeTextOrNothing) {
  EXPECT_EQ(parse_number<std::uint64_t>("18446744073709551615"), 18446744073709551615U);
  EXPECT_EQ(parse_number<double>("-2.5e-3"), -2.5e-3);
  for (const char* text : {"", " 1", "1 ", "1x", "x", "+1", "-1", "1.5", "18446744073709551616"})
    EXPECT_FALSE(parse_number<std::uint64_t>(text)) << text;
  for (const char* text : {"", "1,5", "1m", "--1", "1e999"})
    EXPECT_FALSE(parse_number<double>(text)) << text;
}

}  // namespace
}  // namespace hexagait

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/violations.hpp>

namespace hexagait {
namespace {

TEST(Violations, AreListedAllAtOnceEachOnceAtItsPlace) {
  Violations violations("file");
  violations.add("leg LF", "is missing");
  violations.add(Mark{2, 3}, "is wrong");
  violations.add(Mark{2, 3}, "is wrong");
  EXPECT_THAT(
      [&] { violations.throw_if_any(); },
      ::testing::ThrowsMessage<InvalidInput>("file: leg LF: is missing\nfile:2:3: is wrong"));
}

// The hundredth ends the list with a line that says so.
TEST(Violations, EndAtAHundred) {
  Violations violations("file");
  for (int i = 1; i < 100; ++i) violations.add("link", std::to_string(i));
  try {
    violations.add("link", "100");
    FAIL() << "not the last";
  } catch (const InvalidInput& error) {
    const std::string text = error.what();
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 100);
    EXPECT_TRUE(text.ends_with("file: these are the first 100; there may be more")) << text;
  }
}

}  // namespace
}  // namespace hexagait

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/sim/fnv1a.hpp>

namespace hexagait {
namespace {

// Of the test vectors that the algorithm's authors publish.
TEST(Fnv1a, IsThePublishedHash) {
  EXPECT_EQ(fnv1a(""), 0xcbf29ce484222325U);
  EXPECT_EQ(fnv1a("a"), 0xaf63dc4c8601ec8cU);
  EXPECT_EQ(fnv1a("foobar"), 0x85944171f73967e8U);
}

TEST(Fnv1a, GoesOnFromWhatCameBeforeAndTakesTheLowestByteFirst) {
  EXPECT_EQ(fnv1a("bar", fnv1a("foo")), fnv1a("foobar"));
  EXPECT_EQ(fnv1a(std::uint32_t{0x64636261}, kFnv1aBasis), fnv1a("abcd"));
}

}  // namespace
}  // namespace hexagait

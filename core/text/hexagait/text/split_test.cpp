// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <hexagait/text/split.hpp>

namespace hexagait {
namespace {

using ::testing::ElementsAre;

TEST(Split, GivesWhatStandsBetweenTheSeparatorsEvenIfItIsNothing) {
  EXPECT_THAT(split("a,bc,d", ','), ElementsAre("a", "bc", "d"));
  EXPECT_THAT(split(",a,", ','), ElementsAre("", "a", ""));
  EXPECT_THAT(split("a,b", '+'), ElementsAre("a,b"));
  EXPECT_THAT(split("", ','), ElementsAre(""));
}

}  // namespace
}  // namespace hexagait

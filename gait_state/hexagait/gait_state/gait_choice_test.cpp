// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/gait_state/gait_choice.hpp>

namespace hexagait::gait_state {
namespace {

TEST(GaitChoice, IsReadBackAsItIsWritten) {
  for (const char* text :
       {"free", "unadjusted", "literal", "tripod", "clocked", "wave:0.5", "wave:0.75"}) {
    const auto choice = parse_gait_choice(text);
    ASSERT_TRUE(choice) << text;
    EXPECT_EQ(to_string(*choice), text);
  }
}

TEST(GaitChoice, RefusesUnknownWordsAndDutyFactorsThatNoWaveGaitHas) {
  for (const char* text : {"", "Free", "wave", "wave:", "wave:0.49", "wave:1", "wave:nan",
                           "wave:0.7x", "wave: 0.7", "tripod:0.5"})
    EXPECT_FALSE(parse_gait_choice(text)) << text;
}

}  // namespace
}  // namespace hexagait::gait_state

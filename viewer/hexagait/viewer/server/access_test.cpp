// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/viewer/server/access.hpp>

namespace hexagait::viewer {
namespace {

const Access kLocal{.bind = "127.0.0.1", .port = 8460, .token = {}};
const Access kOpen{.bind = "192.0.2.7", .port = 8460, .token = "0123456789abcdef"};

TEST(Access, KnowsLoopbackAddresses) {
  for (const char* const bind : {"127.0.0.1", "127.1.2.3", "localhost", "::1"})
    EXPECT_TRUE((Access{.bind = bind, .port = 1, .token = {}}.is_loopback())) << bind;
  for (const char* const bind :
       {"0.0.0.0", "192.0.2.7", "::", "127.evil.example", "localhost.example"})
    EXPECT_FALSE((Access{.bind = bind, .port = 1, .token = {}}.is_loopback())) << bind;
}

// A foreign name that leads to this machine (DNS rebinding) is not ours, nor is another port.
TEST(Access, AnswersItsOwnHostsOnly) {
  for (const char* const host : {"127.0.0.1:8460", "localhost:8460", "[::1]:8460"})
    EXPECT_TRUE(is_our_host(kLocal, host)) << host;
  for (const char* const host :
       {"", "evil.example:8460", "127.0.0.1", "127.0.0.1:8461", "127.0.0.1:84600",
        "127.0.0.1.evil.example:8460", "localhost:8460.evil.example"})
    EXPECT_FALSE(is_our_host(kLocal, host)) << host;
}

TEST(Access, IsSteeredByItsOwnPageOnly) {
  EXPECT_TRUE(is_our_origin(kLocal, "http://localhost:8460", "localhost:8460"));
  EXPECT_TRUE(is_our_origin(kLocal, "", "localhost:8460"));  // a program, no page
  for (const char* const origin :
       {"http://evil.example", "https://localhost:8460", "null", "http://localhost:8461",
        "http://localhost:8460.evil.example", "http://127.0.0.1:8460"})
    EXPECT_FALSE(is_our_origin(kLocal, origin, "localhost:8460")) << origin;
  EXPECT_FALSE(is_our_origin(kLocal, "http://evil.example:8460", "evil.example:8460"));
}

TEST(Access, AsksForTheTokenOnOtherAddresses) {
  EXPECT_TRUE(is_token(kLocal, ""));
  EXPECT_TRUE(is_token(kOpen, "0123456789abcdef"));
  for (const char* const given : {"", "0123456789abcdeF", "0123456789abcde", "0123456789abcdef0"})
    EXPECT_FALSE(is_token(kOpen, given)) << given;
}

TEST(Access, MakesATokenThatNobodyGuesses) {
  const std::string token = make_token();
  EXPECT_EQ(token.size(), 32U);
  EXPECT_EQ(token.find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_NE(token, make_token());
}

}  // namespace
}  // namespace hexagait::viewer

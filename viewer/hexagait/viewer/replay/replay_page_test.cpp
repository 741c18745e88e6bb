// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <hexagait/viewer/replay/replay_host.hpp>
#include <hexagait/viewer/replay/replay_page.hpp>
#include <hexagait/viewer/server/page_files.hpp>

namespace hexagait::viewer {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(ReplayPage, HasTheReplayInItAndAsksNobody) {
  if (page_files().empty()) GTEST_SKIP() << kNoPage;
  const std::string page = replay_page("foobar");
  EXPECT_THAT(page, HasSubstr(R"(id="replay">Zm9vYmFy</script>)"));
  EXPECT_THAT(page, HasSubstr("default-src 'none'; script-src 'sha256-"));
  EXPECT_THAT(page, Not(HasSubstr("unsafe-inline")));
  EXPECT_THAT(page, Not(HasSubstr("src=\"http")));
  for (const char* place : {"@/", "@REPLAY@", "@POLICY@", "@LOADER@", "@LICENCES@"})
    EXPECT_THAT(page, Not(HasSubstr(place)));
}

TEST(ReplayHost, GivesTheReplayOnceToEach) {
  ReplayHost host("bytes");
  EXPECT_NE(host.enter(), host.enter());
  for (int client = 0; client < 2; ++client) {
    Host::Seen seen;
    Host::Letter letter;
    ASSERT_TRUE(host.newer_than(seen, letter));
    EXPECT_EQ(letter.content, "bytes");
    EXPECT_FALSE(host.newer_than(seen, letter));
  }
  EXPECT_THAT(host.receive(1, R"({"type":"stop"})"), HasSubstr("nothing to steer"));
}

}  // namespace
}  // namespace hexagait::viewer

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <nlohmann/json.hpp>

#include "cli_fixture.hpp"

namespace hexagait::app {
namespace {

class Steer : public Cli {};

#ifdef HEXAGAIT_HAS_VIEWER
TEST_F(Steer, WalksInRealTimeWithoutAPage) {
  const Result result = run("steer --headless --seconds 1.5 --terrain flat --json --quiet");
  EXPECT_EQ(result.status, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_GT(json["path_m"].get<double>(), 0.05);
  EXPECT_LT(json["seconds"].get<double>(), 2.5);
  EXPECT_FALSE(json["fell"].get<bool>());
}

TEST_F(Steer, SaysWhatIsWrong) {
  const auto refusal = [&](const std::string& options) {
    const Result result = run("steer --headless " + options);
    EXPECT_EQ(result.status, 2) << options;
    return result.err;
  };
  EXPECT_THAT(refusal("--speed 0"), HasSubstr("--speed is '0'; it must be from 0.05 to 10"));
  EXPECT_THAT(refusal("--speed nan"), HasSubstr("--speed"));
  EXPECT_THAT(refusal("--seconds 0"), HasSubstr("--seconds is '0'"));
  EXPECT_THAT(refusal("--terrain hills"), HasSubstr("unknown kind"));
  EXPECT_THAT(refusal("--robot nobody"), HasSubstr("does not exist"));
  EXPECT_THAT(refusal("--robot genghis2d"), HasSubstr("side view only"));
  EXPECT_THAT(refusal("--prot 1"), HasSubstr("--port"));
}

TEST_F(Steer, RefusesAPortThatIsNone) {
  for (const char* const port : {"-1", "65536", "http", "80.5"}) {
    const Result result = run(std::string("steer --seconds 0.1 --port ") + port);
    EXPECT_EQ(result.status, 2);
    EXPECT_THAT(result.err,
                testing::AnyOf(HasSubstr("--port"), HasSubstr("the page was not built")));
  }
}
#else
TEST_F(Steer, SaysWhatItLacks) {
  const Result result = run("steer");
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.err, HasSubstr("libwebsockets-dev"));
}
#endif

}  // namespace
}  // namespace hexagait::app

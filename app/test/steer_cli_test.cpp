// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

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
                ::testing::AnyOf(HasSubstr("--port"), HasSubstr("the page was not built")));
  }
}
// A robot in a process of its own, as examples/simulated_robot is one.
class Live : public Steer {
 protected:
  static std::string with(const std::string& program, const std::string& options) {
    return "steer --live '" + program + "' --quiet " + options;
  }
  const std::string robot_ = HEXAGAIT_SIMULATED_ROBOT " --real-time " HEXAGAIT_ARGOS;
};

TEST_F(Live, WalksWithoutAPage) {
  const Result result = run(with(robot_, "--headless --seconds 3 --json --late-limit 3s"));
  EXPECT_EQ(result.status, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_GT(json["path_m"].get<double>(), 0.03);
  EXPECT_EQ(json["fault"], "none");
  EXPECT_THAT(result.err, AllOf(HasSubstr("robot: stopped at"), HasSubstr("did not fall")));
}

// The robot's program is told to stop, although Ctrl-C is sent to the whole terminal.
TEST_F(Live, CtrlCStopsTheRobotAndEnds) {
  const pid_t child = start(with(robot_, "--headless"));
  std::this_thread::sleep_for(std::chrono::seconds(2));
  kill(child, SIGINT);
  const Result result = finish(child);
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("robot: stopped at"));
}

TEST_F(Live, SaysWhyItEnded) {
  // A robot that is ended after a second.
  const Result gone = run(with("timeout 1 " + robot_, "--headless"));
  EXPECT_EQ(gone.status, 1);
  EXPECT_THAT(
      gone.err,
      HasSubstr("steer: the robot closed the pipe; its program ended with exit status 124"));
}

TEST_F(Live, SaysWhatCantBeStarted) {
  const auto refuses_program = [&](const std::string& program, const std::string& word) {
    refuses(with(program, "--headless"), {"--live: ", word});
  };
  refuses_program("/nonexistent/robot", "/nonexistent/robot: can't be started: No such file");
  refuses_program("a; b", "must be quoted");
  refuses_program("sh -c \"exit 3\"", "closed the pipe; its program ended with exit status 3");
  refuses_program("echo hello", "sent 6 bytes, beginning with \"hello\"");
  refuses_program("sleep 60", "the robot has sent no state for 5 s");
  refuses("steer --live cat --terrain flat", {"--live", "--terrain"});
  refuses("steer --live cat --plant real", {"--live", "plant"});
  refuses("steer --late-limit 1s", {"--late-limit", "--live"});
  refuses("steer --live cat --late-limit 2ms", {"--late-limit is '2ms'", "10ms to 10s"});
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

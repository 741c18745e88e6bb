// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <termios.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "cli_fixture.hpp"

namespace hexagait::app {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

// The command in a terminal of its own: stdin, stdout and stderr.
class Teleop : public Cli {
 protected:
  ~Teleop() override {
    if (child_ > 0) {
      kill(child_, SIGKILL);
      waitpid(child_, nullptr, 0);
    }
    if (master_ >= 0) close(master_);
    if (slave_ >= 0) close(slave_);
  }

  // The slave stays open here, so that the terminal outlives the command.
  void start_in_terminal(const std::string& options) {
    winsize size{};
    size.ws_row = 24;
    size.ws_col = 200;
    ASSERT_EQ(openpty(&master_, &slave_, nullptr, nullptr, &size), 0);
    tcgetattr(slave_, &before_);
    const std::string line = "cd '" + here().string() + "' && exec " + command_ + " " + options;
    child_ = fork();
    ASSERT_GE(child_, 0);
    if (child_ == 0) {
      setsid();
      for (const int descriptor : {0, 1, 2}) dup2(slave_, descriptor);
      close(master_);
      execl("/bin/sh", "sh", "-c", line.c_str(), static_cast<char*>(nullptr));
      _exit(127);
    }
  }

  void type(const std::string& keys) {
    EXPECT_EQ(::write(master_, keys.data(), keys.size()), static_cast<ssize_t>(keys.size()));
  }

  void read_some(int milliseconds) {
    pollfd waits{master_, POLLIN, 0};
    if (poll(&waits, 1, milliseconds) <= 0) return;
    char bytes[4096];
    const auto count = ::read(master_, bytes, sizeof bytes);
    if (count > 0) shown_.append(bytes, static_cast<std::size_t>(count));
  }

  // Waits until a text is shown after all that was shown when it was called.
  bool shows(const std::string& text) {
    const std::size_t from = shown_.size();
    for (const auto end = Clock::now() + 20s; Clock::now() < end; read_some(50))
      if (shown_.find(text, from) != std::string::npos) return true;
    return false;
  }

  int wait_for_end() {
    for (const auto end = Clock::now() + 20s; Clock::now() < end; read_some(20)) {
      int status = 0;
      if (waitpid(child_, &status, WNOHANG) == 0) continue;
      child_ = 0;
      read_some(100);
      return status;
    }
    ADD_FAILURE() << "it goes on";
    return -1;
  }

  [[nodiscard]] termios now() const {
    termios state{};
    tcgetattr(slave_, &state);
    return state;
  }
  void expect_raw() const {
    EXPECT_EQ(now().c_lflag & (ICANON | ECHO), 0U);
    EXPECT_NE(now().c_lflag & ISIG, 0U) << "Ctrl-C is a signal";
  }
  void expect_restored() const {
    EXPECT_EQ(now().c_lflag, before_.c_lflag);
    EXPECT_EQ(now().c_cc[VSUSP], before_.c_cc[VSUSP]);
    const auto hidden = shown_.rfind("\033[?25l"), back = shown_.rfind("\033[?25h");
    ASSERT_NE(back, std::string::npos);
    EXPECT_GT(back, hidden) << "the cursor is hidden";
  }

  pid_t child_ = 0;
  int master_ = -1, slave_ = -1;
  termios before_{};
  std::string shown_;
};

TEST_F(Teleop, NeedsATerminal) {
#ifdef HEXAGAIT_HAS_VIEWER
  prefix_ = "exec </dev/null; ";
  refuses("walk --teleop", {"--teleop", "stdin is not a terminal"});
#else
  refuses("walk --teleop", {"--teleop", "libwebsockets-dev"});
#endif
}

TEST_F(Teleop, RefusesWhatIsNotForIt) {
  for (const char* const option : {"--path figure_eight", "--distance 2", "--plot w.png",
                                   "--random-commands 5", "--trace w.csv", "--speed 0.1"})
    EXPECT_EQ(run(std::string("walk --teleop ") + option).status, 2) << option;
}

#ifdef HEXAGAIT_HAS_VIEWER
TEST_F(Teleop, IsSteeredByKeys) {
  start_in_terminal("walk --teleop --terrain flat --record w.replay");
  ASSERT_TRUE(shows("walks  r inf  α 0°")) << shown_;
  expect_raw();
  type("aaa");  // 36° of 150° of the wheel, at which it has 2 per metre
  EXPECT_TRUE(shows("walks  r 8.68 m  α 0°")) << shown_;
  type("q");
  EXPECT_TRUE(shows("walks  r 8.68 m  α 15°")) << shown_;
  type("x");
  EXPECT_TRUE(shows("stopped  r 8.68 m")) << shown_;
  type("s");
  EXPECT_TRUE(shows("α -180°") || shows("α 180°")) << shown_;
  type("\x1b");
  EXPECT_TRUE(shows("EMERGENCY STOP: ! releases it")) << shown_;
  type("s");
  EXPECT_TRUE(shows("release it first")) << shown_;
  type("!");
  EXPECT_TRUE(shows("stopped  r ")) << shown_;
  type(" ");
  EXPECT_TRUE(shows("paused")) << shown_;
  type("\x7f");
  EXPECT_TRUE(shows("walks  r inf  α 0°")) << shown_;
  EXPECT_EQ(shown_.find("aaa"), std::string::npos) << "keys are not echoed";

  kill(child_, SIGINT);
  EXPECT_EQ(wait_for_end(), 0);
  expect_restored();
  const auto replay = nlohmann::json::parse(run("replay w.replay --json").out);
  EXPECT_GE(replay["frames"].get<int>(), 6) << "each of the lines above is of a frame";
}

TEST_F(Teleop, LeavesTheTerminalAsItWasAfterASignalOrACrash) {
  for (const int signal : {SIGTERM, SIGSEGV, SIGABRT}) {
    start_in_terminal("walk --teleop --terrain flat --quiet");
    ASSERT_TRUE(shows("walks")) << shown_;
    expect_raw();
    kill(child_, signal);
    const int status = wait_for_end();
    if (signal != SIGTERM) {
      EXPECT_TRUE(WIFSIGNALED(status));
      EXPECT_EQ(WTERMSIG(status), signal);
    }
    expect_restored();
    close(master_);
    close(slave_);
    shown_.clear();
  }
  master_ = slave_ = -1;
}

TEST_F(Teleop, EndsAfterItsSeconds) {
  start_in_terminal("walk --teleop --terrain flat --seconds 0.5");
  EXPECT_EQ(wait_for_end(), 0);
  EXPECT_THAT(shown_, HasSubstr("Walked "));
  expect_restored();
}
#endif

}  // namespace
}  // namespace hexagait::app

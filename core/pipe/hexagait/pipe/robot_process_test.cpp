// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <hexagait/pipe/robot_process.hpp>
#include <hexagait/text/invalid_input.hpp>

namespace hexagait {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::ThrowsMessage;

std::string read_from(int pipe) {
  char bytes[256];
  const ssize_t count = recv(pipe, bytes, sizeof bytes, 0);
  return {bytes, static_cast<std::size_t>(count > 0 ? count : 0)};
}

TEST(RobotProcess, ReadsAndWritesThePipe) {
  const RobotProcess echo({"cat"});
  ASSERT_EQ(send(echo.pipe(), "that\n", 5, 0), 5);
  EXPECT_EQ(read_from(echo.pipe()), "that\n");

  RobotProcess once({"sh", "-c", "echo $1", "sh", "got"});
  EXPECT_EQ(read_from(once.pipe()), "got\n");
  EXPECT_EQ(once.end(5.0), "ended with exit status 0");
  EXPECT_EQ(read_from(once.pipe()), "");
}

TEST(RobotProcess, SaysHowItHasEnded) {
  EXPECT_EQ(RobotProcess({"sh", "-c", "exit 3"}).end(5.0), "ended with exit status 3");
  EXPECT_EQ(RobotProcess({"sh", "-c", "kill -9 $$"}).end(5.0), "was ended by signal 9");
  EXPECT_THAT(RobotProcess({"cat"}).end(), IsEmpty());
}

TEST(RobotProcess, RefusesWhatCantBeStarted) {
  EXPECT_THAT(
      [] { RobotProcess({"/nonexistent/robot"}); },
      ThrowsMessage<InvalidInput>(HasSubstr("/nonexistent/robot: can't be started: No such file")));
  EXPECT_THAT([] { RobotProcess({"/etc/passwd"}); },
              ThrowsMessage<InvalidInput>(HasSubstr("Permission denied")));
  EXPECT_THROW(RobotProcess({}), InvalidInput);
}

// Ctrl-C is sent to the group of the program in the terminal.
TEST(RobotProcess, IsAGroupOfItsOwn) {
  RobotProcess process({"sh", "-c", "echo $$; read word"});
  const pid_t child = std::atoi(read_from(process.pipe()).c_str());
  EXPECT_EQ(getpgid(child), child);
}

TEST(RobotProcess, EndsWithItsOwner) {
  const auto lives_on = [](const char* script) {
    pid_t child = 0;
    const auto begin = std::chrono::steady_clock::now();
    {
      const RobotProcess process({"sh", "-c", script});
      child = std::atoi(read_from(process.pipe()).c_str());
    }
    EXPECT_NE(kill(child, 0), 0) << script;
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  EXPECT_LT(lives_on("echo $$; read word"), RobotProcess::kGrace);      // by the end of the pipe
  EXPECT_GE(lives_on("echo $$; exec sleep 60"), RobotProcess::kGrace);  // by SIGTERM
  EXPECT_GE(lives_on("trap '' TERM; echo $$; exec sleep 60"), 2.0 * RobotProcess::kGrace);
}

TEST(CommandWords, AreThoseOfAShell) {
  setenv("HEXAGAIT_WORD", "three", 1);
  EXPECT_THAT(command_words("one 'two words' $HEXAGAIT_WORD"),
              ElementsAre("one", "two words", "three"));
  for (const char* const bad : {"", "  ", "a 'b", "a; b", "a | b", "a $(b)", "a $HEXAGAIT_NO_WORD"})
    EXPECT_THAT([&] { (void)command_words(bad); },
                ThrowsMessage<InvalidInput>(HasSubstr(std::string("'") + bad + "'")));
}

}  // namespace
}  // namespace hexagait

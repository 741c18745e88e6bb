// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

namespace hexagait {

/// A program that is a robot: its standard input and output are the far end of a pipe for a PipePlant.
/// It is a process group of its own, so Ctrl-C in the terminal does not end it before it has been told to
/// stop.
class RobotProcess {
 public:
  /// Starts it.
  /// @param words  the program, which is looked for as a shell does, and its arguments
  /// @throws InvalidInput  if it can't be started
  explicit RobotProcess(const std::vector<std::string>& words);

  /// Closes the pipe and waits until the program has ended. One that goes on is sent SIGTERM after
  /// kGrace, and is killed after another kGrace.
  ~RobotProcess();
  RobotProcess(const RobotProcess&) = delete;
  RobotProcess& operator=(const RobotProcess&) = delete;

  static constexpr double kGrace = 1.0;  ///< time to end by itself [s]

  /// This end of the pipe, for a PipePlant; open as long as this object lives.
  [[nodiscard]] int pipe() const { return pipe_; }

  /// How it has ended: "ended with exit status 3", "was ended by signal 11"; empty while it goes on.
  /// @param patience  time to wait for its end [s]
  [[nodiscard]] std::string end(double patience = 0.0);

 private:
  int pipe_ = -1;
  pid_t child_ = 0;
  std::optional<int> status_;
};

/// The words of a command line, quoted as for a shell, with ~, $NAME and *; it runs no other commands.
/// @throws InvalidInput  if it has none, or can't be read
[[nodiscard]] std::vector<std::string> command_words(const std::string& line);

}  // namespace hexagait

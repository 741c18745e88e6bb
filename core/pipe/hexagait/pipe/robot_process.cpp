// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <wordexp.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <hexagait/pipe/robot_process.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <thread>

namespace hexagait {
namespace {

[[noreturn]] void refuse(const std::string& program, int error) {
  throw InvalidInput(program + ": can't be started: " + std::strerror(error));
}

// What the child begins with: the far end as its standard input and output, a process group of its own.
class SpawnSetup {
 public:
  explicit SpawnSetup(int far_end) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_adddup2(&actions_, far_end, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, far_end, STDOUT_FILENO);
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setpgroup(&attributes_, 0);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP);
  }
  ~SpawnSetup() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  SpawnSetup(const SpawnSetup&) = delete;
  SpawnSetup& operator=(const SpawnSetup&) = delete;

  [[nodiscard]] const posix_spawn_file_actions_t* actions() const { return &actions_; }
  [[nodiscard]] const posix_spawnattr_t* attributes() const { return &attributes_; }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

}  // namespace

RobotProcess::RobotProcess(const std::vector<std::string>& words) {
  if (words.empty()) throw InvalidInput("a robot's program has no name");
  int ends[2] = {-1, -1};
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0) refuse(words[0], errno);
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const SpawnSetup setup(ends[1]);
  const int error = posix_spawnp(&child_, arguments[0], setup.actions(), setup.attributes(),
                                 arguments.data(), environ);
  ::close(ends[1]);
  pipe_ = ends[0];
  if (error == 0) return;
  ::close(pipe_);
  refuse(words[0], error);
}

RobotProcess::~RobotProcess() {
  ::close(pipe_);
  for (const int signal : {SIGTERM, SIGKILL})
    if (end(kGrace).empty()) kill(child_, signal);
  if (end().empty()) waitpid(child_, nullptr, 0);
}

std::string RobotProcess::end(double patience) {
  using Clock = std::chrono::steady_clock;
  const auto last = Clock::now() + std::chrono::duration<double>(patience);
  while (!status_) {
    int status = 0;
    if (waitpid(child_, &status, WNOHANG) != 0) {
      status_ = status;
    } else {
      if (Clock::now() >= last) return {};
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
  if (WIFSIGNALED(*status_)) return "was ended by signal " + std::to_string(WTERMSIG(*status_));
  return "ended with exit status " + std::to_string(WEXITSTATUS(*status_));
}

std::vector<std::string> command_words(const std::string& line) {
  wordexp_t found{};
  const int error = wordexp(line.c_str(), &found, WRDE_NOCMD | WRDE_UNDEF);
  if (error != 0)
    throw InvalidInput("'" + line + "' is no program with arguments: " +
                       (error == WRDE_CMDSUB   ? "it may not run other commands"
                        : error == WRDE_BADVAL ? "it uses a variable that is not set"
                        : error == WRDE_SYNTAX ? "a quotation mark is not closed"
                                               : "characters as | & ; < > ( ) { } must be quoted"));
  std::vector<std::string> words(found.we_wordv, found.we_wordv + found.we_wordc);
  wordfree(&found);
  if (words.empty()) throw InvalidInput("'" + line + "' names no program");
  return words;
}

}  // namespace hexagait

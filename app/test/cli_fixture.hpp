// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

/// The command in a process of its own, for tests.
namespace hexagait::app {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

inline std::string content(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

struct Result {
  int status = -1;
  std::string out, err;
};

// Every test has an empty directory, in which the command runs. Output is caught outside of it.
class Cli : public ::testing::Test {
 protected:
  Cli() {
    std::string pattern = ::testing::TempDir() + "hexagait-cli-XXXXXX";
    root_ = mkdtemp(pattern.data());
    fs::create_directory(here());
  }
  ~Cli() override { fs::remove_all(root_); }

  [[nodiscard]] fs::path here() const { return root_ / "here"; }

  pid_t start(const std::string& arguments) {
    const std::string line = "cd '" + here().string() + "' && " + prefix_ + "exec " + command_ +
                             " >../out 2>../err " + arguments;
    std::string shell = "sh", option = "-c", command = line;
    char* const words[] = {shell.data(), option.data(), command.data(), nullptr};
    pid_t child = 0;
    EXPECT_EQ(posix_spawnp(&child, "sh", nullptr, nullptr, words, environ), 0);
    return child;
  }

  Result finish(pid_t child) {
    int status = 0;
    waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content(root_ / "out"),
            content(root_ / "err")};
  }

  [[nodiscard]] std::string err_so_far() const { return content(root_ / "err"); }

  Result run(const std::string& arguments) { return finish(start(arguments)); }

  // Bad input: status 2, nothing on stdout, one message that names all of `words`, and no file.
  void refuses(const std::string& arguments, const std::vector<std::string>& words) {
    const Result result = run(arguments);
    EXPECT_EQ(result.status, 2) << arguments;
    EXPECT_THAT(result.out, IsEmpty()) << arguments;
    EXPECT_TRUE(result.err.starts_with("hexagait: ")) << arguments << '\n' << result.err;
    for (const std::string& word : words) EXPECT_THAT(result.err, HasSubstr(word)) << arguments;
    EXPECT_TRUE(fs::is_empty(here())) << arguments;
  }

  void write(const std::string& name, const std::string& text) {
    std::ofstream(root_ / name) << text;
  }

  std::string command_ = HEXAGAIT_COMMAND;
  std::string prefix_;  // shell commands before it, each with its semicolon

 private:
  fs::path root_;
};

}  // namespace hexagait::app

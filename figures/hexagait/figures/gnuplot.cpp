// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <hexagait/figures/gnuplot.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <iterator>
#include <sstream>
#include <system_error>
#include <utility>

namespace hexagait::figures {
namespace {

namespace fs = std::filesystem;
constexpr const char* kLog = "gnuplot.log";

// Exit status of `gnuplot -e assignment script`, run in a directory; its messages go to kLog there.
int spawn_gnuplot(const fs::path& directory, std::string assignment, std::string script) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, directory.c_str());
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, kLog, O_WRONLY | O_CREAT | O_TRUNC,
                                   0600);
  posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
  std::string program = "gnuplot", option = "-e";
  char* const arguments[] = {program.data(), option.data(), assignment.data(), script.data(),
                             nullptr};
  pid_t child = 0;
  const int failed = posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  int status = 0;
  if (failed != 0 || waitpid(child, &status, 0) < 0) return -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

// gnuplot writes "Family:Bold" as the name of a family, and none for where that is missing.
void name_fonts(const fs::path& svg) {
  std::ifstream file(svg, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  file.close();
  const std::pair<std::string, std::string> names[] = {
      {":Bold\"", "\" font-weight=\"bold\""},
      {"\"DejaVu Sans\"", "\"DejaVu Sans, Verdana, sans-serif\""},
      {"\"DejaVu Sans Mono\"", "\"DejaVu Sans Mono, Consolas, monospace\""}};
  for (const auto& [old, better] : names)
    for (std::size_t at = 0; (at = text.find(old, at)) != std::string::npos; at += better.size())
      text.replace(at, old.size(), better);
  std::ofstream(svg, std::ios::binary) << text;
}

// gnuplot does not notice that the disk is full.
void require_whole(const fs::path& figure) {
  const std::string suffix = figure.extension();
  const std::string end = suffix == ".svg"   ? "</svg>"
                          : suffix == ".pdf" ? "%%EOF"
                          : suffix == ".gif" ? ";"  // the trailer
                                             : "IEND";
  std::ifstream file(figure, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (suffix == ".gif" ? !text.ends_with(end) : text.rfind(end) == std::string::npos)
    throw std::system_error(
        std::make_error_code(std::errc::io_error),
        "gnuplot left " + figure.filename().string() + " incomplete; is the disk full?");
}

}  // namespace

void require_gnuplot() {
  const char* const path = std::getenv("PATH");
  std::istringstream directories(path != nullptr ? path : "");
  for (std::string directory; std::getline(directories, directory, ':');)
    if (access((directory + "/gnuplot").c_str(), X_OK) == 0) return;
  throw InvalidInput(
      "figures are drawn by gnuplot, which is not in PATH; on Debian: apt install gnuplot-nox");
}

void run_gnuplot(const fs::path& directory, const std::string& script, const std::string& figure) {
  if (spawn_gnuplot(directory, "figure=" + in_quotes(figure), script) == 0) {
    if (figure.ends_with(".svg")) name_fonts(directory / figure);
    return require_whole(directory / figure);
  }
  std::ifstream log(directory / kLog);
  const std::string said{std::istreambuf_iterator<char>(log), {}};
  throw InvalidInput(fmt::format("gnuplot could not draw {}:\n{}", figure, said));
}

std::string in_quotes(const std::string& text) {
  std::string result = "'";
  for (const char letter : text)
    result.append(letter == '\'' ? 2 : 1, letter == '\n' ? ' ' : letter);
  return result + "'";
}

}  // namespace hexagait::figures

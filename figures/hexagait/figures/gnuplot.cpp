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

constexpr const char* kTerminals = R"(
# The suffix of the file chooses the terminal.
suffix = figure[strlen(figure)-2:strlen(figure)]
font = "DejaVu Sans"
if (suffix eq "png") set terminal pngcairo size width, height font font.",10.5" enhanced rounded
if (suffix eq "svg") set terminal svg size width, height font font.",14" enhanced rounded \
    background "white"
if (suffix eq "pdf") set terminal pdfcairo size width/100.0*1.0in, height/100.0*1.0in \
    font font.",10.5" enhanced rounded
# SVG counts fonts in pixels, the others in points.
sized(style, points) = sprintf("%s%s,%g", font, style, suffix eq "svg" ? points/0.75 : points)
set output figure
set encoding utf8
set datafile separator ","
set datafile missing ""

# Palette: one accent for what happened, grey for what was asked, two quiet colours for the sides.
ink = "#1d2b36"; grey = "#8c99a5"; pale = "#e3e8ec"; accent = "#c4472b"
left_side = "#2f6f9f"; right_side = "#c99a2e"; earth = "#b9a88f"
# Shades of a gait state's type, A (1) … D (4); a gait diagram's legend of them begins at the share
# legend_x of the graph and goes on by legend_step.
type_shade(k) = k == 4 ? 0x5d7a8c : k == 3 ? 0x93a9b7 : k == 2 ? 0xbccad4 : k == 1 ? 0xdfe6eb : 0xffffff
gait_legend = 'do for [k=1:4] { \
  set label 10+k "■" at graph legend_x+legend_step*k, graph 1 offset 0, 0.9 left \
      textcolor rgb type_shade(k); \
  set label 20+k "ABCD"[k:k] at graph legend_x+legend_step*(k+0.4), graph 1 offset 0, 0.9 left \
      textcolor rgb ink font sized("", 9) }; \
  set label 10 "type of state" at graph legend_x+0.8*legend_step, graph 1 offset 0, 0.9 right \
      textcolor rgb ink font sized("", 9)'
set border 3 lc rgb grey lw 0.8
set tics nomirror scale 0.5 textcolor rgb ink
set grid lc rgb pale lw 0.8 lt 1
set title textcolor rgb ink
set xlabel textcolor rgb ink
set ylabel textcolor rgb ink
set key textcolor rgb ink
)";

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
  if (spawn_gnuplot(directory, "figure=" + quoted(figure), script) == 0) {
    if (figure.ends_with(".svg")) name_fonts(directory / figure);
    return;
  }
  std::ifstream log(directory / kLog);
  const std::string said{std::istreambuf_iterator<char>(log), {}};
  throw std::runtime_error(fmt::format("gnuplot could not draw {}:\n{}", figure, said));
}

void draw_figure(StagedFiles& files, const std::string& stem) {
  for (const char* suffix : {".svg", ".pdf", ".png"}) {
    files.expect(stem + suffix);
    run_gnuplot(files.staging(), stem + ".gp", stem + suffix);
  }
}

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char letter : text)
    result.append(letter == '\'' ? 2 : 1, letter == '\n' ? ' ' : letter);
  return result + "'";
}

std::string figure_preamble(const std::string& figure, int width, int height) {
  return fmt::format(
             "# gnuplot -e \"figure='other.svg'\" draws it as .svg, .pdf or .png.\n"
             "if (!exists(\"figure\")) figure = {}\nwidth = {}; height = {}\n",
             quoted(figure), width, height) +
         kTerminals;
}

}  // namespace hexagait::figures

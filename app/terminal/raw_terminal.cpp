// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include "terminal/raw_terminal.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <hexagait/text/invalid_input.hpp>

namespace hexagait::app {
namespace {

constexpr char kHideCursor[] = "\033[?25l", kEnd[] = "\r\033[K\033[?25h";
// The signals that end a process and that interrupt.hpp does not catch.
constexpr int kDeadly[] = {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGQUIT};

termios before;  // read by a signal handler, so it is set before that one is

// Calls only what a signal handler may call.
void restore() {
  tcsetattr(STDIN_FILENO, TCSANOW, &before);
  [[maybe_unused]] const auto written = write(STDERR_FILENO, kEnd, sizeof(kEnd) - 1);
}

// SA_RESETHAND: raised again, the signal ends the process as if it had not been caught.
void restore_and_die(int signal) {
  restore();
  raise(signal);
}

void on_deadly_signals(void (*handler)(int)) {
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : kDeadly) sigaction(signal, &action, nullptr);
}

std::size_t columns() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1 ? size.ws_col : 80;
}

}  // namespace

void require_terminal(const char* option) {
  for (const auto& [descriptor, name] :
       {std::pair{STDIN_FILENO, "stdin"}, {STDERR_FILENO, "stderr"}})
    if (isatty(descriptor) == 0)
      throw InvalidInput(fmt::format(
          "{}: {} is not a terminal; without one, --commands FILE has the headings of a "
          "walk",
          option, name));
}

RawTerminal::RawTerminal() {
  tcgetattr(STDIN_FILENO, &before);
  on_deadly_signals(restore_and_die);
  std::signal(SIGHUP, SIG_IGN);  // a terminal that is gone is an end like any other: see read()

  termios raw = before;
  raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  raw.c_cc[VMIN] = 1;
  raw.c_cc[VTIME] = 0;
  raw.c_cc[VSUSP] = raw.c_cc[VQUIT] = _POSIX_VDISABLE;
  tcsetattr(STDIN_FILENO, TCSANOW, &raw);
  fmt::print(stderr, "{}", kHideCursor);
  std::fflush(stderr);
}

RawTerminal::~RawTerminal() {
  restore();
  on_deadly_signals(SIG_DFL);
}

std::optional<std::string> RawTerminal::read(int milliseconds) const {
  pollfd waits{STDIN_FILENO, POLLIN, 0};
  const int ready = poll(&waits, 1, milliseconds);
  if (ready == 0 || (ready < 0 && errno == EINTR)) return "";
  if (ready < 0) return {};
  char bytes[64];
  const auto count = ::read(STDIN_FILENO, bytes, sizeof bytes);
  if (count > 0) return std::string(bytes, static_cast<std::size_t>(count));
  if (count < 0 && (errno == EINTR || errno == EAGAIN)) return "";
  return {};
}

void RawTerminal::show(const std::string& utf8) const {
  fmt::print(stderr, "\r{}\033[K", first_characters(utf8, columns() - 1));
  std::fflush(stderr);
}

std::string first_characters(const std::string& utf8, std::size_t count) {
  const auto begins = [&](std::size_t i) {
    return (static_cast<unsigned char>(utf8[i]) & 0xC0U) != 0x80U;
  };
  for (std::size_t i = 0, seen = 0; i < utf8.size(); ++i)
    if (begins(i) && seen++ == count) return utf8.substr(0, i);
  return utf8;
}

}  // namespace hexagait::app

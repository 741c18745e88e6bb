// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include "terminal/output.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <ios>
#include <system_error>

namespace hexagait::app {
namespace {

int stdout_error = 0;  // the first errno

void flush() {
  if (std::fflush(stdout) != 0 && stdout_error == 0) stdout_error = errno;
}

}  // namespace

void reserve_standard_descriptors() {
  // Opened for reading only: printing on a stream that was closed must fail.
  while (true) {
    const int descriptor = open("/dev/null", O_RDONLY | O_CLOEXEC);
    if (descriptor > STDERR_FILENO) close(descriptor);
    if (descriptor < 0 || descriptor > STDERR_FILENO) return;
  }
}

void print_out(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() && stdout_error == 0)
    stdout_error = errno;
  flush();
}

std::string stdout_problem() {
  flush();
  if (stdout_error != 0) return std::strerror(stdout_error);
  return std::ferror(stdout) != 0 ? "write error" : "";
}

std::string write_problem(const std::function<void()>& write) {
  try {
    errno = 0;
    write();
    return "";
  } catch (const std::ios_base::failure&) {
    return errno != 0 ? std::strerror(errno) : "write error";
  } catch (const std::system_error& error) {
    return error.what();
  }
}

}  // namespace hexagait::app

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace hexagait::app {

/// @param option  begins the message
/// @throws InvalidInput  if stdin or stderr is no terminal
void require_terminal(const char* option);

/// The terminal of this process, stdin and stderr, from which keys are read as they are pressed, without an echo.
/// Ctrl-C is a signal as ever; Ctrl-Z and Ctrl-\ are off, since a stopped process could not steer.
/// The terminal is as it was again when this is destroyed, and before the process dies of a signal
/// that it can catch. There can be only one.
class RawTerminal {
 public:
  RawTerminal();
  ~RawTerminal();
  RawTerminal(const RawTerminal&) = delete;
  RawTerminal& operator=(const RawTerminal&) = delete;

  /// Waits for bytes for so long [ms]. @returns what came, perhaps nothing; none: the terminal is gone
  [[nodiscard]] std::optional<std::string> read(int milliseconds) const;

  /// Shows a line, on stderr, in place of the one before, cut to the terminal's width.
  /// @param utf8  without escapes; each character takes one column
  void show(const std::string& utf8) const;
};

/// The first so many characters. @param utf8  well-formed
[[nodiscard]] std::string first_characters(const std::string& utf8, std::size_t count);

}  // namespace hexagait::app

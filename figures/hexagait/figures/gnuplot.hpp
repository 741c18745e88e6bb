// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <hexagait/figures/staged_files.hpp>
#include <string>

namespace hexagait::figures {

/// @throws InvalidInput  if there is no gnuplot, saying how to get it
void require_gnuplot();

/// Runs a script in its directory; it draws into the file named by its variable `figure`.
/// @throws std::runtime_error  with what gnuplot said, if it fails
void run_gnuplot(const std::filesystem::path& directory, const std::string& script,
                 const std::string& figure);

/// A text as a gnuplot string, in single quotes.
[[nodiscard]] std::string in_quotes(const std::string& text);

}  // namespace hexagait::figures

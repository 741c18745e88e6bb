// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

namespace hexagait::app {

/// Makes files that are opened later get descriptors above 2, also if the caller has closed some
/// of the first three: what is printed must not get into a file.
void reserve_standard_descriptors();

/// Prints on stdout, without a buffer that is written later.
void print_out(const std::string& text);

/// Why something printed on stdout since the start was not written; empty: all was.
[[nodiscard]] std::string stdout_problem();

/// Does something that writes files.
/// @returns why a file could not be written, such as "No space left on device"; empty: all were
[[nodiscard]] std::string write_problem(const std::function<void()>& write);

}  // namespace hexagait::app

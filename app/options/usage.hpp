// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <span>

namespace hexagait::app {

/// Puts all options of a command that have no heading yet under one.
void group(CLI::App& command, const char* heading);

/// Lets an option that needs a value refuse an empty one.
void refuse_empty_values(CLI::App& app);

/// The command and the names of its options are known.
/// @param words  without the program's name
/// @throws InvalidInput  naming the first that is not, and the one that was probably meant
void check_words(const CLI::App& app, std::span<const char* const> words);

}  // namespace hexagait::app

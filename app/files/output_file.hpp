// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <hexagait/figures/staged_files.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hexagait::app {

/// A file that an option names, and those that are written with it.
struct OutputFile {
  std::filesystem::path path;
  figures::StagedFiles files;
};

/// Nothing without the option.
/// @throws InvalidInput  for a wrong suffix, or a directory that can't be written
[[nodiscard]] std::optional<OutputFile> output_file(const char* option, const std::string& name,
                                                    const std::vector<std::string>& suffixes);

/// Writes the file that an option names.
/// @throws InvalidInput  naming it and the reason if it can't be written
void write_output(const char* option, const OutputFile& file, const std::function<void()>& write);
/// The same of a file that is one text, which then is in its place.
void write_text(const char* option, OutputFile& file, std::string_view text);
[[noreturn]] void refuse_output(const char* option, const OutputFile& file,
                                const std::string& problem);

}  // namespace hexagait::app

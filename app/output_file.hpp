// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/figures/staged_files.hpp>
#include <optional>
#include <string>
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

}  // namespace hexagait::app

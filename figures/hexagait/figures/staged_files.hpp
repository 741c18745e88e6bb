// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace hexagait::figures {

/// Files that appear in a directory when all of them are whole, or not at all: they are written in
/// a hidden directory beside their places, and renamed.
class StagedFiles {
 public:
  /// @throws InvalidInput  if the directory does not exist or can't be written
  explicit StagedFiles(const std::filesystem::path& directory);
  ~StagedFiles();
  StagedFiles(StagedFiles&& other) noexcept;
  StagedFiles(const StagedFiles&) = delete;
  StagedFiles& operator=(const StagedFiles&) = delete;
  StagedFiles& operator=(StagedFiles&&) = delete;

  /// Registers a file that will be written into staging().
  /// @throws InvalidInput  if something that is not a file is in its place
  void expect(const std::string& name);

  /// Opens a file in staging(); a write that fails throws.
  [[nodiscard]] std::ofstream open(const std::string& name) const;

  /// expect() and open().
  [[nodiscard]] std::ofstream create(const std::string& name);

  /// expect(), and the whole file.
  /// @throws std::system_error  if it can't be written, with its path and why
  void write(const std::string& name, std::string_view text);

  /// Where files are until they are published.
  [[nodiscard]] const std::filesystem::path& staging() const { return staging_; }
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

  /// FNV-1a of the bytes of a file that is not published yet.
  [[nodiscard]] std::uint64_t hash(const std::string& name) const;

  /// Puts all files in their places, where they replace older ones.
  void publish();

 private:
  std::filesystem::path directory_, staging_;
  std::vector<std::string> names_;
};

}  // namespace hexagait::figures

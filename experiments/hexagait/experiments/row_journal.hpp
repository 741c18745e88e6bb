// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

namespace hexagait::experiments {

/// Rows of an experiment that takes long, each under its number, in a file that outlives the run: a
/// later run with the same key goes on where this one ended.
class RowJournal {
 public:
  /// Takes over what is in the file, if it has the same key; else begins it anew. A line that was
  /// not written to its end is left out.
  /// @param file  its directory exists
  /// @param key   all on which the rows depend, a line
  /// @throws InvalidInput  if it can't be written
  RowJournal(const std::filesystem::path& file, const std::string& key);

  [[nodiscard]] const std::map<std::uint64_t, std::string>& rows() const { return rows_; }
  /// @param row  a line
  /// @throws InvalidInput  if it can't be written
  void add(std::uint64_t number, const std::string& row);
  /// All rows are in: the file is not needed any longer.
  void remove();

 private:
  std::filesystem::path path_;
  std::map<std::uint64_t, std::string> rows_;
  std::ofstream file_;
};

}  // namespace hexagait::experiments

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

namespace hexagait::sweep {

/// Makes a directory for results, and those above it, where they don't exist. The destructor removes
/// those that it made and that are still empty, unless keep() was called.
class MadeDirectory {
 public:
  /// @throws InvalidInput  if it can't be made
  explicit MadeDirectory(const std::filesystem::path& directory);
  ~MadeDirectory();
  MadeDirectory(const MadeDirectory&) = delete;
  MadeDirectory& operator=(const MadeDirectory&) = delete;

  /// The directories stay, even if the power fails now.
  void keep();

 private:
  std::vector<std::filesystem::path> made_;  ///< the innermost first
};

/// Waits until the names in a directory are on the disk, as far as its file system knows that.
void sync_directory(const std::filesystem::path& directory);

}  // namespace hexagait::sweep

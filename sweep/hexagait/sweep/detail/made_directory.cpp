// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <hexagait/sweep/detail/made_directory.hpp>
#include <hexagait/text/invalid_input.hpp>

namespace hexagait::sweep {

namespace fs = std::filesystem;

MadeDirectory::MadeDirectory(const fs::path& directory) {
  std::error_code error;
  const fs::path whole = fs::absolute(directory);
  for (fs::path path = whole; !fs::exists(path, error) && path.has_relative_path();
       path = path.parent_path())
    if (path.has_filename()) made_.push_back(path);
  fs::create_directories(whole, error);
  if (!error && !fs::is_directory(whole)) error = std::make_error_code(std::errc::not_a_directory);
  if (!error) return;
  for (const fs::path& path : made_) {
    std::error_code ignored;
    fs::remove(path, ignored);
  }
  throw InvalidInput(
      fmt::format("can't make the directory '{}': {}", directory.string(), error.message()));
}

MadeDirectory::~MadeDirectory() {
  std::error_code ignored;
  for (const fs::path& path : made_) fs::remove(path, ignored);  // succeeds only if it is empty
}

void MadeDirectory::keep() {
  for (const fs::path& path : made_) sync_directory(path.parent_path());
  made_.clear();
}

void sync_directory(const fs::path& directory) {
  const int file = open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0) return;
  static_cast<void>(fsync(file));
  close(file);
}

}  // namespace hexagait::sweep

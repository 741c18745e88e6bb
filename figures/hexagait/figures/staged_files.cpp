// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <stdlib.h>

#include <cerrno>
#include <cstring>
#include <hexagait/figures/staged_files.hpp>
#include <hexagait/sim/fnv1a.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <iterator>
#include <utility>

namespace hexagait::figures {

namespace fs = std::filesystem;

StagedFiles::StagedFiles(const fs::path& directory)
    : directory_(directory.empty() ? fs::path(".") : directory) {
  std::string pattern = directory_ / ".hexagait-XXXXXX";
  if (mkdtemp(pattern.data()) == nullptr)
    throw InvalidInput(fmt::format("can't write in the directory '{}': {}", directory_.string(),
                                   std::strerror(errno)));
  staging_ = pattern;
}

StagedFiles::~StagedFiles() {
  std::error_code ignored;
  if (!staging_.empty()) fs::remove_all(staging_, ignored);
}

StagedFiles::StagedFiles(StagedFiles&& other) noexcept
    : directory_(std::move(other.directory_)),
      staging_(std::exchange(other.staging_, fs::path())),
      names_(std::move(other.names_)) {}

void StagedFiles::expect(const std::string& name) {
  const fs::path place = directory_ / name;
  std::error_code ignored;
  if (fs::exists(place, ignored) && !fs::is_regular_file(place, ignored))
    throw InvalidInput(fmt::format("'{}' exists and is not a file", place.string()));
  names_.push_back(name);
}

std::ofstream StagedFiles::open(const std::string& name) const {
  std::ofstream file;
  file.exceptions(std::ios::failbit | std::ios::badbit);
  file.open(staging_ / name, std::ios::binary);
  return file;
}

std::ofstream StagedFiles::create(const std::string& name) {
  expect(name);
  return open(name);
}

void StagedFiles::write(const std::string& name, std::string_view text) {
  expect(name);
  std::ofstream file(staging_ / name, std::ios::binary);
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();
  if (!file)
    throw std::system_error(errno, std::generic_category(),
                            fmt::format("can't write '{}'", (directory_ / name).string()));
}

std::uint64_t StagedFiles::hash(const std::string& name) const {
  std::ifstream file(staging_ / name, std::ios::binary);
  std::uint64_t hash = kFnv1aBasis;
  for (std::istreambuf_iterator<char> byte(file), end; byte != end; ++byte)
    hash = fnv1a(static_cast<unsigned char>(*byte), hash);
  return hash;
}

void StagedFiles::publish() {
  for (const std::string& name : names_) fs::rename(staging_ / name, directory_ / name);
}

}  // namespace hexagait::figures

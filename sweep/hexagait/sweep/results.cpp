// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <chrono>
#include <hexagait/figures/staged_files.hpp>
#include <hexagait/sim/fnv1a.hpp>
#include <hexagait/sweep/detail/header.hpp>
#include <hexagait/sweep/detail/journal.hpp>
#include <hexagait/sweep/detail/made_directory.hpp>
#include <hexagait/sweep/results.hpp>

namespace hexagait::sweep {
namespace {

namespace fs = std::filesystem;
using figures::StagedFiles;

std::runtime_error cant_write(const fs::path& directory) {
  return std::runtime_error(
      fmt::format("can't write the results into '{}' (is the disk full?); the journal has all "
                  "finished trials: make room and run the same command again",
                  directory.string()));
}

// Writes lines and knows the hash of them.
class HashedFile {
 public:
  explicit HashedFile(std::ofstream file) : file_(std::move(file)) {}
  void line(const std::string& text) {
    file_ << text << '\n';
    hash_ = fnv1a("\n", fnv1a(text, hash_));
  }
  void close() { file_.close(); }
  [[nodiscard]] std::uint64_t hash() const { return hash_; }

 private:
  std::ofstream file_;
  std::uint64_t hash_ = fnv1a("");
};

Published write(JournalReader& journal, const fs::path& directory) {
  const Header header = parse_header(journal.header(), journal_path(directory).string());
  figures::StagedFiles files(directory);
  HashedFile trials(files.create("trials.csv")), timings(files.create("timings.csv"));
  trials.line(header.columns);
  timings.line("trial,wall_s");
  Published published;
  double wall = 0.0;
  while (const std::optional<Entry> entry = journal.next()) {
    trials.line(entry->row);
    timings.line(fmt::format("{},{}", entry->trial, entry->wall));
    wall += std::strtod(entry->wall.c_str(), nullptr);
    ++published.trials;
    published.without_result += has_no_result(entry->row) ? 1 : 0;
  }
  trials.close();
  timings.close();
  published.rows_hash = trials.hash();
  std::ofstream manifest = files.create("manifest.json");
  manifest << to_manifest(journal.header(), published.trials, published.rows_hash, wall) << '\n';
  manifest.close();
  files.publish();
  sync_directory(directory);
  return published;
}

}  // namespace

Published publish(const fs::path& directory) {
  JournalReader journal(directory);
  try {
    return write(journal, directory);
  } catch (const std::ios::failure&) {
    throw cant_write(directory);
  }
}

}  // namespace hexagait::sweep

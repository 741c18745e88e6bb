// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <hexagait/figures/staged_files.hpp>
#include <hexagait/sweep/detail/header.hpp>
#include <hexagait/sweep/detail/journal.hpp>
#include <hexagait/sweep/detail/made_directory.hpp>
#include <hexagait/sweep/results.hpp>
#include <hexagait/text/invalid_input.hpp>

namespace hexagait::sweep {
namespace {

namespace fs = std::filesystem;

InvalidInput cant_write(const fs::path& directory) {
  return InvalidInput(
      fmt::format("can't write the results into '{}' (is the disk full?); the journal has all "
                  "finished trials: make room and run the same command again",
                  directory.string()));
}

Published write(JournalReader& journal, const fs::path& directory) {
  const Header header = parse_header(journal.header(), journal_path(directory).string());
  figures::StagedFiles files(directory);
  std::ofstream trials = files.create("trials.csv"), timings = files.create("timings.csv");
  trials << header.columns << '\n';
  timings << "trial,wall_s\n";
  Published published;
  double wall = 0.0;
  while (const std::optional<Entry> entry = journal.next()) {
    trials << entry->row << '\n';
    timings << entry->trial << ',' << entry->wall << '\n';
    wall += std::strtod(entry->wall.c_str(), nullptr);
    ++published.trials;
    published.without_result += has_no_result(entry->row) ? 1 : 0;
  }
  trials.close();
  timings.close();
  published.rows_hash = files.hash("trials.csv");
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

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <hexagait/sweep/sweep.hpp>

namespace hexagait::sweep {

/// First line of a journal, all that decides its rows, as JSON: provenance, configuration, shard.
[[nodiscard]] std::string to_header(const Sweep& sweep, const Shard& shard);

/// What merging and reporting need to know of a header.
struct Header {
  Engine engine = Engine::slice;
  std::string columns;       ///< first line of trials.csv
  std::string measure;       ///< column that a report is about
  std::uint64_t trials = 0;  ///< of the whole sweep
  Shard shard;
};

/// Inverse of to_header().
/// @param place  names it in messages
/// @throws InvalidInput  if it is none, or of another format
[[nodiscard]] Header parse_header(const std::string& header, const std::string& place);

/// The same header with all shards in one.
[[nodiscard]] std::string whole_header(const std::string& header);

/// What differs between two headers, as lines "physics.friction: 0.9 against 0.5"; the shard counts
/// only if `with_shard`.
[[nodiscard]] std::vector<std::string> differences(const std::string& here,
                                                   const std::string& there, bool with_shard);

/// manifest.json: the header, the hash of trials.csv; all that depends on the machine's speed under
/// "timing".
/// @param wall  time that all trials took together [s]
[[nodiscard]] std::string to_manifest(const std::string& header, std::uint64_t trials,
                                      std::uint64_t rows_hash, double wall);

/// @throws InvalidInput  if the journal of a directory is of another sweep or shard
void require_same(const std::string& wanted, const std::string& found,
                  const std::filesystem::path& directory);

}  // namespace hexagait::sweep

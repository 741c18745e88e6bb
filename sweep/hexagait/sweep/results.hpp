// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <hexagait/sweep/run_shard.hpp>
#include <vector>

namespace hexagait::sweep {

/// What publish() wrote.
struct Published {
  std::uint64_t trials = 0;
  std::uint64_t rows_hash = 0;       ///< FNV-1a of trials.csv
  std::uint64_t without_result = 0;  ///< of the trials, those that failed or timed out
};

/// Writes what a journal has, in the order of the trials: trials.csv, timings.csv (all that depends
/// on the machine's speed) and manifest.json. All are written before the first takes its place; then
/// each appears at once, manifest.json last: whoever finds it has all three, unless the power failed
/// or the disk broke in between. The journal has everything, so publish() again mends that.
/// @throws InvalidInput        if the journal is damaged
/// @throws InvalidInput  if they can't be written
Published publish(const std::filesystem::path& directory);

/// Puts the journals of several directories together, in one that is made, and publishes it.
/// @throws InvalidInput  listing all trials that are missing, or there twice, or what differs
///                       between the configurations
Published merge(const std::vector<std::filesystem::path>& parts,
                const std::filesystem::path& directory);

}  // namespace hexagait::sweep

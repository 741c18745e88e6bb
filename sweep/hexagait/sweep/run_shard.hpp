// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <filesystem>
#include <hexagait/sweep/sweep.hpp>

namespace hexagait::sweep {

/// What run_shard() is asked for beside the shard.
struct RunOptions {
  int jobs = 1;                             ///< worker processes
  const std::atomic<bool>* stop = nullptr;  ///< once true, it ends early
  /// How long a trial may take [s]; 0: default_time_limit().
  double trial_timeout = 0.0;
  bool retry = false;  ///< trials without a result are run again, before those that are missing
  /// Told now and then how many trials of this run are finished.
  std::function<void(std::uint64_t finished, std::uint64_t whole)> progress = {};
  /// How a trial is run: a test may give another.
  std::function<std::string(const Sweep& sweep, std::uint64_t k)> row = sweep::row;
};

/// Far more than any trial of a sweep needs, and finite: a minute, and ten times what it simulates
/// [s].
[[nodiscard]] double default_time_limit(const Sweep& sweep);

/// First and last of successive trials of a shard.
struct TrialRange {
  std::uint64_t first = 0, last = 0;
};

/// How a run went.
struct RunOutcome {
  std::uint64_t trials = 0;           ///< of the shard
  std::uint64_t before = 0;           ///< of these, finished by earlier runs
  std::uint64_t finished = 0;         ///< of these, finished by now, earlier ones included
  std::uint64_t without_result = 0;   ///< of the finished, those that failed or timed out
  std::uint64_t to_retry = 0;         ///< those without a result that were to be run again
  std::uint64_t retried = 0;          ///< of these, those that were, whatever came out
  std::vector<TrialRange> missing;    ///< the first of them
  std::uint64_t further_missing = 0;  ///< number of ranges that missing has no room for
  std::vector<std::string> failures;  ///< why they are missing, each once
  bool disk_failed = false;           ///< the journal could not be written

  [[nodiscard]] bool complete() const { return finished == trials && retried == to_retry; }
};

/// Runs the trials of a shard that the journal of the directory does not have yet, and adds them to
/// it. The directory is made if there is none.
///
/// A trial that throws, takes too long, or takes two processes with it makes a row without a result,
/// and holds up nothing. (A process that dies once may have been killed by anyone: its trials are run
/// again, each alone.) What RunOptions::retry runs again takes the place of its row; no other changes.
/// @throws InvalidInput  if the directory can't be written, or belongs to another sweep
[[nodiscard]] RunOutcome run_shard(const Sweep& sweep, const Shard& shard,
                                   const std::filesystem::path& directory,
                                   const RunOptions& options);

}  // namespace hexagait::sweep

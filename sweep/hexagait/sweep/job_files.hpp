// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hexagait::sweep {

/// What runs the shards of a sweep on several machines.
enum class Scheduler {
  slurm,     ///< an array job, and a job that waits for it and merges
  parallel,  ///< GNU parallel
  mpi,       ///< mpirun starts the shards; the program itself needs no MPI
};

/// What job files are made of.
struct JobPlan {
  std::string program;  ///< absolute path of the command, unless $HEXAGAIT says otherwise
  std::string sweep;    ///< absolute path of the sweep file
  std::string folder;   ///< absolute path of the directory to which paths in it are relative
  std::uint64_t shards = 1;
  int jobs = 1;                ///< processes per shard
  double trial_timeout = 0.0;  ///< as that of RunOptions [s]
};

/// "slurm", "parallel" or "mpi". @throws InvalidInput
[[nodiscard]] Scheduler parse_scheduler(const std::string& text);

/// Makes a directory, and writes the scripts of a scheduler into it. They run every shard into a
/// directory of its own in it, then merge these into "merged" there.
/// @returns how to start them, a command
/// @throws InvalidInput  if they can't be written
std::string write_job_files(Scheduler scheduler, const JobPlan& plan,
                            const std::filesystem::path& directory);

}  // namespace hexagait::sweep

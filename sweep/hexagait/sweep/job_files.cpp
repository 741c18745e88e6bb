// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <hexagait/figures/staged_files.hpp>
#include <hexagait/sweep/detail/made_directory.hpp>
#include <hexagait/sweep/job_files.hpp>
#include <hexagait/text/invalid_input.hpp>

namespace hexagait::sweep {
namespace {

namespace fs = std::filesystem;

// A text as one word of a shell.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char letter : text)
    result += letter == '\'' ? std::string(R"('\'')") : std::string(1, letter);
  return result + "'";
}

// Opens every script, whose working directory is that of the results. HEXAGAIT names another
// program, HEXAGAIT_SWEEP a sweep file that was moved, HEXAGAIT_FOLDER where its robots are.
constexpr const char* kPreamble = R"(set -euo pipefail
hexagait=${{HEXAGAIT:-{program}}}
sweep=${{HEXAGAIT_SWEEP:-{sweep}}}
folder=${{HEXAGAIT_FOLDER:-{folder}}}
results=$PWD
shards={shards}
# shard K: runs the K-th of them, or what an earlier run of it left to do.
shard() {{
  (cd "$folder" && "$hexagait" sweep "$sweep" --shard "$1/$shards" --jobs {jobs} \
    --out "$results/shard-$1" --quiet --yes{timeout})
}}
merge() {{
  "$hexagait" merge $(seq -f 'shard-%.0f' "$shards") --out merged
}}
)";

std::string preamble(const JobPlan& plan) {
  return fmt::format(
      fmt::runtime(kPreamble), fmt::arg("program", quoted(plan.program)),
      fmt::arg("sweep", quoted(plan.sweep)), fmt::arg("folder", quoted(plan.folder)),
      fmt::arg("shards", plan.shards), fmt::arg("jobs", plan.jobs),
      fmt::arg("timeout", plan.trial_timeout > 0.0
                              ? fmt::format(" --trial-timeout {}", plan.trial_timeout)
                              : ""));
}

class Script {
 public:
  Script(figures::StagedFiles& files, const std::string& name)
      : path_(files.staging() / name), file_(files.create(name)) {}
  ~Script() = default;
  Script(const Script&) = delete;
  Script& operator=(const Script&) = delete;

  void finish(const std::string& text) {
    file_ << "#!/usr/bin/env bash\n" << text;
    file_.close();
    fs::permissions(path_, fs::perms::owner_all | fs::perms::group_read | fs::perms::group_exec |
                               fs::perms::others_read | fs::perms::others_exec);
  }

 private:
  fs::path path_;
  std::ofstream file_;
};

constexpr const char* kHere = "cd \"$(dirname \"${BASH_SOURCE[0]}\")\"\n";

void write_slurm(figures::StagedFiles& files, const JobPlan& plan) {
  Script(files, "shard.sbatch")
      .finish(fmt::format("#SBATCH --job-name=hexagait --array=1-{} --cpus-per-task={}\n"
                          "#SBATCH --output=shard-%a.log --open-mode=append --requeue\n",
                          plan.shards, plan.jobs) +
              preamble(plan) + "shard \"$SLURM_ARRAY_TASK_ID\"\n");
  Script(files, "merge.sbatch")
      .finish("#SBATCH --job-name=hexagait-merge --output=merge.log\n" + preamble(plan) +
              "merge\n");
  Script(files, "slurm.sh")
      .finish(
          "# Submits the shards, and the merge for when all of them are well. Options go to\n"
          "# sbatch. With --wait it ends when all is done.\nset -euo pipefail\n" +
          std::string(kHere) +
          "wait=()\n"
          "if [[ ${1:-} == --wait ]]; then wait=(--wait); shift; fi\n"
          "array=$(sbatch --parsable \"$@\" shard.sbatch)\n"
          "sbatch \"${wait[@]}\" \"$@\" --dependency=\"afterok:${array%%;*}\" "
          "--kill-on-invalid-dep=yes merge.sbatch\n");
}

void write_parallel(figures::StagedFiles& files, const JobPlan& plan) {
  Script(files, "parallel.sh")
      .finish(
          "# Runs the shards, as many at once as there are cores, or as the options say, which\n"
          "# go to GNU parallel: --jobs 4, or --sshlogin with a directory that all share.\n" +
          std::string(kHere) + preamble(plan) +
          "export -f shard\nexport hexagait sweep folder results shards\n"
          "seq \"$shards\" | parallel --will-cite --halt soon,fail=1 --joblog parallel.log "
          "--workdir \"$PWD\" --env shard --env hexagait --env sweep --env folder --env results "
          "--env shards \"$@\" shard\n"
          "merge\n");
}

void write_mpi(figures::StagedFiles& files, const JobPlan& plan) {
  Script(files, "rank.sh")
      .finish(
          "# One process of mpi.sh: its share of the shards. Knows Open MPI, MPICH and Slurm.\n" +
          std::string(kHere) + preamble(plan) +
          "rank=${OMPI_COMM_WORLD_RANK:-${PMI_RANK:-${SLURM_PROCID:?no rank: start mpi.sh}}}\n"
          "size=${OMPI_COMM_WORLD_SIZE:-${PMI_SIZE:-${SLURM_NTASKS:?no number of ranks}}}\n"
          "for ((k = rank + 1; k <= shards; k += size)); do shard \"$k\"; done\n");
  Script(files, "mpi.sh")
      .finish("# Runs the shards by mpirun, which gets the options: -np 16 --hostfile hosts.\n" +
              std::string(kHere) + preamble(plan) +
              "if (($# == 0)); then set -- -np \"$shards\"; fi\n"
              "\"${MPIRUN:-mpirun}\" \"$@\" \"$PWD/rank.sh\"\n"
              "merge\n");
}

}  // namespace

Scheduler parse_scheduler(const std::string& text) {
  if (text == "slurm") return Scheduler::slurm;
  if (text == "parallel") return Scheduler::parallel;
  if (text == "mpi") return Scheduler::mpi;
  throw InvalidInput(fmt::format("--emit is '{}'; it must be slurm, parallel or mpi", text));
}

std::string write_job_files(Scheduler scheduler, const JobPlan& plan, const fs::path& directory) {
  MadeDirectory made(directory);
  figures::StagedFiles files(directory);
  switch (scheduler) {
    case Scheduler::slurm:
      write_slurm(files, plan);
      break;
    case Scheduler::parallel:
      write_parallel(files, plan);
      break;
    case Scheduler::mpi:
      write_mpi(files, plan);
      break;
  }
  files.publish();
  made.keep();
  return (directory / files.names().back()).string();
}

}  // namespace hexagait::sweep

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <hexagait/figures/staged_files.hpp>
#include <hexagait/sweep/detail/made_directory.hpp>
#include <hexagait/sweep/job_files.hpp>
#include <hexagait/sweep/jobs/merge.sbatch.hpp>
#include <hexagait/sweep/jobs/mpi.sh.hpp>
#include <hexagait/sweep/jobs/parallel.sh.hpp>
#include <hexagait/sweep/jobs/preamble.sh.hpp>
#include <hexagait/sweep/jobs/rank.sh.hpp>
#include <hexagait/sweep/jobs/shard.sbatch.hpp>
#include <hexagait/sweep/jobs/slurm.sh.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <map>
#include <regex>

namespace hexagait::sweep {
namespace {

namespace fs = std::filesystem;

// The scripts of a scheduler, from jobs/; the last of them starts all.
struct Script {
  const char* name;
  std::string_view text;
};
std::vector<Script> scripts_of(Scheduler scheduler) {
  switch (scheduler) {
    case Scheduler::slurm:
      return {{"shard.sbatch", scripts::sweep::shard},
              {"merge.sbatch", scripts::sweep::merge},
              {"slurm.sh", scripts::sweep::slurm}};
    case Scheduler::parallel:
      return {{"parallel.sh", scripts::sweep::parallel}};
    case Scheduler::mpi:
      break;
  }
  return {{"rank.sh", scripts::sweep::rank}, {"mpi.sh", scripts::sweep::mpi}};
}

// A text as one word of a shell.
std::string in_quotes(const std::string& text) {
  std::string result = "'";
  for (const char letter : text)
    result += letter == '\'' ? std::string(R"('\'')") : std::string(1, letter);
  return result + "'";
}

// A script with values in the places of @names@; what was put in is not searched again.
std::string filled(std::string_view script, const std::map<std::string, std::string>& values) {
  static const std::regex name("@([a-z]+)@");
  using Matches = std::regex_iterator<std::string_view::iterator>;
  std::string text;
  auto from = script.begin();
  for (Matches match(script.begin(), script.end(), name), end; match != end; ++match) {
    text.append(from, (*match)[0].first).append(values.at((*match)[1]));
    from = (*match)[0].second;
  }
  return text.append(from, script.end());
}

std::map<std::string, std::string> values_of(const JobPlan& plan) {
  std::map<std::string, std::string> values = {
      {"program", in_quotes(plan.program)},
      {"sweep", in_quotes(plan.sweep)},
      {"folder", in_quotes(plan.folder)},
      {"shards", std::to_string(plan.shards)},
      {"jobs", std::to_string(plan.jobs)},
      {"timeout",
       plan.trial_timeout > 0.0 ? fmt::format(" --trial-timeout {}", plan.trial_timeout) : ""}};
  values["preamble"] = filled(scripts::sweep::preamble, values);
  return values;
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
  for (const Script& script : scripts_of(scheduler)) {
    files.write(script.name, filled(script.text, values_of(plan)));
    fs::permissions(files.staging() / script.name, fs::perms{0755});
  }
  files.publish();
  made.keep();
  return (directory / files.names().back()).string();
}

}  // namespace hexagait::sweep

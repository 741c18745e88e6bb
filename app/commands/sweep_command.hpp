// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/sweep/sweep.hpp>
#include <string>
#include <vector>

namespace hexagait::app {

/// `hexagait sweep` as it was typed. An empty text is an option that was not given.
struct SweepArguments {
  std::string file, out;
  std::string jobs, shard;
  std::string emit, shards;
  std::string trial_timeout;
  bool retry = false;  ///< what has no result
  bool yes = false;    ///< however long it takes
  bool json = false, quiet = false;
};

/// `hexagait sweep`: 0 if all trials of the sweep, or of its shard, are in. @throws InvalidInput
int sweep_command(const SweepArguments& arguments);

/// `hexagait merge` as it was typed.
struct MergeArguments {
  std::vector<std::string> parts;
  std::string out;
  bool json = false;
};

/// `hexagait merge`. @throws InvalidInput
int merge_command(const MergeArguments& arguments);

/// `hexagait report` as it was typed.
struct ReportArguments {
  std::string directory;
  std::vector<std::string> measures;  ///< none: what the sweep says
  std::string compare = "controllers", title;
  bool all_trials = false, json = false;
};

/// `hexagait report`. @throws InvalidInput
int report_command(const ReportArguments& arguments);

/// What --jobs says, or otherwise. @throws InvalidInput
[[nodiscard]] int jobs(const std::string& text, unsigned otherwise);

/// Of this machine.
[[nodiscard]] unsigned cores();

/// The part that --shard k/n asks for; all of it if the text is empty. @throws InvalidInput
[[nodiscard]] sweep::Shard shard(const std::string& text);

}  // namespace hexagait::app

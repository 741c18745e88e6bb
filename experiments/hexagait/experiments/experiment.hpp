// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <hexagait/experiments/json.hpp>
#include <hexagait/experiments/staged_files.hpp>
#include <string>
#include <vector>

namespace hexagait::experiments {

/// What an experiment is given.
struct ExperimentContext {
  const RobotModel* robot = nullptr;
  std::function<void(double share)> progress;  ///< called now and then with 0 … 1
  const std::atomic<bool>* stop = nullptr;     ///< once true, the experiment ends early
};

/// A figure or a claim of a paper, made again: runs, draws, and says whether the claim holds.
struct Experiment {
  std::string name;   ///< of the command, and of the files' stem
  std::string title;  ///< one line
  Outcome (*run)(const ExperimentContext& context, StagedFiles& files);
};

/// All of them, in the order of the paper.
[[nodiscard]] const std::vector<Experiment>& experiments();

/// Runs one into a directory of its name in `out`, which is made: figures, tables, manifest.json.
/// Nothing is written if it is stopped.
/// @throws InvalidInput  if the directory can't be made or written
[[nodiscard]] Manifest run(const Experiment& experiment, const ExperimentContext& context,
                           const std::filesystem::path& out);

Outcome table1(const ExperimentContext& context, StagedFiles& files);
Outcome table2(const ExperimentContext& context, StagedFiles& files);
Outcome fig3(const ExperimentContext& context, StagedFiles& files);
Outcome fig4(const ExperimentContext& context, StagedFiles& files);
Outcome fig6(const ExperimentContext& context, StagedFiles& files);
Outcome fig7a(const ExperimentContext& context, StagedFiles& files);
Outcome fig7b(const ExperimentContext& context, StagedFiles& files);
Outcome fig7_physics(const ExperimentContext& context, StagedFiles& files);
Outcome fig9(const ExperimentContext& context, StagedFiles& files);
Outcome fg16_fig6(const ExperimentContext& context, StagedFiles& files);
Outcome fg16_fig7(const ExperimentContext& context, StagedFiles& files);
Outcome fig10(const ExperimentContext& context, StagedFiles& files);
Outcome wave_family(const ExperimentContext& context, StagedFiles& files);
Outcome walks(const ExperimentContext& context, StagedFiles& files);

}  // namespace hexagait::experiments

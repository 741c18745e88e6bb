// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "options/action_input.hpp"
#include "options/arguments.hpp"
#include "options/plant_options.hpp"

/// The sub-commands: each prints its result on stdout and returns the exit status.
namespace hexagait::app {

inline constexpr int kOk = 0;
inline constexpr int kFailed = 1;  ///< the walk, the check or a claim failed
inline constexpr int kBadInput =
    2;  ///< bad usage or input, or a file or stdout that can't be written
inline constexpr int kInterrupted = 130;  ///< by Ctrl-C

/// `hexagait walk`. @throws InvalidInput
int walk_command(const WalkArguments& arguments);

/// `hexagait walk --teleop`: steered by the keys of the terminal. @throws InvalidInput
int teleop_command(const WalkArguments& arguments);

/// `hexagait check`: 0 if nothing is wrong. @throws InvalidInput
int check_command(const ActionArguments& arguments);

/// `hexagait run`: 0 if the action succeeded. @throws InvalidInput
int run_command(const ActionArguments& arguments);

/// `hexagait experiment` as it was typed.
struct ExperimentArguments {
  std::vector<std::string> names;  ///< or "all"; none: only the list
  std::string out = "results";
  std::string title = "auto";  ///< of the figures; or none
  std::string jobs;            ///< empty: one per core
  std::string robots;          ///< how many random ones; empty: as many as usual
  std::string seeds;           ///< of each point of rough; empty: as many as usual
  std::string shard;           ///< of rough: k/n; empty: all
  bool list = false, short_form = false, json = false, quiet = false;
  PlantArguments plant;
  std::string record, html;  ///< of the walk that it shows
};

/// `hexagait experiment`: 0 if each claim holds, or fails as it was declared to. @throws InvalidInput
int experiment_command(const ExperimentArguments& arguments);

/// `hexagait results` as it was typed.
struct ResultsArguments {
  std::string out = "docs/results.md";
  std::string figures = "results";
  std::vector<std::string> only;  ///< names of experiments, or "speed"; none: all
  bool short_form = false, quiet = false;
};

/// `hexagait results`: 0 if each claim holds, or fails as it was declared to. @throws InvalidInput
int results_command(const ResultsArguments& arguments);

/// `hexagait robot` as it was typed.
struct RobotArguments {
  std::string robot;
  RobotOverrides overrides;
  std::string plot;
  bool json = false;
};

/// `hexagait robot FILE`. @throws InvalidInput
int robot_command(const RobotArguments& arguments);

/// `hexagait verify`: 0 if all theorems hold.
int verify_command(bool as_json, bool quiet);

/// `hexagait list WHAT`. @throws InvalidInput  if there is no such list
int list_command(const std::string& what, bool json);

/// `hexagait terrains` as it was typed.
struct TerrainsArguments {
  std::vector<std::string> terrains;  ///< to draw; none: an example of each kind
  std::string plot;                   ///< file; empty: only the list
  std::string seed = "1";
};

/// `hexagait terrains`: the list, or a picture. @throws InvalidInput
int terrains_command(const TerrainsArguments& arguments);

}  // namespace hexagait::app

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <hexagait/recording/version.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <system_error>

#include "commands/commands.hpp"
#include "commands/sweep_command.hpp"
#include "options/action_options.hpp"
#include "options/replay_options.hpp"
#include "options/steer_options.hpp"
#include "options/usage.hpp"
#include "options/walk_options.hpp"
#include "terminal/output.hpp"

namespace hexagait::app {
namespace {

void add_experiment(CLI::App& app, ExperimentArguments& a) {
  CLI::App* experiment =
      app.add_subcommand("experiment", "Make a figure of a paper again, and test its claims");
  experiment->footer(
      "\nWithout a name it lists the experiments; all of them take about an hour and a half,\n"
      "with rough on 10 terrains a height; alone it has 200, and takes some hours.\n\n"
      "On another plant than the ideal one no claim is judged; what was measured is told.\n\n"
      "Examples:\n  hexagait experiment fig9 --out results\n  hexagait experiment all --short\n"
      "  hexagait experiment walks --plant real\n"
      "  hexagait experiment rough --seeds 20 --out results\n"
      "  hexagait experiment fig9 --html fig9.html       the walk as a page; see docs/replay.md\n\n"
      "Exit status: 0 every claim holds, or fails within the band that is declared for it; 1 one\n"
      "does not, or holds unexpectedly; 2 bad usage or input; 130 Ctrl-C. Several, or `all`, also\n"
      "write index.html, a page that shows them.");
  experiment->add_option("name", a.names, "Which: see hexagait list experiments")
      ->type_name("NAME|all");
  experiment->add_option("--out", a.out, "Directory; a directory per experiment is made in it")
      ->type_name("DIR")
      ->capture_default_str();
  experiment->add_option("--title", a.title, "none: figures without titles, for a paper")
      ->check(CLI::IsMember({"auto", "none"}))
      ->capture_default_str();
  experiment
      ->add_option("--jobs", a.jobs,
                   "Workers of rough, sensitivity, random_robots and gallery; default one per core")
      ->type_name("N");
  experiment->add_option("--robots", a.robots, "How many robots random_robots draws; default 200")
      ->type_name("N");
  experiment->add_option("--seeds", a.seeds, "How many terrains a height rough has; default 200")
      ->type_name("N");
  experiment
      ->add_option("--shard", a.shard,
                   "Walk only the k-th of n parts of rough; see docs/rough_terrain.md")
      ->type_name("k/n");
  experiment->add_flag("--list", a.list, "The same as hexagait list experiments");
  experiment->add_flag("--short", a.short_form,
                       "Some seconds each; claims that need the full length are not judged");
  experiment->add_flag("--json", a.json, "Print the verdicts as one JSON object");
  experiment->add_flag("--quiet", a.quiet, "No progress on stderr");
  add_replay_files(*experiment, a.record, a.html);
  add_plant(*experiment, a.plant);
}

void add_results(CLI::App& app, ResultsArguments& a) {
  CLI::App* results =
      app.add_subcommand("results", "Make the page of all figures and claims again");
  results->footer(
      "\nEach section is written when it is measured, and says when and with what; rough has 10\n"
      "terrains a height.\n\n"
      "Examples:\n  hexagait results\n  hexagait results --only speed\n\n"
      "Exit status: 0 every claim holds, or fails within the band that is declared for it; 1 one\n"
      "does not, or holds unexpectedly; 2 bad usage or input; 130 Ctrl-C.");
  results->add_option("--out", a.out, "The page")->type_name("FILE.md")->capture_default_str();
  results->add_option("--figures", a.figures, "Directory of the experiments' figures")
      ->type_name("DIR")
      ->capture_default_str();
  results
      ->add_option("--only", a.only,
                   "An experiment, or speed; the other sections of the page stay; may be repeated")
      ->type_name("GROUP");
  results->add_flag("--short", a.short_form, "Short forms of the experiments");
  results->add_flag("--quiet", a.quiet, "No progress on stderr");
}

void add_sweep(CLI::App& app, SweepArguments& a) {
  CLI::App* sweep = app.add_subcommand("sweep", "Run a grid of trials, on all cores");
  sweep->footer(
      "\nExamples:\n  hexagait sweep sweeps/speed_slice.yaml --out results/speed\n"
      "  hexagait sweep sweeps/speed_argos.yaml --shard 2/8 --out results/part2\n"
      "  hexagait sweep sweeps/speed_argos.yaml --emit slurm --shards 32 --out results/argos\n\n"
      "After Ctrl-C, or worse, the same command goes on where it was.\n"
      "A trial that crashes or takes too long makes a row without a result, and holds up nothing.\n"
      "Exit status: 0 all trials are in; 1 some are missing; 2 bad usage or input; 130 Ctrl-C.");
  sweep->add_option("file", a.file, "Sweep file: see docs/sweeps.md")
      ->type_name("FILE.yaml")
      ->required();
  sweep->add_option("--out", a.out, "Directory of the results")->type_name("DIR")->required();
  sweep->add_option("--jobs", a.jobs, "Worker processes; default one per core")->type_name("N");
  sweep->add_option("--shard", a.shard, "Run only the k-th of n parts")->type_name("k/n");
  sweep->add_option("--emit", a.emit, "Run nothing; write job files for several machines")
      ->type_name("slurm|parallel|mpi");
  sweep->add_option("--shards", a.shards, "Number of jobs, for --emit")->type_name("N");
  sweep
      ->add_option("--trial-timeout", a.trial_timeout,
                   "Give a trial up after so long; default a minute and 10 times what it simulates")
      ->type_name("SECONDS");
  sweep->add_flag(
      "--retry", a.retry,
      "Run trials without a result again, in place of their rows; no other row changes");
  sweep->add_flag("--yes", a.yes, "Go on even if it will take more than three days");
  sweep->add_flag("--json", a.json, "Print one JSON object");
  sweep->add_flag("--quiet", a.quiet, "No progress on stderr");
}

void add_merge(CLI::App& app, MergeArguments& a) {
  CLI::App* merge = app.add_subcommand("merge", "Put the shards of a sweep together");
  merge->footer("\nExample:\n  hexagait merge part1 part2 part3 --out whole");
  merge->add_option("parts", a.parts, "Directories of shards")->type_name("DIR")->required();
  merge->add_option("--out", a.out, "Directory of the result")->type_name("DIR")->required();
  merge->add_flag("--json", a.json, "Print one JSON object");
}

void add_report(CLI::App& app, ReportArguments& a) {
  CLI::App* report = app.add_subcommand("report", "Statistics and a figure of a finished sweep");
  report->footer(
      "\nExamples:\n  hexagait report results/speed --measure fraction_of_bound\n"
      "  hexagait report results/speed --measure fell --measure arrived --compare terrains\n\n"
      "--json prints one JSON object (a list of several measures), and draws nothing.");
  report->add_option("directory", a.directory, "Of the sweep's results")
      ->type_name("DIR")
      ->required();
  report->add_option("--measure", a.measures, "Columns of trials.csv; default what the sweep says")
      ->type_name("COLUMN")
      ->allow_extra_args(false);
  report->add_option("--compare", a.compare, "What is compared with the first of them")
      ->type_name("controllers|terrains|robots|plants")
      ->capture_default_str();
  report->add_flag("--all-trials", a.all_trials,
                   "Means also of trials that fell, got stuck or ended by a fault");
  report->add_option("--title", a.title, "Of the figure, or none")->type_name("TEXT|none");
  report->add_flag("--json", a.json, "Print one JSON object");
}

/// `hexagait list` and `hexagait verify` as they were typed.
struct ListArguments {
  std::string what;
  bool json = false;
};
struct VerifyArguments {
  bool json = false, quiet = false;
};

void add_robot(CLI::App& app, RobotArguments& a) {
  CLI::App* robot = app.add_subcommand("robot", "Show what is recognised of a robot");
  robot->add_option("robot", a.robot, "URDF file, or a name of hexagait list robots")
      ->type_name("FILE|NAME")
      ->required();
  robot->add_flag("--json", a.json, "Print one JSON object");
  robot->add_option("--plot", a.plot, "Draw it from above and from the side: .png, .svg or .pdf")
      ->type_name("FILE");
  group(*robot, "Robot and results");
  add_robot_overrides(*robot, a.overrides);
  robot->footer(
      "\nNames mean nothing: legs, feet and the front are found by geometry. What the file does "
      "not\n"
      "say, or what can't be so, is substituted, and listed below the table.\n\n"
      "Examples:\n  hexagait robot argos\n  hexagait robot mine.urdf --plot mine.png\n"
      "  hexagait robot mine.urdf --front +y --mass 2.4 --json\n\n"
      "Exit status: 0 it is a robot; 2 bad usage, or a file that is none.");
}

void add_list(CLI::App& app, ListArguments& a) {
  CLI::App* list = app.add_subcommand("list", "List what comes with hexagait, a line each");
  list->add_option("what", a.what, "What to list")
      ->type_name("robots|actions|paths|terrains|plants|faults|experiments")
      ->required();
  list->add_flag("--json", a.json, "Print one JSON array");
  list->footer(
      "\nRobots, actions and paths lie in ../share/hexagait beside the command, or where "
      "HEXAGAIT_DATA "
      "says.\n\nExamples:\n  hexagait list robots\n  hexagait list actions --json\n\n"
      "Exit status: 0 listed; 2 bad usage.");
}

void add_terrains(CLI::App& app, TerrainsArguments& a) {
  CLI::App* terrains =
      app.add_subcommand("terrains", "The same as hexagait list terrains; or a picture of some");
  terrains->add_option("terrain", a.terrains, "What --plot draws; default an example of each kind")
      ->type_name("T");
  terrains->add_option("--plot", a.plot, "Draw them: .png, .svg or .pdf")->type_name("FILE");
  terrains->add_option("--seed", a.seed, "Seed of what is drawn: 0, 1, 2, …")
      ->type_name("N")
      ->capture_default_str();
  terrains->footer(
      "\nExamples:\n  hexagait terrains\n  hexagait terrains --plot terrains.png\n"
      "  hexagait terrains slope:10deg+boxes:5cm --plot slope.png\n\n"
      "Exit status: 0 listed or drawn; 2 bad usage, or a file that can't be read or written.");
}

void add_verify(CLI::App& app, VerifyArguments& a) {
  CLI::App* verify = app.add_subcommand("verify", "Prove the gait theorems, case by case");
  verify->add_flag("--json", a.json, "Print one JSON object");
  verify->add_flag("--quiet", a.quiet, "No progress on stderr");
  verify->footer(
      "\nExamples:\n  hexagait verify\n  hexagait verify --json --quiet > theorems.json\n\n"
      "Exit status: 0 all theorems hold; 1 one does not; 2 bad usage.");
}

// What was typed after each command.
struct Arguments {
  WalkArguments walk;
  SteerArguments steer;
  ReplayArguments replay;
  ActionArguments run, check;
  ExperimentArguments experiment;
  ResultsArguments results;
  SweepArguments sweep;
  MergeArguments merge;
  ReportArguments report;
  RobotArguments robot;
  VerifyArguments verify;
  ListArguments list;
  TerrainsArguments terrains;
};

void add_commands(CLI::App& app, Arguments& a) {
  app.set_version_flag("--version", std::string("hexagait ") + recording::kVersion + " (" +
                                        recording::kRevision + ")");
  app.require_subcommand(1);
  app.footer("Each command has its own --help.");
  add_walk(app, a.walk);
  add_steer(app, a.steer);
  add_replay(app, a.replay);
  add_run(app, a.run);
  add_check(app, a.check);
  add_experiment(app, a.experiment);
  add_results(app, a.results);
  add_sweep(app, a.sweep);
  add_merge(app, a.merge);
  add_report(app, a.report);
  add_robot(app, a.robot);
  add_verify(app, a.verify);
  add_list(app, a.list);
  add_terrains(app, a.terrains);
  refuse_empty_values(app);
}

int run_command_of(const CLI::App& app, const Arguments& a) {
  if (app.got_subcommand("walk")) return walk_command(a.walk);
  if (app.got_subcommand("steer")) return steer_command(a.steer);
  if (app.got_subcommand("replay")) return replay_command(a.replay);
  if (app.got_subcommand("run")) return run_command(a.run);
  if (app.got_subcommand("check")) return check_command(a.check);
  if (app.got_subcommand("experiment")) return experiment_command(a.experiment);
  if (app.got_subcommand("results")) return results_command(a.results);
  if (app.got_subcommand("verify")) return verify_command(a.verify.json, a.verify.quiet);
  if (app.got_subcommand("sweep")) return sweep_command(a.sweep);
  if (app.got_subcommand("merge")) return merge_command(a.merge);
  if (app.got_subcommand("report")) return report_command(a.report);
  if (app.got_subcommand("robot")) return robot_command(a.robot);
  if (app.got_subcommand("terrains")) return terrains_command(a.terrains);
  return list_command(a.list.what, a.list.json);
}

int run(int argc, char** argv) {
  CLI::App app("Reactive free-gait walking for legged robots", "hexagait");
  Arguments arguments;
  add_commands(app, arguments);
  const std::span<const char* const> words(argv + 1, argv + std::max(argc, 1));
  check_words(app, words);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    return app.exit(asked);
  } catch (const CLI::ParseError& error) {
    const std::string command =
        words.empty() || words[0][0] == '-' ? "" : fmt::format(" {}", words[0]);
    fmt::print(stderr, "hexagait: {}; see hexagait{} --help\n", error.what(), command);
    return kBadInput;
  }
  return run_command_of(app, arguments);
}

// Says what went wrong. An output that can't be written is kBadInput: kFailed means that a walk failed.
int run_and_tell(int argc, char** argv) {
  std::string problem;
  try {
    return run(argc, argv);
  } catch (const InvalidInput& error) {
    problem = error.what();
  } catch (const std::ios_base::failure&) {
    problem = fmt::format("can't write a file: {}", std::strerror(errno));
  } catch (const std::system_error& error) {
    problem = error.what();
  } catch (const std::exception& error) {
    fmt::print(stderr, "hexagait: {}\n", error.what());
    return kFailed;
  }
  if (stdout_problem().empty()) fmt::print(stderr, "hexagait: {}\n", problem);
  return kBadInput;
}

}  // namespace
}  // namespace hexagait::app

int main(int argc, char** argv) {
  using namespace hexagait::app;
  reserve_standard_descriptors();
  const int status = run_and_tell(argc, argv);
  const std::string problem = stdout_problem();
  if (problem.empty()) return status;
  fmt::print(stderr, "hexagait: can't write to standard output: {}\n", problem);
  return kBadInput;
}

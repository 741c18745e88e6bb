// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <hexagait/recording/version.hpp>
#include <hexagait/text/invalid_input.hpp>

#include "action_options.hpp"
#include "commands.hpp"
#include "sweep_command.hpp"

namespace hexagait::app {
namespace {

constexpr const char* kWalkExamples = R"(
Examples:
  hexagait walk                                     straight on, 40 s, flat ground
  hexagait walk --radius 3 --terrain boxes:0.10     to the left over boxes of up to 10 cm
  hexagait walk --spin cw --seconds 10              on the spot, to the right
  hexagait walk --crab 45deg --distance 2 --json    diagonally, as one JSON object
  hexagait walk --duty-factor 0.75                  a tetrapod wave gait
  hexagait walk --robot genghis2d --terrain step:10cm --plot genghis.png
                                                    Genghis II from the side
  hexagait walk --random-commands 5 --plot walk.svg --trace walk.csv

Exit status: 0 walked to the end; 1 fell, stuck or fault; 2 bad usage or input; 130 Ctrl-C.)";

void add_walk(CLI::App& app, WalkArguments& a) {
  CLI::App* walk = app.add_subcommand("walk", "Walk in the simulator, and be judged by the truth");
  walk->footer(kWalkExamples);
  walk->add_option("--robot", a.robot, "URDF file, or the name of a known robot")
      ->type_name("FILE|NAME")
      ->capture_default_str();

  auto* radius = walk->add_option("--radius", a.radius, "Turning radius; > 0 left, inf straight")
                     ->type_name("M|inf");
  auto* crab = walk->add_option("--crab", a.crab, "Direction of motion in the body: 0.5 or 30deg")
                   ->type_name("ANGLE");
  auto* spin = walk->add_option("--spin", a.spin, "Turn in place")->type_name("ccw|cw");
  auto* commands =
      walk->add_option("--commands", a.commands, "Commands from a YAML file")->type_name("FILE");
  auto* random = walk->add_option("--random-commands", a.random_commands,
                                  "A random command every so many seconds")
                     ->type_name("S");
  auto* gait = walk->add_option("--gait", a.gait,
                                "free (default), unadjusted, literal, tripod (waits for all legs) "
                                "or wave:BETA")
                   ->type_name("G");
  walk->add_option("--duty-factor", a.duty_factor,
                   "Wave gait: share of the time that a leg stands, 0.5 (tripod) to < 1; the same "
                   "as --gait wave:BETA")
      ->type_name("BETA")
      ->excludes(gait);
  spin->excludes(radius)->excludes(crab);
  commands->excludes(radius)->excludes(crab)->excludes(spin);
  random->excludes(radius)->excludes(crab)->excludes(spin)->excludes(commands);

  walk->add_option("--terrain", a.terrain, "Ground: see hexagait terrains")
      ->type_name("T")
      ->capture_default_str();
  walk->add_option("--seed", a.seed, "Seed of terrain, posture and commands")
      ->type_name("N")
      ->capture_default_str();
  walk->add_option("--seconds", a.seconds, "Time to walk, at most")
      ->type_name("S")
      ->capture_default_str();
  walk->add_option("--distance", a.distance, "Path to walk, at most")->type_name("M");
  walk->add_option("--random-posture", a.random_posture, "Start with feet displaced by up to this")
      ->type_name("M");
  walk->add_flag("--no-contacts", a.no_contacts, "The controller has no contact sensors");
  walk->add_flag("--no-joint-feedback", a.no_joint_feedback, "The controller has no joint sensors");
  walk->add_option("--physics-step", a.physics_step, "Default 0.002")->type_name("S");
  walk->add_option("--control-period", a.control_period,
                   "A multiple of the physics step; default the first of 0.002 or more")
      ->type_name("S");
  walk->add_flag("--json", a.json, "Print one JSON object");
  walk->add_flag("--quiet", a.quiet, "No progress on stderr");
  walk->add_option("--plot", a.plot, "Draw the walk: .png, .svg or .pdf")->type_name("FILE");
  walk->add_option("--movie", a.movie, "Draw the last 8 s from the side and from above: .gif")
      ->type_name("FILE");
  walk->add_option("--trace", a.trace, "Write a row per control tick: .csv")->type_name("FILE");
}

void add_experiment(CLI::App& app, ExperimentArguments& a) {
  CLI::App* experiment =
      app.add_subcommand("experiment", "Make a figure of a paper again, and test its claims");
  experiment->footer(
      "\nExamples:\n  hexagait experiment --list\n  hexagait experiment fig9 --out results\n\n"
      "Exit status: 0 every claim holds, or fails within the band that is declared for it; 1 one\n"
      "does not, or holds unexpectedly; 2 bad usage or input; 130 Ctrl-C. `all` also writes "
      "index.html, a page that shows them.");
  experiment->add_option("name", a.name, "Which: see --list")
      ->type_name("NAME|all")
      ->capture_default_str();
  experiment->add_option("--out", a.out, "Directory; a directory per experiment is made in it")
      ->type_name("DIR")
      ->capture_default_str();
  experiment->add_option("--title", a.title, "none: figures without titles, for a paper")
      ->check(CLI::IsMember({"auto", "none"}))
      ->capture_default_str();
  experiment->add_flag("--list", a.list, "List the experiments");
  experiment->add_flag("--short", a.short_form,
                       "Some seconds each; claims that need the full length are not judged");
  experiment->add_flag("--json", a.json, "Print the verdicts as one JSON object");
  experiment->add_flag("--quiet", a.quiet, "No progress on stderr");
}

void add_results(CLI::App& app, ResultsArguments& a) {
  CLI::App* results =
      app.add_subcommand("results", "Make the page of all figures and claims again");
  results->footer(
      "\nExamples:\n  hexagait results\n  hexagait results --only speed --out speed.md\n\n"
      "Exit status: 0 every claim holds, or fails within the band that is declared for it; 1 one\n"
      "does not, or holds unexpectedly; 2 bad usage or input; 130 Ctrl-C.");
  results->add_option("--out", a.out, "The page")->type_name("FILE.md")->capture_default_str();
  results->add_option("--figures", a.figures, "Directory of the experiments' figures")
      ->type_name("DIR")
      ->capture_default_str();
  results->add_option("--only", a.only, "An experiment, or speed; may be given several times")
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
      ->type_name("controllers|terrains|robots")
      ->capture_default_str();
  report->add_flag("--all-trials", a.all_trials,
                   "Means also of trials that fell, got stuck or ended by a fault");
  report->add_option("--title", a.title, "Of the figure, or none")->type_name("TEXT|none");
  report->add_flag("--json", a.json, "Print one JSON object");
}

/// `hexagait robot` and `hexagait verify` as they were typed.
struct RobotArguments {
  std::string robot;
  bool json = false;
};
struct VerifyArguments {
  bool json = false, quiet = false;
};

void add_robot(CLI::App& app, RobotArguments& a) {
  CLI::App* robot = app.add_subcommand("robot", "Show what is recognised of a robot");
  robot->add_option("robot", a.robot, "URDF file, or the name of a known robot")
      ->type_name("FILE|NAME")
      ->required();
  robot->add_flag("--json", a.json, "Print one JSON object");
  robot->footer("\nExamples:\n  hexagait robot argos\n  hexagait robot mine.urdf --json");
}

void add_verify(CLI::App& app, VerifyArguments& a) {
  CLI::App* verify = app.add_subcommand("verify", "Prove the gait theorems, case by case");
  verify->add_flag("--json", a.json, "Print one JSON object");
  verify->add_flag("--quiet", a.quiet, "No progress on stderr");
  verify->footer(
      "\nExamples:\n  hexagait verify\n  hexagait verify --json --quiet > theorems.json\n\n"
      "Exit status: 0 all theorems hold; 1 one does not; 2 bad usage.");
}

int run(int argc, char** argv) {
  CLI::App app("Reactive free-gait walking for legged robots", "hexagait");
  app.set_version_flag("--version", std::string("hexagait ") + recording::kVersion + " (" +
                                        recording::kRevision + ")");
  app.require_subcommand(1);
  app.footer("Each command has its own --help.");

  WalkArguments walk;
  add_walk(app, walk);

  ActionArguments run, check;
  add_run(app, run);
  add_check(app, check);

  ExperimentArguments experiment;
  add_experiment(app, experiment);

  ResultsArguments results;
  add_results(app, results);

  SweepArguments sweep;
  MergeArguments merge;
  ReportArguments report;
  add_sweep(app, sweep);
  add_merge(app, merge);
  add_report(app, report);

  RobotArguments robot;
  VerifyArguments verify;
  add_robot(app, robot);
  add_verify(app, verify);

  CLI::App* terrains_app = app.add_subcommand("terrains", "List the terrains");
  terrains_app->footer("\nExample:\n  hexagait terrains");

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    return app.exit(asked);
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "hexagait: {}; see hexagait --help\n", error.what());
    return kBadInput;
  }
  if (app.got_subcommand("walk")) return walk_command(walk);
  if (app.got_subcommand("run")) return run_command(run);
  if (app.got_subcommand("check")) return check_command(check);
  if (app.got_subcommand("experiment")) return experiment_command(experiment);
  if (app.got_subcommand("results")) return results_command(results);
  if (app.got_subcommand("verify")) return verify_command(verify.json, verify.quiet);
  if (app.got_subcommand("sweep")) return sweep_command(sweep);
  if (app.got_subcommand("merge")) return merge_command(merge);
  if (app.got_subcommand("report")) return report_command(report);
  if (app.got_subcommand("robot")) return robot_command(robot.robot, robot.json);
  return terrains_command();
}

}  // namespace
}  // namespace hexagait::app

int main(int argc, char** argv) {
  try {
    return hexagait::app::run(argc, argv);
  } catch (const hexagait::InvalidInput& error) {
    fmt::print(stderr, "hexagait: {}\n", error.what());
    return hexagait::app::kBadInput;
  } catch (const std::exception& error) {
    fmt::print(stderr, "hexagait: {}\n", error.what());
    return hexagait::app::kFailed;
  }
}

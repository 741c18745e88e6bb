// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include "options/action_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "options/arguments.hpp"
#include "options/replay_options.hpp"
#include "options/usage.hpp"

namespace hexagait::app {
namespace {

constexpr const char* kRunExamples = R"(
Examples:
  hexagait run push_up --robot quadruped            the push-up of the Free Gait paper
  hexagait run tripod --set cycles=5                walk by a script
  hexagait run height --set height=0.36             a value for a placeholder
  hexagait run step_climb --terrain step:12cm --plot climb.png
  hexagait run recovery --start lying --seed 3      to its feet from its belly
  hexagait run look_around --controller virtual_model
  hexagait run mine.yaml --preview mine.svg         drawn, not simulated

Nothing moves unless the whole action is free of errors (see hexagait check). Ctrl-C stops the
action and brings the robot to a stance; a second one ends at once.
Exit status: 0 succeeded; 1 refused, failed or fell; 2 bad usage or input,
or a file or stdout that can't be written; 130 Ctrl-C.)";

constexpr const char* kCheckExamples = R"(
Examples:
  hexagait check push_up --robot quadruped
  hexagait check mine.yaml --robot mine.urdf --set side=R
  hexagait check recovery --start lying --json

Exit status: 0 no errors; 1 errors; 2 bad usage, or a file that can't be read as an action.)";

void add_common(CLI::App& command, ActionArguments& a) {
  command
      .add_option("action", a.action,
                  fmt::format("Action file, or one of: {}",
                              fmt::join(known_names("actions", ".yaml"), ", ")))
      ->type_name("FILE|NAME")
      ->required();
  command.add_option("--robot", a.robot, "URDF file, or a name of hexagait list robots")
      ->type_name("FILE|NAME")
      ->capture_default_str();
  command.add_option("--start", a.start, "How the robot is found: standing, sitting or lying")
      ->type_name("S")
      ->capture_default_str();
  command
      .add_option("--seed", a.seed, "Seed of terrain, plant, and of the legs that lie: 0, 1, 2, …")
      ->type_name("N")
      ->capture_default_str();
  command
      .add_option(
          "--set", a.set,
          "Value of a placeholder of the file, or of a parameter of the robot; may be repeated")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  command.add_option("--params", a.params, "Parameters of the robot, YAML: see docs/parameters.md")
      ->type_name("FILE");
  command.add_flag("--json", a.json, "Print one JSON object");
  group(command, "Action, robot and start");
}

}  // namespace

void add_run(CLI::App& app, ActionArguments& a) {
  CLI::App* run = app.add_subcommand("run", "Carry out an action in the simulator");
  run->footer(kRunExamples);
  add_common(*run, a);
  run->add_option("--terrain", a.terrain, "Ground: see hexagait list terrains")
      ->type_name("T")
      ->capture_default_str();
  run->add_option(
         "--controller", a.controller,
         "How the joints are driven: kinematic (by positions), or virtual_model (legs that "
         "stand by torques, as if springs held the body)")
      ->type_name("C")
      ->capture_default_str();
  CLI::Option* preview =
      run->add_option("--preview", a.preview_plot,
                      "Don't simulate: show what is planned, and draw it: .png, .svg or .pdf")
          ->type_name("[FILE]")
          ->expected(0, 1);
  run->add_option("--plot", a.plot, "Draw what happened: .png, .svg or .pdf")
      ->type_name("FILE")
      ->excludes(preview);
  add_replay_files(*run, a.record, a.html);
  for (const char* option : {"--record", "--html"}) run->get_option(option)->excludes(preview);
  run->add_flag("--force", a.force, "Run it although the check finds errors")->excludes(preview);
  run->add_flag("--quiet", a.quiet, "No progress and no warnings on stderr");
  group(*run, "Options of the run");
  add_plant(*run, a.plant);
  add_robot_overrides(*run, a.overrides);
  run->callback([&a, preview] { a.preview = preview->count() > 0; });
}

void add_check(CLI::App& app, ActionArguments& a) {
  CLI::App* check = app.add_subcommand("check", "Say what is wrong with an action, moving nothing");
  check->footer(kCheckExamples);
  add_common(*check, a);
  check->add_flag("--quiet", a.quiet, "Only what is wrong, no verdict");
  group(*check, "Options of the check");
  add_robot_overrides(*check, a.overrides);
}

}  // namespace hexagait::app

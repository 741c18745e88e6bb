// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include "options/walk_options.hpp"

#include "options/replay_options.hpp"
#include "options/usage.hpp"

namespace hexagait::app {
namespace {

constexpr const char* kWalkNotes = R"(
Angles are 45deg, 0.8rad or 0.8 (radians, at most 2π); lengths 0.05, 5cm or 50mm; times 2, 2s or 20ms.

Examples:
  hexagait walk                                     straight on, 40 s, flat ground
  hexagait walk --radius 3 --terrain boxes:10cm     to the left over boxes of up to 10 cm
  hexagait walk --spin cw --seconds 10              on the spot, to the right
  hexagait walk --crab 45deg --distance 2 --json    diagonally, as one JSON object
  hexagait walk --path figure_eight --facing keep   along a path, without turning
  hexagait walk --duty-factor 0.75                  a tetrapod wave gait
  hexagait walk --plant real --terrain boxes:10cm   with sensors, delays and masses as they are
  hexagait walk --joint-noise 2mrad --late-ticks 5% --servo position-only
  hexagait walk --robot genghis2d --terrain step:10cm --plot genghis.png
                                                    Genghis II from the side
  hexagait walk --random-commands 5 --plot walk.svg --trace walk.csv
  hexagait walk --terrain boxes:10cm --html walk.html
                                                    a page that plays it, from disk
  hexagait walk --teleop --terrain boxes:10cm       steered by keys, in real time: W S A D Q E X

With --teleop it walks without an end, or --seconds; the keys are shown, and are those of hexagait
steer (docs/steer.md). Esc is the emergency stop, ! releases it. There is no looking back, as a terminal
shows no picture: --record keeps the walk. Ctrl-C ends it with status 0, or 1 if the robot lies there.

Exit status: 0 walked to the end; 1 fell, stuck, fault, or did not arrive in time;
2 bad usage or input, or a file or stdout that can't be written; 130 Ctrl-C.)";

void add_commands(CLI::App& walk, WalkArguments& a) {
  auto* radius =
      walk.add_option("--radius", a.radius,
                      "Turning radius: > 0 to the left, < 0 to the right, inf straight; not 0")
          ->type_name("LENGTH|inf");
  auto* crab = walk.add_option("--crab", a.crab,
                               "Direction of motion in the body, 0 forward, 90deg to the left")
                   ->type_name("ANGLE");
  auto* spin = walk.add_option("--spin", a.spin, "Turn in place, to the left or to the right")
                   ->type_name("ccw|cw");
  auto* commands =
      walk.add_option("--commands", a.commands, "Commands and their times from a YAML file")
          ->type_name("FILE");
  auto* random = walk.add_option("--random-commands", a.random_commands,
                                 "A random command every so often, 1ms to 1 day")
                     ->type_name("TIME");
  auto* gait = walk.add_option("--gait", a.gait,
                               "free (default), unadjusted, literal, tripod (waits for all legs), "
                               "clocked (a tripod by the clock, that feels nothing) or wave:BETA")
                   ->type_name("G");
  walk.add_option("--duty-factor", a.duty_factor,
                  "Wave gait: share of the time that a leg stands, 0.5 (tripod) to < 1; the same "
                  "as --gait wave:BETA")
      ->type_name("BETA")
      ->excludes(gait);
  spin->excludes(radius)->excludes(crab);
  commands->excludes(radius)->excludes(crab)->excludes(spin);
  random->excludes(radius)->excludes(crab)->excludes(spin)->excludes(commands);
  auto* path =
      walk.add_option("--path", a.path,
                      "Follow a path: a YAML file of points, or a name of hexagait list paths")
          ->type_name("FILE|NAME");
  path->excludes(radius)->excludes(spin)->excludes(commands)->excludes(random);
}

void add_path(CLI::App& walk, WalkArguments& a) {
  walk.add_option("--facing", a.facing,
                  "along (default: along the path, or at --crab to it), keep (as at the start), an "
                  "angle, points (as the file says) or car (never sideways)")
      ->type_name("F");
  walk.add_option("--localise", a.localise,
                  "Where it takes its place from: odometry (default) or truth, given without error")
      ->type_name("odometry|truth");
  walk.add_option("--look-ahead", a.look_ahead,
                  "How far ahead on the path it makes for; default 1.25 strokes")
      ->type_name("LENGTH");
  walk.add_option("--laps", a.laps, "Of a closed path; default 1")->type_name("N");
}

void add_length_and_start(CLI::App& walk, WalkArguments& a) {
  walk.add_option("--seconds", a.seconds,
                  "Time to walk at most, 1ms to 1 day; default 40, with --path enough for it")
      ->type_name("TIME");
  auto* distance =
      walk.add_option("--distance", a.distance,
                      "Path to walk, 1mm to 100 km; exit status 1 if it does not arrive in time")
          ->type_name("LENGTH");
  distance->excludes(walk.get_option("--path"));
  walk.add_option("--random-posture", a.random_posture,
                  "Start with feet displaced by up to this; at most a workspace's radius")
      ->type_name("LENGTH");
  walk.add_option("--seed", a.seed, "Seed of terrain, posture, commands and plant: 0, 1, 2, …")
      ->type_name("N")
      ->capture_default_str();
}

void add_parameters(CLI::App& walk, WalkArguments& a) {
  walk.add_option(
          "--set", a.set,
          "A parameter of the robot, such as step.height=4cm; may be repeated; hexagait robot "
          "lists them")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  walk.add_option(
          "--params", a.params,
          "Parameters from a YAML file; ROBOT.params.yaml beside ROBOT.urdf is read without "
          "being asked for")
      ->type_name("FILE");
  walk.add_option("--speed", a.speed, "Bound of the speed along the path, at the farthest foot")
      ->type_name("SPEED");
}

void add_simulator(CLI::App& walk, WalkArguments& a) {
  walk.add_flag("--no-contacts", a.no_contacts, "The controller has no contact sensors");
  walk.add_flag("--no-joint-feedback", a.no_joint_feedback, "The controller has no joint sensors");
  walk.add_option("--physics-step", a.physics_step,
                  "10us to 20ms, of genghis2d to 5ms; default up to 2ms, of genghis2d 2.5ms, as "
                  "the control period divides")
      ->type_name("TIME");
  walk.add_option(
          "--control-period", a.control_period,
          "1ms to 20ms, a multiple of the physics step; default the first of 2ms or more, of "
          "genghis2d 5ms")
      ->type_name("TIME");
}

void add_output(CLI::App& walk, WalkArguments& a) {
  walk.add_flag("--json", a.json, "Print one JSON object");
  walk.add_flag("--quiet", a.quiet, "No progress on stderr");
  walk.add_option("--plot", a.plot, "Draw the walk: .png, .svg or .pdf")->type_name("FILE");
  walk.add_option("--movie", a.movie, "Draw the last 8 s from the side and from above: .gif")
      ->type_name("FILE");
  walk.add_option("--trace", a.trace, "Write a row per control tick: .csv")->type_name("FILE");
  add_replay_files(walk, a.record, a.html);
}

// What a walk that is steered by keys can't have: another source of headings, an end by distance, files
// that are made of a whole walk.
void add_teleop(CLI::App& walk, WalkArguments& a) {
  auto* teleop =
      walk.add_flag("--teleop", a.teleop, "Walk in real time, steered by the keys of the terminal");
  for (const char* const option :
       {"--commands", "--random-commands", "--path", "--facing", "--localise", "--look-ahead",
        "--laps", "--distance", "--random-posture", "--speed", "--plot", "--movie", "--trace"})
    teleop->excludes(walk.get_option(option));
}

}  // namespace

void add_walk(CLI::App& app, WalkArguments& a) {
  CLI::App* walk = app.add_subcommand("walk", "Walk in the simulator, and be judged by the truth");
  walk->footer(kWalkNotes);
  walk->add_option("--robot", a.robot, "URDF file, or a name of hexagait list robots")
      ->type_name("FILE|NAME")
      ->capture_default_str();
  walk->add_option("--terrain", a.terrain, "Ground: see hexagait list terrains")
      ->type_name("T")
      ->capture_default_str();
  group(*walk, "Robot and ground");
  add_commands(*walk, a);
  group(*walk, "Where to and how");
  add_path(*walk, a);
  group(*walk, "With --path");
  add_length_and_start(*walk, a);
  group(*walk, "How long, and from where");
  add_parameters(*walk, a);
  group(*walk, "Parameters of the robot");
  add_simulator(*walk, a);
  group(*walk, "Sensors and steps of time");
  add_plant(*walk, a.plant);
  add_output(*walk, a);
  group(*walk, "Results");
  add_teleop(*walk, a);
  group(*walk, "Steering by keys");
  add_robot_overrides(*walk, a.overrides);
}

}  // namespace hexagait::app

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include "options/steer_options.hpp"

#include "options/replay_options.hpp"
#include "options/usage.hpp"

namespace hexagait::app {
namespace {

constexpr const char* kSteerNotes = R"(
The page at the address that is printed shows the robot and steers it. Keys: W S ahead, backwards;
A D curve to the left, right; Q E crab to the left, right; X stop; Space pause; → one tick;
← look back, up to a minute; End back to the walk;
P push; R scramble the legs; Backspace begin again. T perform the action that is chosen, O one of
your own: a YAML file, which may be dropped on the page too. Esc is the emergency stop.

--live steers a live robot: PROGRAM drives it, and its standard input and output are a pipe (see
docs/porting.md). It stands until somebody steers; with --headless it walks at once. While somebody
watches the page there is a red button for the emergency stop: it needs no wheel, releasing it does.
It is software, and replaces no switch that cuts the power. Ctrl-C stops the robot and ends.

Only programs of this machine can open the page. --bind another address, and a token is needed that
is printed with the address of the page.

Examples:
  hexagait steer
  hexagait steer --robot mine.urdf --terrain steps:8cm --port 9000
  hexagait steer --speed 0.25                       in slow motion
  hexagait steer --headless --seconds 10            no page: walks in real time, and says how it was
  hexagait steer --robot mine.urdf --live './driver /dev/ttyUSB0'

Exit status: 0 ended by Ctrl-C, or after --seconds; 1 fell, with --headless, or a fault stopped the live
robot; 2 bad usage or input, the port is in use, or the live robot can't be started.)";

}  // namespace

void add_steer(CLI::App& app, SteerArguments& a) {
  CLI::App* steer = app.add_subcommand("steer", "Watch and steer a walk in the browser");
  steer->footer(kSteerNotes);
  a.walk.terrain = "boxes:10cm";
  a.walk.radius = "3";
  steer->add_option("--robot", a.walk.robot, "URDF file, or a name of hexagait list robots")
      ->type_name("FILE|NAME")
      ->capture_default_str();
  steer->add_option("--terrain", a.walk.terrain, "Ground: see hexagait list terrains")
      ->type_name("T")
      ->capture_default_str();
  steer->add_option("--seed", a.walk.seed, "Seed of terrain and plant: 0, 1, 2, …")
      ->type_name("N")
      ->capture_default_str();
  steer->add_option("--radius", a.walk.radius, "Turning radius until somebody steers")
      ->type_name("LENGTH|inf")
      ->capture_default_str();
  steer->add_option("--crab", a.walk.crab, "Direction of motion in the body until then")
      ->type_name("ANGLE");
  steer->add_option("--gait", a.walk.gait, "free (default), tripod or wave:BETA")->type_name("G");
  group(*steer, "Robot, ground and walk");
  add_page_address(*steer, a.address);
  steer->add_option("--speed", a.speed, "Simulated seconds per second, 0.05 to 10")
      ->type_name("X")
      ->capture_default_str();
  steer->add_flag("--headless", a.headless, "No page: only walk");
  steer->add_option("--seconds", a.walk.seconds, "End after so long; default: with Ctrl-C")
      ->type_name("TIME");
  CLI::Option* const live =
      steer
          ->add_option("--live", a.live,
                       "A live robot: the program that drives it, and its arguments")
          ->type_name("'PROGRAM ARGS'");
  steer
      ->add_option("--late-limit", a.late_limit,
                   "Stop the live robot after so long without a state of it")
      ->type_name("TIME")
      ->capture_default_str()
      ->needs(live);
  add_replay_files(*steer, a.walk.record, a.walk.html);
  steer->add_flag("--json", a.walk.json, "At the end, print one JSON object");
  steer->add_flag("--quiet", a.walk.quiet, "Say nothing but the address");
  group(*steer, "Page");
  add_robot_overrides(*steer, a.walk.overrides);
  add_plant(*steer, a.walk.plant);
  for (const char* const simulated : {"--terrain", "--seed", "--speed"})
    live->excludes(steer->get_option(simulated));
}

}  // namespace hexagait::app

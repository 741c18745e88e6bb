// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include "options/replay_options.hpp"

#include "options/usage.hpp"

namespace hexagait::app {
namespace {

constexpr const char* kReplayNotes = R"(
The page at the address that is printed plays the walk: Space plays and pauses, ← and → go a frame
back and on, Home and End to its ends; the slider goes anywhere, and the speed is chosen.

Examples:
  hexagait walk --terrain boxes:10cm --record walk.replay
  hexagait replay walk.replay
  hexagait replay walk.replay --html walk.html      one file that plays from disk, without a server
  hexagait replay walk.replay --json                what is in it

Exit status: 0 ended by Ctrl-C, or written; 2 bad usage, a file that is no replay, of another version
or cut off, or the port is in use.)";

}  // namespace

void add_replay(CLI::App& app, ReplayArguments& a) {
  CLI::App* replay = app.add_subcommand("replay", "Play a recorded walk in the browser");
  replay->footer(kReplayNotes);
  replay->add_option("file", a.file, "Of walk, run or steer --record")
      ->type_name("FILE")
      ->required();
  replay->add_option("--html", a.html, "Don't serve it: write one page that plays from disk, .html")
      ->type_name("FILE");
  add_page_address(*replay, a.address);
  replay->add_flag("--json", a.json, "Don't serve it: print what is in it as one JSON object");
  replay->add_flag("--quiet", a.quiet, "Say nothing but the address");
}

void add_replay_files(CLI::App& command, std::string& record, std::string& html) {
  command.add_option("--record", record, "Write a file for hexagait replay: .replay")
      ->type_name("FILE");
  command.add_option("--html", html, "Write a page that plays what happened, from disk: .html")
      ->type_name("FILE");
}

}  // namespace hexagait::app

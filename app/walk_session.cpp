// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include "walk_session.hpp"

#include <fmt/format.h>

#include <hexagait/text/invalid_input.hpp>
#include <hexagait/walk/path_file.hpp>
#include <limits>
#include <nlohmann/json.hpp>

#include "output.hpp"
#include "replay_files.hpp"

namespace hexagait::app {
namespace {

using viewer::SessionStatistics;

viewer::SessionOptions options(const char* command, const WalkArguments& arguments) {
  WalkArguments walk = arguments;
  if (walk.robot == kGenghis)
    throw InvalidInput(fmt::format("{}: --robot {} walks in a side view only; see hexagait walk",
                                   command, kGenghis));
  if (walk.seconds.empty()) walk.seconds = "1";  // it has no end; but the others want one
  viewer::SessionOptions result;
  result.robot = load_robot(walk.robot, walk.overrides, walk.quiet);
  result.simulation = simulation(walk, result.robot);
  result.heading = result.simulation.trial.schedule.front().heading;
  result.robots = known_names("robots", ".urdf");
  result.load = [](const std::string& name) {
    return viewer::LoadedRobot{load_robot(name, {}, true), given_params(name, "", {})};
  };
  result.paths = known_names("paths", ".yaml");
  result.load_path = [](const std::string& name, const RobotModel& robot, const StepParams& step) {
    return walk::load_path(shared_file("path", name, "paths", ".yaml"), robot, step);
  };
  return result;
}

std::string in_print(const SessionStatistics& s, bool json) {
  if (json)
    return nlohmann::ordered_json{
               {"schema", 1},        {"seconds", s.seconds},   {"ticks", s.ticks},
               {"frames", s.frames}, {"commands", s.commands}, {"worst_delay_ticks", s.worst_delay},
               {"path_m", s.path},   {"fell", s.fell},         {"processor_s", s.processor}}
               .dump(2) +
           "\n";
  return fmt::format("{} {:.1f} s and {:.2f} m; {} frames, {} commands\n",
                     s.fell ? "Fell after" : "Walked", s.seconds, s.path, s.frames, s.commands);
}

}  // namespace

SessionStatistics walk_in_session(const char* command, const WalkArguments& arguments,
                                  double speed_factor, const Attend& attend) {
  const double seconds = arguments.seconds.empty() ? std::numeric_limits<double>::infinity()
                                                   : time_limit(arguments.seconds);
  ReplayFiles files(arguments.record, arguments.html);
  files.stream().exceptions(std::ios::goodbit);  // written by the session's thread; finish() tells
  std::optional<viewer::ReplayWriter> replay;
  if (files.wanted()) replay.emplace(files.stream());

  viewer::SessionOptions begin = options(command, arguments);
  begin.speed_factor = speed_factor;
  begin.replay = replay ? &*replay : nullptr;
  const heading_control::Heading heading = begin.heading;
  SessionStatistics statistics;
  {
    viewer::Session session(std::move(begin));
    attend(session, heading, seconds);
    statistics = session.statistics();
  }
  if (arguments.json || !arguments.quiet) print_out(in_print(statistics, arguments.json));
  if (replay) replay->finish();
  files.finish();
  return statistics;
}

}  // namespace hexagait::app

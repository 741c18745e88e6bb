// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include "live/walk_session.hpp"

#include <fmt/format.h>

#include <hexagait/pipe/pipe_plant.hpp>
#include <hexagait/pipe/robot_process.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/text_file.hpp>
#include <hexagait/walk/paths/path_file.hpp>
#include <hexagait/yaml/yaml_tree.hpp>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>

#include "files/replay_files.hpp"
#include "terminal/output.hpp"

namespace hexagait::app {
namespace {

using viewer::SessionStatistics;

viewer::SessionOptions options(const char* command, const WalkArguments& arguments) {
  WalkArguments walk = arguments;
  if (walk.robot == kGenghis)
    throw InvalidInput(fmt::format("{}: --robot {} walks in a side view only; see hexagait walk",
                                   command, kGenghis));
  if (walk.seconds.empty()) walk.seconds = "1";  // a session has no end, but simulation() wants one
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
  result.actions = known_names("actions", ".yaml");
  result.load_action = [](const std::string& name) {
    return read_text(shared_file("action", name, "actions", ".yaml"), kMaxYamlText);
  };
  return result;
}

std::string in_print(const SessionStatistics& s, bool json) {
  if (json)
    return nlohmann::ordered_json{{"schema", 1},
                                  {"seconds", s.seconds},
                                  {"ticks", s.ticks},
                                  {"frames", s.frames},
                                  {"commands", s.commands},
                                  {"worst_delay_ticks", s.worst_delay},
                                  {"path_m", s.path},
                                  {"fell", s.fell},
                                  {"processor_s", s.processor},
                                  {"fault", to_string(s.fault)}}
               .dump(2) +
           "\n";
  return fmt::format("{} {:.1f} s and {:.2f} m; {} frames, {} commands\n",
                     s.fell ? "Fell after" : "Walked", s.seconds, s.path, s.frames, s.commands);
}

// A live robot: its program, and the plant at this end of its pipe.
class LiveRobot {
 public:
  LiveRobot(const std::string& line, const RobotModel& model, double control_dt) try
      : process_(command_words(line)), plant_(process_.pipe(), model, control_dt) {
  } catch (const InvalidInput& error) {
    throw InvalidInput(fmt::format("--live: {}", error.what()));
  }

  [[nodiscard]] PipePlant& plant() { return plant_; }

  // What became of its program, to be said after a problem.
  [[nodiscard]] std::string end() {
    const std::string end = process_.end(RobotProcess::kGrace);
    return end.empty() ? "" : "; its program " + end;
  }

 private:
  RobotProcess process_;
  PipePlant plant_;
};

SessionStatistics attend_to(viewer::SessionOptions options, LiveRobot* robot, const Attend& attend,
                            double seconds) {
  const heading_control::Heading heading = options.heading;
  std::unique_ptr<viewer::Session> session;
  try {
    session = std::make_unique<viewer::Session>(std::move(options));
  } catch (const InvalidInput& error) {
    if (robot == nullptr) throw;
    throw InvalidInput(fmt::format("--live: {}{}", error.what(), robot->end()));
  }
  attend(*session, heading, seconds);
  return session->statistics();
}

}  // namespace

bool has_failed(const SessionStatistics& statistics) {
  return statistics.fault != Fault::none && statistics.fault != Fault::emergency_stop;
}

SessionStatistics walk_in_session(const char* command, const WalkArguments& arguments,
                                  const SessionChoice& choice, const Attend& attend) {
  const double seconds = arguments.seconds.empty() ? std::numeric_limits<double>::infinity()
                                                   : time_limit(arguments.seconds);
  ReplayFiles files(arguments.record, arguments.html);
  files.stream().exceptions(std::ios::goodbit);  // written by the session's thread; finish() tells
  std::optional<viewer::ReplayWriter> replay;
  if (files.wanted()) replay.emplace(files.stream());

  viewer::SessionOptions begin = options(command, arguments);
  begin.speed_factor = choice.speed_factor;
  begin.simulation.late_limit = choice.late_limit;
  begin.replay = replay ? &*replay : nullptr;
  if (choice.stands) begin.heading = begin.heading.stopped();
  std::optional<LiveRobot> robot;
  if (!choice.live.empty()) {
    robot.emplace(choice.live, begin.robot, begin.simulation.control_dt);
    begin.live = &robot->plant();
  }
  const SessionStatistics statistics =
      attend_to(std::move(begin), robot ? &*robot : nullptr, attend, seconds);
  if (arguments.json || !arguments.quiet) print_out(in_print(statistics, arguments.json));
  if (robot && has_failed(statistics)) {
    const std::string problem = robot->plant().problem();
    fmt::print(
        stderr, "{}: the robot {}{}\n", command,
        problem.empty() ? fmt::format("was stopped: {}", to_string(statistics.fault)) : problem,
        problem.empty() ? "" : robot->end());
  }
  if (replay) replay->finish();
  files.finish();
  return statistics;
}

}  // namespace hexagait::app

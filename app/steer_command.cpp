// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/parse_number.hpp>
#include <hexagait/viewer/session.hpp>
#include <hexagait/walk/path_file.hpp>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "output.hpp"
#include "output_file.hpp"
#include "page_server.hpp"
#include "steer_options.hpp"

namespace hexagait::app {
namespace {

using viewer::Session;
using viewer::SessionStatistics;

double speed(const std::string& text) {
  const auto number = parse_number<double>(text);
  if (number && 0.05 <= *number && *number <= 10.0) return *number;
  throw InvalidInput(fmt::format("--speed is '{}'; it must be from 0.05 to 10", text));
}

viewer::SessionOptions options(const SteerArguments& arguments) {
  WalkArguments walk = arguments.walk;
  if (walk.robot == kGenghis)
    throw InvalidInput(
        fmt::format("--robot {} walks in a side view only; see hexagait walk", kGenghis));
  if (walk.seconds.empty()) walk.seconds = "1";  // it has no end; but the others want one
  viewer::SessionOptions result;
  result.robot = load_robot(walk.robot, walk.overrides, walk.quiet);
  result.simulation = simulation(walk, result.robot);
  result.heading = result.simulation.trial.schedule.front().heading;
  result.speed_factor = speed(arguments.speed);
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

// What --record writes; what can't be written shows in the file's state.
class Record {
 public:
  explicit Record(const std::string& name) : file_(output_file("--record", name, {".replay"})) {
    if (!file_) return;
    out_ = file_->files.open(file_->path.filename());
    out_.exceptions(std::ios::goodbit);
    writer_.emplace(out_);
  }
  [[nodiscard]] viewer::ReplayWriter* writer() { return writer_ ? &*writer_ : nullptr; }

  /// @throws InvalidInput  if it could not be written
  void finish() {
    if (!file_) return;
    writer_->finish();
    write_output("--record", *file_, [&] {
      out_.close();
      if (!out_) refuse_output("--record", *file_, "write error");
      file_->files.publish();
    });
  }

 private:
  std::optional<OutputFile> file_;
  std::ofstream out_;
  std::optional<viewer::ReplayWriter> writer_;
};

SessionStatistics steer(const SteerArguments& arguments, viewer::ReplayWriter* replay,
                        double seconds) {
  viewer::SessionOptions begin = options(arguments);
  begin.replay = replay;
  Session session(std::move(begin));
  if (arguments.headless)
    wait_for_end(seconds);
  else
    serve_page("steer", arguments.address, arguments.walk.quiet, session, seconds);
  return session.statistics();
}

}  // namespace

int steer_command(const SteerArguments& arguments) {
  const double seconds = arguments.walk.seconds.empty() ? std::numeric_limits<double>::infinity()
                                                        : time_limit(arguments.walk.seconds);
  Record record(arguments.walk.record);
  const SessionStatistics statistics = steer(arguments, record.writer(), seconds);
  if (arguments.walk.json || !arguments.walk.quiet)
    print_out(in_print(statistics, arguments.walk.json));
  record.finish();
  return arguments.headless && statistics.fell ? kFailed : kOk;
}

}  // namespace hexagait::app

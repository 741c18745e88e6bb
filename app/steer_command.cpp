// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/parse_number.hpp>
#include <hexagait/viewer/page_files.hpp>
#include <hexagait/viewer/server.hpp>
#include <nlohmann/json.hpp>
#include <thread>

#include "commands.hpp"
#include "interrupt.hpp"
#include "output.hpp"
#include "steer_options.hpp"

namespace hexagait::app {
namespace {

using viewer::Session;
using viewer::SessionStatistics;

int port(const std::string& text) {
  const auto number = parse_number<int>(text);
  if (number && 0 <= *number && *number <= 65535) return *number;
  throw InvalidInput(fmt::format(
      "--port is '{}'; it must be a whole number from 0 (any that is free) to 65535", text));
}

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
  return result;
}

// Raises `end` with Ctrl-C, or when the time is over.
class End {
 public:
  explicit End(double seconds)
      : thread_([this, seconds, &interrupted = watch_interrupts()] {
          const auto begin = viewer::Clock::now();
          const std::chrono::duration<double> length(seconds);
          while (!ended_ && !interrupted && viewer::Clock::now() - begin < length)
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
          ended_ = true;
        }) {}
  ~End() {
    ended_ = true;
    thread_.join();
  }
  End(const End&) = delete;
  End& operator=(const End&) = delete;

  [[nodiscard]] const std::atomic<bool>& ended() const { return ended_; }

 private:
  std::atomic<bool> ended_ = false;
  std::thread thread_;
};

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

int serve(const SteerArguments& arguments, Session& session, double seconds) {
  if (viewer::page_files().empty()) throw InvalidInput(fmt::format("steer: {}", viewer::kNoPage));
  const std::string bind = arguments.bind == "localhost" ? "127.0.0.1" : arguments.bind;
  viewer::Access access{.bind = bind, .port = port(arguments.port), .token = {}};
  if (!access.is_loopback()) access.token = viewer::make_token();
  viewer::Server server(std::move(access), session);
  print_out(fmt::format("{}\n", server.url()));
  if (!arguments.walk.quiet) fmt::print(stderr, "Open this address in a browser; Ctrl-C ends.\n");
  const End end(seconds);
  server.run(end.ended());
  return kOk;
}

void wait(double seconds) {
  const End end(seconds);
  while (!end.ended()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
}

}  // namespace

int steer_command(const SteerArguments& arguments) {
  const double seconds = arguments.walk.seconds.empty() ? std::numeric_limits<double>::infinity()
                                                        : time_limit(arguments.walk.seconds);
  Session session(options(arguments));
  if (arguments.headless)
    wait(seconds);
  else
    serve(arguments, session, seconds);
  const SessionStatistics statistics = session.statistics();
  if (arguments.walk.json || !arguments.walk.quiet)
    print_out(in_print(statistics, arguments.walk.json));
  return arguments.headless && statistics.fell ? kFailed : kOk;
}

}  // namespace hexagait::app

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include "options/arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <hexagait/load/load_params.hpp>
#include <hexagait/params/best_stance.hpp>
#include <hexagait/params/set_parameter.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/nearest_word.hpp>
#include <hexagait/text/parse_number.hpp>
#include <hexagait/text/quantity.hpp>
#include <hexagait/walk/paths/path_file.hpp>

namespace hexagait::app {
namespace {

using heading_control::Heading;
using heading_control::Turn;

struct Range {
  double least, greatest;
  Dimension dimension;
  const char* words;
};
constexpr Range kSeconds = {1e-3, 86400.0, Dimension::time, "a time of 1ms to a day, in seconds"};
constexpr Range kSpeed = {1e-6, 1e3, Dimension::number, "a speed of 1e-6 to 1000 m/s"};
constexpr Range kDistance = {1e-3, 1e5, Dimension::length, "a length of 1mm to 100 km, in metres"};
constexpr Range kPeriod = {1e-3, 86400.0, Dimension::time,
                           "a time of 1ms to a day between commands, in seconds"};
constexpr Range kLookAhead = {1e-3, 1e3, Dimension::length, "a length of 1mm to 1 km, in metres"};
constexpr Range kStep = {1e-5, 0.02, Dimension::time, "a time of 10us to 20ms, in seconds"};
constexpr Range kControlPeriod = {1e-3, 0.02, Dimension::time, "a time of 1ms to 20ms, in seconds"};

double number(const char* option, const std::string& text, const Range& range) {
  const auto [value, problem] = parse_quantity(text, range.dimension);
  if (problem.empty() && range.least <= value && value <= range.greatest) return value;
  throw InvalidInput(fmt::format("{} is '{}'; it must be {}{}", option, text, range.words,
                                 range.dimension == Dimension::time
                                     ? ", or with a unit: s, ms, us or min"
                                     : ", or with a unit: m, cm or mm"));
}

// Puts the name of the option before what its parser says.
template <class Parser>
auto option_value(const char* option, const std::string& text, const Parser& parse) {
  try {
    return parse(text);
  } catch (const InvalidInput& error) {
    throw InvalidInput(fmt::format("{}: {}", option, error.what()));
  }
}

Heading heading(const WalkArguments& arguments) {
  if (arguments.spin == "ccw") return Heading::spin(Turn::ccw);
  if (arguments.spin == "cw") return Heading::spin(Turn::cw);
  if (!arguments.spin.empty())
    throw InvalidInput(fmt::format(
        "--spin is '{}'; it must be ccw (to the left) or cw (to the right)", arguments.spin));

  const double alpha =
      arguments.crab.empty() ? 0.0 : option_value("--crab", arguments.crab, walk::parse_angle);
  if (arguments.radius.empty()) return Heading::straight(alpha);
  return Heading::arc(option_value("--radius", arguments.radius, walk::parse_radius), alpha);
}

gait_state::GaitChoice gait(const WalkArguments& arguments) {
  if (!arguments.duty_factor.empty()) {
    const auto choice = gait_state::parse_gait_choice("wave:" + arguments.duty_factor);
    if (choice) return *choice;
    throw InvalidInput(
        fmt::format("--duty-factor is '{}'; it must be at least 0.5 (tripod) and less than 1, such "
                    "as 0.75 (tetrapod)",
                    arguments.duty_factor));
  }
  if (arguments.gait.empty()) return {};
  const auto choice = gait_state::parse_gait_choice(arguments.gait);
  if (choice) return *choice;
  const std::vector<std::string> known = {"free", "unadjusted", "literal", "tripod", "clocked"};
  throw InvalidInput(
      fmt::format("--gait is '{}'{}; it must be {}, BETA at least 0.5 and less than 1",
                  arguments.gait, did_you_mean(arguments.gait, known), gait_state::kGaitChoices));
}

walk::Schedule schedule(const WalkArguments& arguments, const RobotModel& robot, std::uint64_t seed,
                        double seconds) {
  if (!arguments.commands.empty()) return walk::load_schedule(arguments.commands);
  if (arguments.random_commands.empty()) return {{0.0, heading(arguments)}};
  const double period = number("--random-commands", arguments.random_commands, kPeriod);
  return walk::random_schedule(seed, period, seconds, walk::tightest_radius(robot));
}

walk::LocalisedBy localisation(const std::string& text) {
  const std::vector<std::string> known = {"odometry", "truth"};
  if (text.empty() || text == known[0]) return walk::LocalisedBy::odometry;
  if (text == known[1]) return walk::LocalisedBy::truth;
  throw InvalidInput(fmt::format(
      "--localise is '{}'{}; it must be odometry, its own, or truth, as if it were given", text,
      did_you_mean(text, known)));
}

int laps(const std::string& text, const path_following::Path& path) {
  constexpr int kMost = 1000;
  const auto count = parse_number<int>(text);
  if (!count || *count < 1 || *count > kMost)
    throw InvalidInput(
        fmt::format("--laps is '{}'; it must be a whole number from 1 to {}", text, kMost));
  if (!path.closed() && *count > 1)
    throw InvalidInput(fmt::format("--laps is '{}', but the path is not closed: it has one", text));
  return *count;
}

// The facing of the path's file, unless --facing or --crab changes it.
path_following::FacingRule facing(const WalkArguments& a, const path_following::PathTask& task) {
  path_following::FacingRule rule = task.facing;
  if (!a.facing.empty()) rule = option_value("--facing", a.facing, walk::parse_facing);
  if (rule.kind == path_following::Facing::points && !task.path.has_facing())
    throw InvalidInput(fmt::format(
        "{}: no point says where to face; write one as {{x: 1, y: 0, facing: 90deg}}", a.path));
  if (a.crab.empty()) return rule;
  if (rule.kind != path_following::Facing::along)
    throw InvalidInput(fmt::format(
        "--crab makes no sense where the path's facing is {}; with --facing along the body "
        "goes along the path at this angle",
        walk::to_string(rule)));
  rule.angle = -option_value("--crab", a.crab, walk::parse_angle);
  return rule;
}

std::optional<path_following::PathTask> path_task(const WalkArguments& a, const RobotModel& robot,
                                                  const RobotParams& params) {
  if (a.path.empty()) {
    const auto refuse = [](const std::string& given, const char* option) {
      if (!given.empty())
        throw InvalidInput(fmt::format("{} makes no sense without --path", option));
    };
    refuse(a.facing, "--facing");
    refuse(a.localise, "--localise");
    refuse(a.look_ahead, "--look-ahead");
    refuse(a.laps, "--laps");
    return {};
  }
  const std::string file = shared_file("--path: path", a.path, "paths", ".yaml");
  path_following::PathTask task = walk::load_path(file, robot, params.step);
  task.facing = facing(a, task);
  if (!a.look_ahead.empty()) task.look_ahead = number("--look-ahead", a.look_ahead, kLookAhead);
  if (!a.laps.empty()) task.laps = laps(a.laps, task.path);
  return task;
}

// A time limit that only a walk that makes no progress reaches.
double time_for(const path_following::PathTask& task, const RobotModel& robot, double speed) {
  constexpr double kLongest = 5.0, kLeast = 40.0;
  const double usual = std::min(speed, usual_speed(scale_of(robot)));
  double time = task.path.at(0.0).norm() / usual;
  for (std::size_t k = 0; k < task.path.pieces().size(); ++k) {
    const path_following::Path::Piece& piece = task.path.pieces()[k];
    time += task.laps * (task.path.end_of(k) - piece.s) / std::min(usual, piece.speed);
  }
  return std::clamp(kLongest * time, kLeast, kSeconds.greatest);
}

double posture_spread(const std::string& text, const RobotModel& robot) {
  double radius = robot.legs[0].workspace_radius;
  for (const LegModel& leg : robot.legs) radius = std::min(radius, leg.workspace_radius);
  const std::string words =
      fmt::format("a length from 0 to {:.3g} m, the radius of the robot's workspaces", radius);
  return number("--random-posture", text, {0.0, radius, Dimension::length, words.c_str()});
}

// Default: the longest step of at most `usual` of which the control period is a multiple.
double physics_step(const WalkArguments& a, const Range& range, double usual) {
  if (!a.physics_step.empty()) return number("--physics-step", a.physics_step, range);
  if (a.control_period.empty()) return usual;
  return sim3d::physics_step_for(number("--control-period", a.control_period, kControlPeriod),
                                 usual);
}

// Default: the smallest number of physics steps that makes so much or more.
double control_period(const WalkArguments& a, double physics_dt, double usual) {
  if (a.control_period.empty()) return physics_dt * std::ceil(usual / physics_dt - 1e-9);
  const double period = number("--control-period", a.control_period, kControlPeriod);
  const double steps = std::round(period / physics_dt);
  if (steps < 1.0 || std::abs(period - steps * physics_dt) > 1e-9 * period)
    throw InvalidInput(
        fmt::format("--control-period is {} s; it must be a whole number of physics steps of {} s, "
                    "such as {} s",
                    period, physics_dt, std::max(1.0, steps) * physics_dt));
  return period;
}

// A side view knows neither curves nor turns, and its walker needs its sensors.
void refuse_in_side_view(const WalkArguments& a) {
  const auto refuse = [](bool given, const char* option, const char* why) {
    if (given)
      throw InvalidInput(
          fmt::format("{} makes no sense with --robot {}: {}", option, kGenghis, why));
  };
  constexpr const char* kStraight = "a side view only walks straight on";
  refuse(!a.radius.empty(), "--radius", kStraight);
  refuse(!a.spin.empty(), "--spin", kStraight);
  refuse(!a.commands.empty(), "--commands", kStraight);
  refuse(!a.random_commands.empty(), "--random-commands", kStraight);
  refuse(!a.path.empty(), "--path", kStraight);
  refuse(!a.record.empty() || !a.html.empty(), "--record or --html",
         "the page is of three dimensions");
  refuse(!a.set.empty() || !a.params.empty(), "--set or --params", "its parameters are its own");
  refuse(!a.speed.empty(), "--speed", "its speed is its own");
  refuse(a.plant.given(), "--plant, or an option of it,", "its plant is ideal");
  refuse(a.no_contacts, "--no-contacts", "it feels the ground by its motors");
  refuse(a.no_joint_feedback, "--no-joint-feedback", "it feels the ground by its motors");
}

bool walks_backward(const std::string& crab) {
  if (crab.empty()) return false;
  const double angle = option_value("--crab", crab, walk::parse_angle);
  const bool forward = std::abs(wrap_angle(angle)) < 1e-9;
  const bool backward = std::abs(wrap_angle(angle - std::numbers::pi)) < 1e-9;
  if (forward || backward) return backward;
  throw InvalidInput(fmt::format("--crab is '{}'; in a side view it must be 0 or 180deg", crab));
}

}  // namespace

// Those in robots/ have 0.26 to 0.34 ℓ/T, those of four legs, which crawl, 0.06 to 0.07 ℓ/T.
double usual_speed(const RobotScale& scale) {
  return (scale.legs == 4 ? 0.065 : 0.3) * scale.reach / scale.time;
}

double time_limit(const std::string& text) { return number("--seconds", text, kSeconds); }

double late_limit(const std::string& text) {
  constexpr Range kLateLimit = {0.01, 10.0, Dimension::time, "a time of 10ms to 10s, in seconds"};
  return number("--late-limit", text, kLateLimit);
}

std::uint64_t seed(const std::string& text) {
  if (const auto value = parse_number<std::uint64_t>(text)) return *value;
  throw InvalidInput(fmt::format("--seed is '{}'; it must be a whole number of 0 or more", text));
}

sim2d::GenghisTrial genghis_trial(const WalkArguments& arguments) {
  refuse_in_side_view(arguments);
  sim2d::GenghisTrial trial;
  trial.terrain = sim2d::parse_terrain2d(arguments.terrain);
  trial.gait = gait(arguments);
  if (trial.gait.open_loop)
    throw InvalidInput(
        fmt::format("--gait clocked walks in three dimensions only, not {}", kGenghis));
  trial.seed = seed(arguments.seed);
  trial.backward = walks_backward(arguments.crab);
  if (!arguments.seconds.empty()) trial.seconds = time_limit(arguments.seconds);
  if (!arguments.distance.empty())
    trial.distance = number("--distance", arguments.distance, kDistance);
  if (!arguments.random_posture.empty()) {
    constexpr Range kSpread = {0.0, 0.05, Dimension::length,
                               "a length from 0 to 0.05 m, half the robot's stride"};
    trial.random_posture = number("--random-posture", arguments.random_posture, kSpread);
  }
  constexpr Range kStep2d = {1e-5, 0.005, Dimension::time, "a time of 10us to 5ms, in seconds"};
  trial.physics_dt = physics_step(arguments, kStep2d, trial.physics_dt);
  trial.control_dt = control_period(arguments, trial.physics_dt, trial.control_dt);
  return trial;
}

RobotParams given_params(const std::string& robot, const std::string& params,
                         const std::vector<std::string>& set) {
  RobotParams given;
  const std::string beside = params_beside(robot_file(robot));
  if (!beside.empty()) load_params(given, beside);
  if (!params.empty()) load_params(given, params);
  for (const std::string& text : set) {
    try {
      set_parameter(given, text);
    } catch (const InvalidInput& error) {
      throw InvalidInput(fmt::format("--set: {}", error.what()));
    }
  }
  return given;
}

recording::Simulation simulation(const WalkArguments& arguments, const RobotModel& robot) {
  recording::Simulation result;
  result.terrain = sim3d::parse_terrain(arguments.terrain);
  result.seed = seed(arguments.seed);
  const std::string problem = why_it_cannot_walk(robot);
  if (!problem.empty()) throw InvalidInput(fmt::format("{} cannot walk: {}", robot.name, problem));
  result.params = completed(given_params(arguments.robot, arguments.params, arguments.set), robot);
  const double longest = result.params.plant.longest_step, usual = result.control_dt;
  result.physics_dt = physics_step(arguments, kStep, sim3d::physics_step_for(usual, longest));
  result.control_dt = control_period(arguments, result.physics_dt, usual);
  result.sensors = {.joint_feedback = !arguments.no_joint_feedback,
                    .foot_contacts = !arguments.no_contacts};
  result.plant = plant(arguments.plant);
  result.plant.parts = resolved(std::move(result.plant.parts), robot);
  result.gait = gait(arguments);
  if (!arguments.speed.empty()) result.trial.speed = number("--speed", arguments.speed, kSpeed);
  if (!arguments.random_posture.empty())
    result.random_posture = posture_spread(arguments.random_posture, robot);

  result.trial.path = path_task(arguments, robot, result.params);
  result.trial.localised_by = localisation(arguments.localise);
  if (result.trial.path)
    result.trial.seconds = time_for(*result.trial.path, robot, result.trial.speed);
  if (!arguments.seconds.empty()) result.trial.seconds = time_limit(arguments.seconds);
  if (!arguments.distance.empty())
    result.trial.distance = number("--distance", arguments.distance, kDistance);
  result.trial.schedule = result.trial.path
                              ? walk::Schedule{{0.0, Heading::stop()}}
                              : schedule(arguments, robot, result.seed, result.trial.seconds);
  complete(result, robot);
  return result;
}

}  // namespace hexagait::app

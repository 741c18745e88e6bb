// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// The walks by which we judge the controller: ten headings on flat ground, twenty random starting
// postures, headings that change every second, and random terrain. A table with a row per walk.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <hexagait/experiments/on_workers.hpp>
#include <hexagait/experiments/walk_checks.hpp>
#include <hexagait/experiments/walks.hpp>
#include <thread>

namespace hexagait::experiments {
namespace {

using heading_control::Heading;
using heading_control::Turn;

using Walk = JudgedWalk;

recording::Simulation flat(const Heading& heading, double seconds) {
  recording::Simulation simulation;
  simulation.trial.schedule = {{0.0, heading}};
  simulation.trial.seconds = seconds;
  return simulation;
}

// A walk for each seed, from 1 on.
template <class Of>
std::vector<Walk> seeds(const std::string& group, std::uint64_t count, Of of) {
  std::vector<Walk> walks;
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    walks.push_back({group, fmt::format("seed {}", seed), of(seed)});
    walks.back().simulation.seed = seed;
  }
  return walks;
}

std::vector<Walk> postures(std::uint64_t count) {
  return seeds("posture", count, [](std::uint64_t) {
    recording::Simulation simulation = flat(Heading::straight(0.0), 20.0);
    simulation.random_posture = 0.10;
    return simulation;
  });
}

std::vector<Walk> random_commands(const RobotModel& robot, std::uint64_t count, double seconds) {
  const double radius = walk::tightest_radius(robot);
  return seeds("commands", count, [=](std::uint64_t seed) {
    recording::Simulation simulation = flat(Heading::stop(), seconds);
    simulation.trial.schedule = walk::random_schedule(seed, 1.0, seconds, radius);
    return simulation;
  });
}

// Straight on at full speed, then a command that leaves the straight line at once, given at 24 instants,
// 0.07 s apart.
std::vector<Walk> sharp_changes(bool brief) {
  constexpr double kBefore = 5.0, kApart = 0.07, kAfter = 4.0;  // [s]
  struct Command {
    const char* name;
    Heading heading;
  };
  const Command commands[] = {{"crab 90°", Heading::straight(std::numbers::pi / 2.0)},
                              {"crab 45°", Heading::straight(std::numbers::pi / 4.0)},
                              {"spin", Heading::spin(Turn::ccw)},
                              {"r = 0.3 m", Heading::arc(0.3, 0.0)}};
  std::vector<Walk> walks;
  for (const auto& [name, heading] : commands)
    for (int k = 0; k < (brief ? 1 : 24); ++k) {
      const double at = kBefore + kApart * k;
      walks.push_back({"sharp change", fmt::format("{} after {:.2f} s", name, at),
                       flat(Heading::straight(0.0), at + kAfter)});
      walks.back().simulation.trial.schedule.push_back({at, heading});
    }
  return walks;
}

// What ./run walks, with other seeds.
std::vector<Walk> first_walks(std::uint64_t count, double seconds) {
  return seeds("first walk", count, [=](std::uint64_t) {
    recording::Simulation simulation = flat(Heading::arc(3.0, 0.0), seconds);
    simulation.terrain = sim3d::parse_terrain("boxes:0.10");
    return simulation;
  });
}

constexpr const char* kPolygon =
    "braking harder would take the zero-moment point out of the support polygon";
constexpr const char* kBounces =
    "a foot that has hardly landed loses contact while the body brakes";
constexpr const char* kUnloaded = "a foot that stands carries little while the body brakes";
constexpr const char* kNoReflexes =
    "a foot that rolls over an edge while a neighbour is in the air is only put down again";

// Walked for as long as asked.
Check to_the_end(std::span<const Walk> walks) {
  return {{"walks that went on to their end", share_of(walks,
                                                       [](const Walk& w) {
                                                         return w.summary.seconds >=
                                                                w.simulation.trial.seconds - 1e-6;
                                                       })},
          exactly(100.0)};
}

}  // namespace

std::vector<Walk> ten_headings(double seconds) {
  std::vector<Walk> walks;
  const auto add = [&](const std::string& name, const Heading& heading, double bound = 0.005) {
    walks.push_back({"heading", name, flat(heading, seconds), bound});
  };
  add("straight", Heading::straight(0.0));
  for (const double r : {3.0, 1.0, 0.3, -1.0})
    add(fmt::format("r = {} m", r), Heading::arc(r, 0.0));
  add("spin ccw", Heading::spin(Turn::ccw));
  add("spin cw", Heading::spin(Turn::cw));
  add("crab 45°", Heading::straight(std::numbers::pi / 4.0), 0.015);
  add("crab 90°", Heading::straight(std::numbers::pi / 2.0));
  add("backwards", Heading::straight(std::numbers::pi));
  return walks;
}

std::vector<Walk> over_terrain(const std::string& terrain, std::uint64_t count, double metres,
                               const std::string& plant) {
  const std::string group = plant == "ideal" ? terrain : terrain + " with the plant " + plant;
  return seeds(group, count, [&](std::uint64_t) {
    recording::Simulation simulation = flat(Heading::straight(0.0), 90.0);
    simulation.plant = recording::parse_plant(plant);
    simulation.terrain = sim3d::parse_terrain(terrain);
    simulation.trial.distance = metres;
    return simulation;
  });
}

Check none_stuck(std::span<const Walk> walks) {
  return {{"walks that got stuck", share_of(walks, [](const Walk& w) { return w.summary.stuck; })},
          exactly(0.0)};
}

figures::Csv table(std::span<const std::vector<Walk>> groups) {
  figures::Csv table(
      "group,walk,control_period_s,seconds_s,distance_m,turned_rad,speed_m_s,lateral_mean_m,"
      "lateral_max_m,heading_max_rad,slip_mean_m,slip_p95_m,margin_min_m,roll_max_rad,"
      "pitch_max_rad,steps,tripod_after_steps,rule1_violations,neighbour_flight_s,contact_losses,"
      "real_contact_losses,arrived,fell,stuck,hash");
  for (const auto& walks : groups)
    for (const auto& [group, name, simulation, bound, s] : walks)
      table.row(group, name, simulation.control_dt, s.seconds, s.distance, s.turned, s.speed,
                s.lateral_mean, s.lateral_max, s.heading_max, s.slip_mean, s.slip_p95, s.margin_min,
                s.roll_max, s.pitch_max, s.steps, s.tripod_after_steps.value_or(-1),
                s.rule1_violations, s.neighbour_flight, s.contact_losses, s.real_contact_losses,
                s.arrived, s.fell, s.stuck, fmt::format("{:016x}", s.state_hash));
  return table;
}

bool walk_all(const ExperimentContext& context, std::span<std::vector<Walk>> groups) {
  std::vector<Walk*> walks;
  for (std::vector<Walk>& group : groups)
    for (Walk& walk : group) {
      if (!context.plant.is_ideal()) walk.simulation.plant = context.plant;
      walks.push_back(&walk);
    }

  const auto simulate = [&](std::size_t k) {
    walks[k]->summary = recording::simulate(*context.robot, walks[k]->simulation, {}, context.stop);
  };
  const auto cores = static_cast<int>(std::thread::hardware_concurrency());
  return on_workers(context, walks.size(), cores, simulate, [](std::size_t) {});
}

double farthest_workspace(const RobotModel& robot) {
  double reach = 0.0;
  for (const LegModel& leg : robot.legs) reach = std::max(reach, leg.p_BC.head<2>().norm());
  return reach;
}

double outermost_speed(const Walk& walk, double reach) {
  return walk.summary.speed + reach * std::abs(walk.summary.turned) / walk.summary.seconds;
}

Verdict judge_headings(std::span<const Walk> walks, double reach) {
  const auto most = [&](auto value) { return worst(walks, value); };
  const double lateral = most([](const Walk& w) { return w.summary.lateral_mean; });
  const double share = most([](const Walk& w) { return w.summary.lateral_mean / w.max_lateral; });
  const double slip = most([](const Walk& w) { return w.summary.slip_p95; });
  const double losses = most([](const Walk& w) { return w.summary.contact_losses; });
  const double slowest =
      statistics::least(each(walks, [&](const Walk& w) { return outermost_speed(w, reach); }));
  return {
      .claim = fmt::format("{} headings on flat ground, {} s each", walks.size(),
                           walks.front().simulation.trial.seconds),
      .safety = no_fall_and_rule_1(summaries(walks)),
      .checks = {
          none_stuck(walks),
          to_the_end(walks),
          {{"mean distance from the path, share of 5 mm (crab 45°: 15 mm)", "%", 100.0 * share,
            fmt::format("at worst {:.2f} mm", 1e3 * lateral)},
           at_most(100.0)},
          {{"slip of a stance, 95th percentile, worst heading", "mm", 1e3 * slip}, at_most(0.3)},
          {{"contacts lost", "", losses}, exactly(0.0)},
          {{"speed straight on", "m/s", walks.front().summary.speed}, at_least(0.20)},
          {{"speed of the outermost foot, slowest heading", "m/s", slowest}, at_least(0.18)}}};
}

Verdict judge_postures(std::span<const Walk> walks) {
  // A walk that never finds the tripod gait has no number of steps.
  const double steps = worst(walks, [](const Walk& w) {
    const auto& after = w.summary.tripod_after_steps;
    return after ? *after : std::nan("");
  });
  // Feet that start at different heights touch down one after the other: some bounce.
  return {
      .claim = fmt::format("From {} random starting postures: tripod gait", walks.size()),
      .safety = no_fall_and_rule_1(summaries(walks), 0.2),
      .checks = {none_stuck(walks), {{"steps before it, worst start", "", steps}, at_most(25.0)}}};
}

Verdict judge_commands(std::span<const Walk> walks) {
  return {
      .claim = fmt::format("A new random (r, α) every second for {} s, {} seeds",
                           walks.front().simulation.trial.seconds, walks.size()),
      // A foot may bounce in the tick in which its neighbour lifts: the controller hears of it in the next.
      .safety = no_fall_and_rule_1(summaries(walks), 0.2, 1.0),
      .checks = {none_stuck(walks), to_the_end(walks)}};
}

Verdict judge_sharp_changes(std::span<const Walk> walks) {
  const auto off = [](const Walk& w) { return 1e2 * w.summary.lateral_max; };
  const auto margin = [](const Walk& w) { return 1e2 * w.summary.margin_min; };
  const auto flight = [](const Walk& w) { return w.summary.neighbour_flight; };
  return {.claim = fmt::format("{} sharp changes of heading at full speed", walks.size()),
          .safety = no_fall(summaries(walks)),
          .checks = {
              none_stuck(walks), to_the_end(walks),
              Check({"farthest from the path, worst change", "cm", worst(walks, off)}, at_most(2.0))
                  .expected_to_fail(between(2.0, 4.0), kPolygon),
              Check({"least stability margin of all", "cm", statistics::least(each(walks, margin))},
                    at_least(0.0))
                  .expected_to_fail(between(-30.0, 0.0), kBounces),
              Check({"two neighbours off the ground, worst change", "s", worst(walks, flight)},
                    at_most(0.0))
                  .expected_to_fail(between(0.05, 0.5), kUnloaded)}};
}

namespace {

Verdict on_rough_ground(std::span<const Walk> walks, std::vector<SafetyCheck> safety,
                        const Bound& arrive) {
  const auto lateral = each(walks, [](const Walk& w) { return 1e2 * w.summary.lateral_mean; });
  const auto speed = each(walks, [](const Walk& w) { return w.summary.speed; });
  const Measured arrived("walks that arrive",
                         share_of(walks, [](const Walk& w) { return w.summary.arrived; }));
  const Measured off("mean distance from the path", "cm", statistics::estimate(lateral),
                     fmt::format("worst walk {:.2f} cm", statistics::greatest(lateral)));
  return {.claim = fmt::format("{} m of {}, {} seeds", walks.front().simulation.trial.distance,
                               walks.front().group, walks.size()),
          .safety = std::move(safety),
          .checks = {{arrived, arrive}, Check::of_interval(off, at_most(3.0))},
          .remark = fmt::format("{:.3f} m/s", statistics::estimate(speed).mean)};
}

}  // namespace

Verdict judge_terrain(std::span<const Walk> walks) {
  return on_rough_ground(walks, no_fall_on_rough_ground(summaries(walks), 5.0, 3.0),
                         exactly(100.0));
}

Verdict judge_plant(std::span<const Walk> walks) {
  return on_rough_ground(walks, no_fall(summaries(walks)), exactly(100.0));
}

// Of 60 walks over boxes of 10 cm with the plant real, one falls and one gets stuck.
Verdict judge_real_plant(std::span<const Walk> walks) {
  return on_rough_ground(walks, no_fall(summaries(walks), "walks", at_most(5.0)), at_least(95.0));
}

Verdict judge_first_walk(std::span<const Walk> walks) {
  const auto mean = [&](auto value) { return statistics::estimate(each(walks, value)); };
  const Measured off("mean distance from the path", "cm",
                     mean([](const Walk& w) { return 1e2 * w.summary.lateral_mean; }));
  const Measured flight("two neighbours off the ground", "s",
                        mean([](const Walk& w) { return w.summary.neighbour_flight; }));
  const auto per_step = [](int count, const Walk& w) {
    return static_cast<double>(count) / w.summary.steps;
  };
  const Measured losses(
      "contacts lost per step, for over 20 ms or by over 5 mm", "",
      mean([&](const Walk& w) { return per_step(w.summary.real_contact_losses, w); }),
      fmt::format("{:.2f} with bounces",
                  mean([&](const Walk& w) { return per_step(w.summary.contact_losses, w); }).mean));
  return {.claim = fmt::format("The walk of `./run`, {} s of boxes:0.10 with r = 3 m, {} seeds",
                               walks.front().simulation.trial.seconds, walks.size()),
          .safety = no_fall(summaries(walks)),
          .checks = {none_stuck(walks),
                     {off, at_most(3.0)},
                     Check(flight, at_most(0.1)).expected_to_fail(between(0.15, 0.6), kNoReflexes),
                     {losses, at_most(0.1)}}};
}

Outcome walks(const ExperimentContext& context, figures::StagedFiles& files) {
  const bool brief = context.short_form;
  std::vector<std::vector<Walk>> groups = {
      ten_headings(brief ? 6.0 : 40.0),
      postures(brief ? 3 : 20),
      random_commands(*context.robot, brief ? 1 : 5, brief ? 20.0 : 120.0),
      over_terrain("boxes:0.10", brief ? 2 : 20, brief ? 1.0 : 5.0),
      over_terrain("steps:0.10", brief ? 2 : 20, brief ? 1.0 : 5.0),
      first_walks(brief ? 1 : 20, brief ? 5.0 : 30.0),
      sharp_changes(brief),
      over_terrain("boxes:0.10", brief ? 1 : 20, brief ? 1.0 : 5.0, "real"),
      over_terrain("boxes:0.10", brief ? 1 : 20, brief ? 1.0 : 5.0, "late_ticks:5%")};
  if (!context.plant.is_ideal()) groups.resize(7);  // the others have plants of their own
  if (!walk_all(context, groups)) return {};
  show(*context.robot, groups[5].front().simulation, context);
  files.write("walks.csv", table(groups).text());

  std::size_t count = 0;
  for (const auto& group : groups) count += group.size();
  std::vector<Verdict> verdicts = {judge_headings(groups[0], farthest_workspace(*context.robot)),
                                   judge_postures(groups[1]), judge_commands(groups[2])};
  for (const std::size_t k : {3U, 4U})
    verdicts.push_back(judged_in_full_only(judge_terrain(groups[k]), brief));
  verdicts.push_back(judged_in_full_only(judge_sharp_changes(groups[6]), brief));
  if (groups.size() > 7) {
    verdicts.push_back(judged_in_full_only(judge_real_plant(groups[7]), brief));
    verdicts.push_back(judged_in_full_only(judge_plant(groups[8]), brief));
  }
  verdicts.push_back(judged_in_full_only(judge_first_walk(groups[5]), brief));
  return {.verdicts = verdicts,
          .settings = {{"robot", context.robot->name}, {"walks", std::to_string(count)}}};
}

}  // namespace hexagait::experiments

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// The walks by which we judge the controller: ten headings on flat ground, twenty random starting
// postures, headings that change every second, and random terrain. A table with a row per walk.
#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <hexagait/experiments/experiment.hpp>

namespace hexagait::experiments {
namespace {

using heading_control::Heading;
using heading_control::Turn;

struct Walk {
  std::string group, name;
  recording::Simulation simulation;
  double max_lateral = 0.0;  ///< bound on the mean distance from the path [m]; 0: none
  walk::Summary summary;
};

recording::Simulation flat(const Heading& heading, double seconds) {
  recording::Simulation simulation;
  simulation.trial.schedule = {{0.0, heading}};
  simulation.trial.seconds = seconds;
  return simulation;
}

void add_headings(std::vector<Walk>& walks) {
  const auto add = [&](const std::string& name, const Heading& heading, double bound = 0.005) {
    walks.push_back({"heading", name, flat(heading, 40.0), bound, {}});
  };
  add("straight", Heading::straight(0.0));
  for (const double r : {3.0, 1.0, 0.3, -1.0})
    add(fmt::format("r = {} m", r), Heading::arc(r, 0.0));
  add("spin ccw", Heading::spin(Turn::ccw));
  add("spin cw", Heading::spin(Turn::cw));
  add("crab 45°", Heading::straight(std::numbers::pi / 4.0), 0.015);
  add("crab 90°", Heading::straight(std::numbers::pi / 2.0));
  add("backwards", Heading::straight(std::numbers::pi));
}

void add_postures(std::vector<Walk>& walks) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    recording::Simulation simulation = flat(Heading::straight(0.0), 20.0);
    simulation.seed = seed;
    simulation.random_posture = 0.10;
    walks.push_back({"posture", fmt::format("seed {}", seed), simulation, 0.0, {}});
  }
}

void add_random_commands(std::vector<Walk>& walks) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    recording::Simulation simulation;
    simulation.seed = seed;
    simulation.trial.schedule = walk::random_schedule(seed, 1.0, 120.0);
    simulation.trial.seconds = 120.0;
    walks.push_back({"commands", fmt::format("seed {}", seed), simulation, 0.0, {}});
  }
}

void add_terrain(std::vector<Walk>& walks, const std::string& terrain) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    recording::Simulation simulation = flat(Heading::straight(0.0), 90.0);
    simulation.seed = seed;
    simulation.terrain = sim3d::parse_terrain(terrain);
    simulation.trial.distance = 5.0;
    walks.push_back({terrain, fmt::format("seed {}", seed), simulation, 0.0, {}});
  }
}

void write_table(std::ostream& out, const std::vector<Walk>& walks) {
  out << "group,walk,seconds_s,distance_m,turned_rad,speed_m_s,lateral_mean_m,lateral_max_m,"
         "heading_max_rad,slip_mean_m,slip_p95_m,margin_min_m,roll_max_rad,pitch_max_rad,steps,"
         "tripod_after_steps,rule1_violations,neighbour_flight_s,contact_losses,fell,stuck,hash\n";
  for (const auto& [group, name, simulation, bound, s] : walks)
    fmt::print(out, "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{:d},{:d},{:016x}\n",
               group, name, s.seconds, s.distance, s.turned, s.speed, s.lateral_mean, s.lateral_max,
               s.heading_max, s.slip_mean, s.slip_p95, s.margin_min, s.roll_max, s.pitch_max,
               s.steps, s.tripod_after_steps.value_or(-1), s.rule1_violations, s.neighbour_flight,
               s.contact_losses, s.fell, s.stuck, s.state_hash);
}

// Largest of a figure over the walks of a group.
template <class Value>
double worst(const std::vector<Walk>& walks, const std::string& group, Value value) {
  double most = 0.0;
  for (const Walk& walk : walks)
    if (walk.group == group) most = std::max(most, static_cast<double>(value(walk)));
  return most;
}

Verdict judge_headings(const std::vector<Walk>& walks) {
  const auto group = [&](auto figure) { return worst(walks, "heading", figure); };
  const double off = group([](const Walk& w) { return w.summary.lateral_mean / w.max_lateral; });
  const double lateral = group([](const Walk& w) { return w.summary.lateral_mean; });
  const double slip = group([](const Walk& w) { return w.summary.slip_p95; });
  const double losses = group([](const Walk& w) { return w.summary.contact_losses; });
  const double straight = walks.front().summary.speed;
  return {
      "Ten headings on flat ground, 40 s each: mean distance from the path at most 0.5 cm (crab "
      "45°: 1.5 cm), slip p95 at most 0.3 mm, at least 0.20 m/s straight, no contact lost",
      off <= 1.0 && slip <= 3e-4 && losses == 0.0 && straight >= 0.20,
      fmt::format("{:.2f} cm at worst, {:.2f} mm, {:.3f} m/s, {} losses", 100.0 * lateral,
                  1e3 * slip, straight, losses)};
}

Verdict judge_postures(const std::vector<Walk>& walks) {
  const double lifts = worst(walks, "posture", [](const Walk& w) {
    return w.summary.tripod_after_steps.value_or(w.summary.steps + 1000);
  });
  return {"From 20 random starting postures: tripod gait within 25 steps", lifts <= 25.0,
          fmt::format("after {} steps at worst", lifts)};
}

Verdict judge_commands(const std::vector<Walk>& walks) {
  const auto group = [&](auto figure) { return worst(walks, "commands", figure); };
  const double failed = group([](const Walk& w) { return !w.summary.ok(); });
  const double violations = group([](const Walk& w) { return w.summary.rule1_violations; });
  const double flight = group([](const Walk& w) { return w.summary.neighbour_flight; });
  return {"A new random (r, α) every second for 120 s, 5 seeds: no fall, no rule 1 violation",
          failed == 0.0 && violations == 0.0,
          fmt::format("{} violations; two neighbours in fact off the ground for {:.3f} s at worst",
                      violations, flight)};
}

Verdict judge_terrain(const std::vector<Walk>& walks, const std::string& terrain) {
  int arrived = 0, count = 0;
  double lateral = 0.0, speed = 0.0;
  for (const Walk& walk : walks) {
    if (walk.group != terrain) continue;
    ++count;
    arrived += walk.summary.arrived;
    lateral += walk.summary.lateral_mean;
    speed += walk.summary.speed;
  }
  lateral /= count;
  const double most = worst(walks, terrain, [](const Walk& w) { return w.summary.lateral_mean; });
  return {fmt::format("5 m of {}, 20 seeds: all arrive, mean distance from the path at most 3 cm",
                      terrain),
          arrived == count && lateral <= 0.03,
          fmt::format("{} of {}; {:.2f} cm on average, {:.2f} cm in the worst walk; {:.3f} m/s",
                      arrived, count, 100.0 * lateral, 100.0 * most, speed / count)};
}

}  // namespace

Outcome walks(const ExperimentContext& context, figures::StagedFiles& files) {
  std::vector<Walk> walks;
  add_headings(walks);
  add_postures(walks);
  add_random_commands(walks);
  add_terrain(walks, "boxes:0.10");
  add_terrain(walks, "steps:0.10");

  for (std::size_t k = 0; k < walks.size(); ++k) {
    if (context.stop != nullptr && context.stop->load()) break;
    walks[k].summary = recording::simulate(*context.robot, walks[k].simulation, {}, context.stop);
    if (context.progress)
      context.progress(static_cast<double>(k + 1) / static_cast<double>(walks.size()));
  }
  std::ofstream table = files.create("walks.csv");
  write_table(table, walks);

  return {.walk = recording::WalkReport{context.robot->name, walks.front().simulation,
                                        walks.front().summary},
          .verdicts = {judge_headings(walks), judge_postures(walks), judge_commands(walks),
                       judge_terrain(walks, "boxes:0.10"), judge_terrain(walks, "steps:0.10")}};
}

}  // namespace hexagait::experiments

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// Success and cost against the height of boxes, of four controllers, on terrains that are the same for
// all: the protocol of docs/rough_terrain.md.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <hexagait/experiments/walks.hpp>
#include <hexagait/rough/rough.gp.hpp>
#include <hexagait/rough/rough.hpp>
#include <hexagait/rough/tally.hpp>
#include <hexagait/sweep/results.hpp>
#include <hexagait/sweep/run_shard.hpp>
#include <stdexcept>

namespace hexagait::experiments {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kSeeds = 200;  // a point, by the protocol
// The first is what the others are compared with.
constexpr const char* kControllers[] = {"tripod", "free", "clocked", "wave:0.6"};
constexpr double kShares[] = {0.0,  0.08, 0.16, 0.24, 0.32,
                              0.40, 0.48, 0.64, 0.80};  // of the reach of a leg

std::vector<recording::PlantSetup> plants(const ExperimentContext& context) {
  if (!context.plant.is_ideal()) return {context.plant};
  return {recording::parse_plant("ideal"), recording::parse_plant("real")};
}

// How long they will take on this machine: from some seconds of a walk, and what walks last on average.
void tell_how_long(const ExperimentContext& context, const sweep::Sweep& sweep) {
  if (!context.say || context.short_form) return;
  constexpr double kTrial = 4.0, kUsual = 40.0;  // [s]
  recording::Simulation simulation;
  simulation.terrain = sim3d::parse_terrain(sweep.terrains.back().terrain);
  simulation.trial.schedule = {{0.0, heading_control::Heading::straight(0.0)}};
  simulation.trial.seconds = kTrial;
  const double factor =
      recording::simulate(*context.robot, simulation, {}, context.stop).real_time_factor;
  const auto walks = static_cast<double>(sweep::num_trials(sweep));
  const double hours =
      walks * kUsual / factor / 3600.0 / context.jobs / static_cast<double>(context.parts);
  context.say(
      fmt::format("{:.0f} walks{}: about {:.1f} h on {} worker{}; Ctrl-C keeps what is done", walks,
                  context.parts > 1 ? fmt::format(" in {} parts", context.parts) : "", hours,
                  context.jobs, context.jobs == 1 ? "" : "s"));
}

// Walks a part of them, or all. @returns whether it went to the end
bool walk(const ExperimentContext& context, const sweep::Sweep& sweep, const fs::path& directory) {
  const sweep::RunOutcome outcome =
      sweep::run_shard(sweep, {context.part, context.parts}, directory,
                       {.jobs = context.jobs,
                        .stop = context.stop,
                        .progress = [&](std::uint64_t finished, std::uint64_t whole) {
                          context.tell(finished, whole);
                        }});
  if (context.stopped()) return false;
  if (!outcome.complete())
    throw std::runtime_error(
        fmt::format("{} of {} walks are missing{}", outcome.trials - outcome.finished,
                    outcome.trials, outcome.failures.empty() ? "" : ": " + outcome.failures[0]));
  return true;
}

Outcome part_of_it(const ExperimentContext& context, const fs::path& directory) {
  return {.left = fmt::format("part {} of {} is walked, into '{}'; hexagait merge puts all parts "
                              "together, into '{}', and the same command without --shard judges "
                              "them",
                              context.part + 1, context.parts, directory.string(),
                              (context.directory / "walks").string())};
}

void draw(figures::StagedFiles& files, const ExperimentContext& context,
          const std::vector<RoughPoint>& points, const std::string& plant, const RoughSize& size) {
  std::vector<RoughPoint> of_plant;
  std::ranges::copy_if(points, std::back_inserter(of_plant),
                       [&](const RoughPoint& p) { return p.plant == plant; });
  std::string stem = "rough_" + plant;
  std::ranges::replace_if(
      stem, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_'; },
      '_');
  figures::write_tables(files, stem, {{"points", table(of_plant, leg_reach(*context.robot))}});
  figures::Figure figure{stem, "", "", "", 1500, 950};
  if (context.titles) {
    figure.headline = "Boxes: success and cost against their height";
    figure.subtitle = fmt::format(
        "{}, {:g} m straight on within {:g} s, {} terrains a height, the same for all controllers "
        "· plant {} · bands: 95 %",
        context.robot->name, size.distance, size.seconds, size.seeds, plant);
  }
  figures::draw_figure(
      files, figure,
      {{"names", std::vector<std::string>(std::begin(kControllers), std::end(kControllers))}},
      scripts::rough::rough);
}

// The free gait over boxes of a third of the reach of a leg.
void show_one(const ExperimentContext& context) {
  const RoughSize size = rough_size(*context.robot, context.seeds, false);
  JudgedWalk walk = over_terrain(fmt::format("boxes:{:g}", size.heights[size.heights.size() / 2]),
                                 1, size.distance)
                        .front();
  walk.simulation.plant = context.plant;
  show(*context.robot, walk.simulation, context);
}

}  // namespace

double leg_reach(const RobotModel& robot) {
  double reach = 0.0;
  for (const LegModel& leg : robot.legs) reach = std::max(reach, leg.max_reach);
  return reach;
}

RoughSize rough_size(const RobotModel& robot, std::uint64_t seeds, bool short_form) {
  constexpr double kWhole = 0.05;  // heights are whole multiples of this [m]
  if (short_form) return {{0.0, 0.10}, 1, 0.3, 6.0};
  RoughSize size{{}, seeds > 0 ? seeds : kSeeds, 5.0, 90.0};
  for (const double share : kShares)
    size.heights.push_back(kWhole * std::round(share * leg_reach(robot) / kWhole));
  return size;
}

sweep::Sweep rough_sweep(const RobotModel& robot, const RoughSize& size,
                         std::vector<recording::PlantSetup> plants) {
  sweep::Sweep sweep;
  sweep.engine = sweep::Engine::ode;
  for (const char* const controller : kControllers)
    sweep.controllers.push_back(gait_state::parse_gait_choice(controller).value());
  sweep.robots = {{robot.name, robot}};
  sweep.plants = std::move(plants);
  for (const double height : size.heights)
    sweep.terrains.push_back(sweep::ground(
        sweep::Engine::ode, height > 0.0 ? fmt::format("boxes:{:g}", height) : "flat"));
  for (std::uint64_t seed = 1; seed <= size.seeds; ++seed) sweep.seeds.push_back(seed);
  sweep.num_seeds = size.seeds;
  sweep.limits.seconds = size.seconds;
  sweep.limits.distance = size.distance;
  sweep.measure = "speed_m_s";
  return sweep;
}

Outcome rough(const ExperimentContext& context, figures::StagedFiles& files) {
  const RoughSize size = rough_size(*context.robot, context.seeds, context.short_form);
  const sweep::Sweep sweep = rough_sweep(*context.robot, size, plants(context));
  const std::string name = context.parts > 1
                               ? fmt::format("part-{}-of-{}", context.part + 1, context.parts)
                           : context.short_form ? "short-walks"
                                                : "walks";
  const fs::path directory = context.directory / name;
  if (context.short_form) fs::remove_all(directory);
  tell_how_long(context, sweep);
  if (!walk(context, sweep, directory)) return {};
  if (context.parts > 1) return part_of_it(context, directory);
  sweep::publish(directory);
  show_one(context);

  const std::vector<RoughPoint> points = tally(directory);
  const double reach = leg_reach(*context.robot);
  const figures::Csv numbers = table(points, reach);
  files.write("rough.csv", numbers.text());
  files.write("rough.md", page(points, reach));
  for (const recording::PlantSetup& plant : sweep.plants)
    draw(files, context, points, plant.name, size);

  std::vector<Verdict> verdicts = {judge_success(points), judge_real(points), judge_lead(points)};
  const bool enough = size.seeds >= kSeeds;
  if (!enough && !context.short_form && context.plant.is_ideal())
    for (Verdict& verdict : verdicts)
      verdict = only_told(verdict, fmt::format("it takes {} seeds a height", kSeeds));
  return {.verdicts = judged_in_full_only(verdicts, context.short_form),
          .settings = {{"robot", context.robot->name},
                       {"walks", std::to_string(sweep::num_trials(sweep))},
                       {"seeds", std::to_string(size.seeds)}},
          .provenance = recording::provenance(context.robot->name, *context.robot, {}),
          .table = numbers,
          .judges_all = enough};
}

}  // namespace hexagait::experiments

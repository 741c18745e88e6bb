// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <hexagait/experiments/walk_checks.hpp>
#include <hexagait/experiments/walks.hpp>
#include <hexagait/figures/csv.hpp>
#include <hexagait/recording/plant_setup.hpp>
#include <hexagait/sensitivity/costs.hpp>
#include <hexagait/sensitivity/sensitivity.hpp>
#include <hexagait/sweep/report.hpp>
#include <hexagait/sweep/results.hpp>
#include <hexagait/sweep/run_shard.hpp>
#include <stdexcept>

namespace hexagait::experiments {
namespace {

namespace fs = std::filesystem;

constexpr const char* kBoxes = "boxes:0.10";

// A directory that is gone when this is.
class ScratchDirectory {
 public:
  ScratchDirectory() {
    std::string name = (fs::temp_directory_path() / "hexagait-sensitivity-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      throw std::runtime_error("can't make a directory in " + fs::temp_directory_path().string());
    path_ = name;
  }
  ~ScratchDirectory() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchDirectory(const ScratchDirectory&) = delete;
  ScratchDirectory& operator=(const ScratchDirectory&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

PageHead head(bool short_form) {
  return short_form ? PageHead{0.3, 5.0, 1, 1, true} : PageHead{5.0, 45.0, 4, 12, false};
}

sweep::Sweep sweep_of(const ExperimentContext& context, const std::vector<Ladder>& ladders,
                      const PageHead& head, const std::string& terrain, std::uint64_t seeds) {
  sweep::Sweep sweep;
  sweep.engine = sweep::Engine::ode;
  sweep.controllers = {{}};
  sweep.robots = {{context.robot->name, *context.robot}};
  sweep.plants.clear();
  for (const Ladder& ladder : ladders)
    for (const std::string& plant : ladder.plants)
      sweep.plants.push_back(recording::parse_plant(plant));
  sweep.terrains = {sweep::ground(sweep::Engine::ode, terrain)};
  sweep.num_seeds = seeds;
  sweep.limits.seconds = head.seconds;
  sweep.limits.distance = head.distance;
  sweep.measure = "speed_m_s";
  return sweep;
}

// A column, by plant.
std::vector<sweep::ReportLine> lines(const fs::path& directory, const char* measure,
                                     bool all_trials = false) {
  return sweep::make_report(
             directory,
             {.measure = measure, .compare = sweep::Compare::plants, .all_trials = all_trials})
      .lines;
}

double mean(const sweep::ReportLine& line) {
  return line.value ? line.value->value : std::numeric_limits<double>::quiet_NaN();
}

// By plant, in the order of the sweep.
std::vector<Cost> costs(const fs::path& directory) {
  const auto arrived = lines(directory, "arrived"), speed = lines(directory, "speed_m_s"),
             off_path = lines(directory, "lateral_mean_m"), steps = lines(directory, "steps", true),
             losses = lines(directory, "contact_losses", true),
             real = lines(directory, "real_contact_losses", true);
  std::vector<Cost> result;
  for (std::size_t k = 0; k < arrived.size(); ++k) {
    const auto per_step = [&](const sweep::ReportLine& of) {
      return mean(steps[k]) > 0.0 ? mean(of) / mean(steps[k]) : 0.0;
    };
    const int trials = arrived[k].value ? arrived[k].value->count : 0;
    const auto count = static_cast<int>(std::lround(mean(arrived[k]) * trials));
    result.push_back({.arrived = statistics::proportion(count, trials),
                      .speed = mean(speed[k]),
                      .off_path = mean(off_path[k]),
                      .losses = per_step(losses[k]),
                      .real_losses = per_step(real[k])});
  }
  return result;
}

// Walks of one terrain, of which all results are in; none if it was stopped.
std::vector<Cost> walk(const ExperimentContext& context, const sweep::Sweep& sweep, double share,
                       double before) {
  const ScratchDirectory scratch;
  const fs::path directory = scratch.path() / "sweep";
  const sweep::RunOutcome outcome =
      sweep::run_shard(sweep, {}, directory,
                       {.jobs = context.jobs,
                        .stop = context.stop,
                        .progress = [&](std::uint64_t finished, std::uint64_t whole) {
                          if (context.progress)
                            context.progress(before + share * static_cast<double>(finished) /
                                                          static_cast<double>(whole));
                        }});
  if (context.stopped()) return {};
  if (!outcome.complete() || outcome.without_result > 0)
    throw std::runtime_error(fmt::format("{} of {} walks have no result",
                                         outcome.trials - outcome.finished + outcome.without_result,
                                         outcome.trials));
  sweep::publish(directory);
  return costs(directory);
}

// How well it walks with the plant that is called real.
Verdict judge_real(const PlantCost& real) {
  return {.claim = "With the plant `real` it walks as with an ideal one",
          .checks = {{{"walks over boxes:0.10 that arrive", real.boxes.arrived}, exactly(100.0)},
                     {{"walks on flat ground that arrive", real.flat.arrived}, exactly(100.0)},
                     {{"mean distance from the path, flat", "cm", 100.0 * real.flat.off_path},
                      at_most(1.0)}}};
}

constexpr const char* kNoHaste =
    "steps are not hastened where drives lag, and those of the ideal plant are";

// What each imperfection may cost at a size that robots have.
Verdict judge_goals(const std::vector<PlantCost>& all) {
  const Cost& ideal = cost_of("ideal", all).flat;
  const auto off = [&](const char* plant, const char* where, const Cost& cost, double most) {
    return Check{{fmt::format("mean distance from the path with {}, {}", plant, where), "cm",
                  100.0 * cost.off_path},
                 at_most(most)};
  };
  const auto speed = [&](const char* plant, double least) {
    return Check{{fmt::format("share of the ideal plant's speed with {}, flat", plant), "%",
                  100.0 * cost_of(plant, all).flat.speed / ideal.speed},
                 at_least(least)};
  };
  const PlantCost& noisy = cost_of("joint_noise:2mrad", all);
  return {.claim = "Noise, false contacts, lag and servos without velocities cost little",
          .checks = {off("joint_noise:2mrad", "flat", noisy.flat, 2.0),
                     off("joint_noise:2mrad", kBoxes, noisy.boxes, 4.0),
                     speed("false_contacts:0.1%", 95.0),
                     speed("servo_lag:40ms", 80.0).expected_to_fail(between(70.0, 80.0), kNoHaste),
                     speed("servo:position_only", 80.0)}};
}

figures::Csv table(const std::vector<PlantCost>& all) {
  figures::Csv table(
      "plant,terrain,arrived,trials,arrived_lower,arrived_upper,speed_m_s,off_path_m,"
      "losses_per_step,real_losses_per_step");
  for (const PlantCost& plant : all)
    for (const auto& [terrain, cost] :
         {std::pair("flat", &plant.flat), std::pair(kBoxes, &plant.boxes)})
      table.row(plant.plant, terrain, cost->arrived.count, cost->arrived.trials,
                cost->arrived.lower, cost->arrived.upper, cost->speed, cost->off_path, cost->losses,
                cost->real_losses);
  return table;
}

}  // namespace

Outcome sensitivity(const ExperimentContext& context, figures::StagedFiles& files) {
  const std::vector<Ladder> ladders = experiments::ladders(context.short_form);
  const PageHead head = experiments::head(context.short_form);
  const double both = static_cast<double>(head.flat_seeds + head.boxes_seeds);
  const double share = static_cast<double>(head.flat_seeds) / both;
  const sweep::Sweep flat = sweep_of(context, ladders, head, "flat", head.flat_seeds);
  const sweep::Sweep boxes = sweep_of(context, ladders, head, kBoxes, head.boxes_seeds);
  const std::vector<Cost> on_flat = walk(context, flat, share, 0.0);
  if (on_flat.empty()) return {};
  const std::vector<Cost> on_boxes = walk(context, boxes, 1.0 - share, share);
  if (on_boxes.empty()) return {};

  show(*context.robot,
       over_terrain(kBoxes, 1, experiments::head(false).distance, "real").front().simulation,
       context);
  std::vector<PlantCost> all;
  for (std::size_t k = 0; k < flat.plants.size(); ++k)
    all.push_back({flat.plants[k].name, on_flat[k], on_boxes[k]});
  files.write("sensitivity.md", page(head, ladders, all));
  const figures::Csv numbers = table(all);
  files.write("sensitivity.csv", numbers.text());
  std::vector<Verdict> verdicts = {
      judged_in_full_only(judge_real(cost_of("real", all)), context.short_form)};
  if (!context.short_form) verdicts.push_back(judge_goals(all));  // a short one has not all plants
  return {.verdicts = verdicts,
          .settings = {{"robot", context.robot->name},
                       {"plants", std::to_string(all.size())},
                       {"walks",
                        fmt::format("{}", sweep::num_trials(flat) + sweep::num_trials(boxes))}},
          .provenance = recording::provenance(context.robot->name, *context.robot, {}),
          .table = numbers};
}

}  // namespace hexagait::experiments

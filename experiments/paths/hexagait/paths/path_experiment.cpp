// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// A path as a user gives it: a figure of eight, and a square with sharp corners, on flat ground and over
// boxes, by odometry and with the place given.
#include <fmt/format.h>

#include <hexagait/experiments/on_workers.hpp>
#include <hexagait/paths/path.gp.hpp>
#include <hexagait/paths/path_judge.hpp>
#include <hexagait/paths/path_shapes.hpp>
#include <hexagait/paths/paths.hpp>
#include <hexagait/recording/simulation.hpp>

namespace hexagait::experiments {
namespace {

using walk::LocalisedBy;

constexpr std::uint64_t kSeeds = 6;  // of the boxes
constexpr double kSeconds = 400.0, kInShort = 6.0;
constexpr double kSampling = 0.1;  // of the trace [s]

struct Drawn {
  const char* shape;
  const char* terrain;
};
constexpr Drawn kPanels[] = {{"figure of eight", "flat"},
                             {"square", "flat"},
                             {"figure of eight", "boxes:0.15"},
                             {"square", "boxes:0.15"}};

std::vector<PathWalk> planned(const ExperimentContext& context) {
  std::vector<PathWalk> walks;
  for (const Drawn& panel : kPanels) {
    const bool is_flat = panel.terrain == std::string("flat");
    const std::uint64_t seeds = is_flat || context.short_form ? 1 : kSeeds;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed)
      for (const LocalisedBy by : {LocalisedBy::odometry, LocalisedBy::truth})
        walks.push_back(
            {.shape = panel.shape, .terrain = panel.terrain, .seed = seed, .localised_by = by});
  }
  return walks;
}

path_following::Path path_of(const std::string& shape, double size) {
  return shape == "square" ? square(size) : figure_eight(size);
}

recording::Simulation simulation_of(const PathWalk& walk, const ExperimentContext& context) {
  const RobotModel& robot = *context.robot;
  recording::Simulation simulation;
  simulation.plant = context.plant;
  simulation.terrain = sim3d::parse_terrain(walk.terrain);
  simulation.seed = walk.seed;
  simulation.params = params_for(robot);
  simulation.trial.seconds = context.short_form ? kInShort : kSeconds;
  simulation.trial.schedule = {{0.0, heading_control::Heading::stop()}};
  simulation.trial.path =
      path_following::PathTask{path_of(walk.shape, scale_of(robot).size),
                               {},
                               1,
                               path_following::look_ahead_for(simulation.params.step)};
  simulation.trial.localised_by = walk.localised_by;
  return simulation;
}

// The walk that the experiment shows.
bool is_shown(const PathWalk& walk) {
  return walk.shape == kPanels[2].shape && walk.terrain == kPanels[2].terrain && walk.seed == 1 &&
         walk.localised_by == LocalisedBy::odometry;
}

void follow(PathWalk& walk, const ExperimentContext& context) {
  const recording::Simulation simulation = simulation_of(walk, context);
  walk.look_ahead = simulation.trial.path->look_ahead;
  double next = 0.0;
  const auto observe = [&](const auto& record, const GroundTruth& truth, const auto&) {
    if (record.state.time < next) return;
    next = record.state.time + kSampling;
    walk.trace.emplace_back(truth.X_WB.p.head<2>());
  };
  walk.summary = is_shown(walk)
                     ? simulate_shown(*context.robot, simulation, observe, context)
                     : recording::simulate(*context.robot, simulation, observe, context.stop);
}

figures::Csv table_of(const std::vector<PathWalk>& walks) {
  figures::Csv csv(
      "path,terrain,seed,localised_by,arrived,fell,stuck,seconds,length_m,done_m,"
      "mean_off_mm,max_off_mm,"
      "believed_mean_off_mm,believed_max_off_mm,missed_mm,end_error_mm,odometry_error_mm");
  for (const PathWalk& w : walks) {
    const walk::PathSummary& p = *w.summary.path;
    csv.row(w.shape, w.terrain, w.seed, to_string(w.localised_by), w.summary.arrived,
            w.summary.fell, w.summary.stuck, w.summary.seconds, p.length, p.done,
            1e3 * w.summary.lateral_mean, 1e3 * w.summary.lateral_max, 1e3 * p.believed_mean,
            1e3 * p.believed_max, 1e3 * p.missed, 1e3 * p.off_end,
            1e3 * w.summary.odometry_position);
  }
  return csv;
}

void draw(figures::StagedFiles& files, const ExperimentContext& context,
          const std::vector<PathWalk>& walks) {
  const double size = scale_of(*context.robot).size;
  figures::Csv paths("path,x_m,y_m"), traces("path,terrain,localised_by,walk,x_m,y_m");
  figures::Box eight, corners;
  for (const char* shape : {"figure of eight", "square"}) {
    const path_following::Path path = path_of(shape, size);
    for (int k = 0; k <= 400; ++k) {
      const Vector2 p = path.at(path.length() * k / 400.0);
      paths.row(shape, p.x(), p.y());
      (shape[0] == 's' ? corners : eight).include(p);
    }
  }
  for (std::size_t k = 0; k < walks.size(); ++k)
    for (const Vector2& p : walks[k].trace)
      traces.row(walks[k].shape, walks[k].terrain, to_string(walks[k].localised_by), k, p.x(),
                 p.y());
  figures::write_tables(files, "path", {{"paths", paths}, {"traces", traces}});
  constexpr int kWidth = 1300, kHeight = 1300;
  const figures::Panel left_up{0.06, 0.5, 0.5, 0.9}, right_up{0.56, 0.98, 0.5, 0.9},
      left{0.06, 0.5, 0.05, 0.45}, right{0.56, 0.98, 0.05, 0.45};
  const auto fitted = [&](const figures::Box& box, const figures::Panel& panel) {
    return box.grown(0.3 * size).fitted(panel, kWidth, kHeight);
  };
  figures::draw_figure(
      files,
      context.figure("path", kWidth, kHeight, "Two paths, followed",
                     fmt::format("{} · flat ground and boxes of up to 15 cm, {} seeds",
                                 context.robot->name, kSeeds)),
      {{"a", left_up},
       {"a", fitted(eight, left_up)},
       {"b", right_up},
       {"b", fitted(corners, right_up)},
       {"c", left},
       {"c", fitted(eight, left)},
       {"d", right},
       {"d", fitted(corners, right)}},
      scripts::paths::path);
}

}  // namespace

Outcome path(const ExperimentContext& context, figures::StagedFiles& files) {
  std::vector<PathWalk> walks = planned(context);
  const auto work = [&](std::size_t k) { follow(walks[k], context); };
  if (!on_workers(context, walks.size(), context.jobs, work, [](std::size_t) {})) return {};
  const figures::Csv table = table_of(walks);
  figures::write_tables(files, "path", {{"walks", table}});
  draw(files, context, walks);
  return {.verdicts = judged_in_full_only(judge_paths(walks), context.short_form),
          .settings = {{"robot", context.robot->name},
                       {"walks", fmt::format("{}, of both shapes", walks.size())},
                       {"boxes", fmt::format("seeds 1 to {}", kSeeds)}},
          .provenance = recording::provenance(context.robot->name, *context.robot,
                                              simulation_of(walks[0], context)),
          .table = table};
}

}  // namespace hexagait::experiments

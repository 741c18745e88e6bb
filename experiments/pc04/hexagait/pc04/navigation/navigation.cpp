// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// [PC04] 5.2: Genghis navigates, "to avoid collisions with walls and to scape from cliffs". An hour in
// each of some arenas.
#include <fmt/format.h>

#include <hexagait/experiments/on_workers.hpp>
#include <hexagait/pc04/navigation/navigation.gp.hpp>
#include <hexagait/pc04/navigation/navigation_judge.hpp>
#include <hexagait/pc04/pc04.hpp>

namespace hexagait::experiments {
namespace {

using navigation::Reason;

constexpr double kShownSeconds = 120.0;  // of the first walk, to the spectator [s]
constexpr SenseNoise kNoise{.range = 0.02, .pitch = 0.01};

struct Arena {
  const char* terrain;
  std::uint64_t seed;
};
constexpr Arena kArenas[] = {{"arena:6m", 1}, {"arena:6m", 2}, {"arena:6m", 3}};

std::string name_of(const NavigationWalk& walk) {
  return fmt::format("{}, seed {}", sim3d::to_string(walk.simulation.terrain),
                     walk.simulation.seed);
}

// Tells the time that all walks together have walked.
class SharedProgress {
 public:
  SharedProgress(const ExperimentContext& context, std::size_t walks, double seconds)
      : context_(&context), times_(walks, 0.0), all_(static_cast<double>(walks) * seconds) {}

  void at(std::size_t walk, double time) {
    const std::scoped_lock lock(one_at_a_time_);
    sum_ += time - times_[walk];
    times_[walk] = time;
    if (context_->progress) context_->progress(std::min(1.0, sum_ / all_));
  }

 private:
  const ExperimentContext* context_;
  std::mutex one_at_a_time_;
  std::vector<double> times_;
  double all_, sum_ = 0.0;
};

// What shows the beginning of a walk to the context's spectator.
recording::WorldObserver shown(const ExperimentContext& context, const RobotModel& robot,
                               const recording::Simulation& simulation) {
  if (context.spectator == nullptr) return {};
  context.spectator->begin(robot, simulation);
  return [spectator = context.spectator](const auto& record, const GroundTruth& truth,
                                         const auto& referee, const sim3d::World& world) {
    if (truth.time <= kShownSeconds) spectator->observe(record, truth, referee, world);
  };
}

std::vector<NavigationWalk> walked(const ExperimentContext& context, const RobotModel& robot) {
  const double seconds = context.short_form ? 40.0 : 3600.0;
  std::vector<NavigationWalk> walks(std::size(kArenas));
  SharedProgress progress(context, walks.size(), seconds);
  const auto walk = [&](std::size_t k) {
    recording::Simulation simulation;
    simulation.terrain = sim3d::parse_terrain(kArenas[k].terrain);
    simulation.seed = kArenas[k].seed;
    simulation.trial.seconds = seconds;
    walks[k] = navigate(
        robot, simulation, kNoise, [&](double time) { progress.at(k, time); }, context.stop,
        k == 0 ? shown(context, robot, simulation) : recording::WorldObserver{});
  };
  ExperimentContext quiet = context;
  quiet.progress = {};
  if (!on_workers(quiet, walks.size(), context.jobs, walk, [](std::size_t) {})) return {};
  return walks;
}

figures::Csv table_of(const std::vector<NavigationWalk>& walks) {
  figures::Csv csv(
      "terrain,seed,seconds,fell,path_m,turned_rad,area_m2,cliffs,touches,walls,steep,blocked,"
      "turns_by_lot,restarts,foot_below_floor_mm,roll_max_deg,pitch_max_deg");
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  for (const NavigationWalk& w : walks)
    csv.row(sim3d::to_string(w.simulation.terrain), w.simulation.seed, w.summary.seconds,
            w.summary.fell, w.path, w.turned, w.area, w.met(Reason::cliff), w.met(Reason::touch),
            w.met(Reason::wall), w.met(Reason::steep), w.met(Reason::blocked),
            w.met(Reason::wander), w.restarts, 1e3 * w.deepest, kDegrees * w.summary.roll_max,
            kDegrees * w.summary.pitch_max);
  return csv;
}

// Squares of the ground, around the walk.
figures::Csv ground_of(const sim3d::Terrain& terrain, const figures::Box& shown, double square) {
  figures::Csv csv("x_m,y_m,half_m,height_m");
  for (double x = shown.least.x() + 0.5 * square; x < shown.greatest.x(); x += square)
    for (double y = shown.least.y() + 0.5 * square; y < shown.greatest.y(); y += square)
      csv.row(x, y, 0.5 * square, terrain.height_at(x, y));
  return csv;
}

figures::Csv trace_of(const NavigationWalk& walk) {
  figures::Csv csv("time_s,x_m,y_m,z_m,yaw_rad,pitch_rad,act");
  for (const NavigationWalk::Sample& sample : walk.trace)
    csv.row(sample.time, sample.p_WB, sample.yaw, sample.pitch, static_cast<int>(sample.act));
  return csv;
}

figures::Csv meetings_of(const NavigationWalk& walk) {
  figures::Csv csv("time_s,x_m,y_m,z_m,reason");
  for (const NavigationWalk::Meeting& one : walk.meetings)
    csv.row(one.time, one.p_WB, to_string(one.reason));
  return csv;
}

void draw(figures::StagedFiles& files, const ExperimentContext& context, const NavigationWalk& walk,
          const std::string& stem) {
  constexpr double kShown = 6.6;  // [m]
  const sim3d::Terrain terrain(walk.simulation.terrain, walk.simulation.seed);
  const bool of_cells = terrain.surface() == sim3d::Terrain::Surface::cells;
  const double square = of_cells ? terrain.x_axis().even : 0.1;
  const figures::Box shown{Vector2::Constant(-0.5 * kShown), Vector2::Constant(0.5 * kShown)};
  figures::write_tables(files, stem,
                        {{"trace", trace_of(walk)},
                         {"meetings", meetings_of(walk)},
                         {"ground", ground_of(terrain, shown, square)}});
  figures::draw_figure(
      files,
      context.figure(
          stem, 1000, 1000, "Genghis among walls and cliffs",
          fmt::format("{} · {:.0f} min · {:.0f} m · cliffs {}, walls {} · after [PC04] 5.2",
                      name_of(walk), walk.summary.seconds / 60.0, walk.path,
                      walk.met(Reason::cliff), walk.met(Reason::touch) + walk.met(Reason::wall))),
      {{"ground", shown}}, scripts::pc04::navigation);
}

}  // namespace

Outcome navigation(const ExperimentContext& context, figures::StagedFiles& files) {
  const RobotModel genghis = context.robot_named("genghis");
  const std::vector<NavigationWalk> walks = walked(context, genghis);
  if (context.stopped()) return {};
  const figures::Csv table = table_of(walks);
  figures::write_tables(files, "navigation", {{"walks", table}});
  for (std::size_t k = 0; k < walks.size(); ++k)
    draw(files, context, walks[k], fmt::format("navigation_{}", k + 1));
  return {.verdicts = judged_in_full_only(judge_navigation(walks), context.short_form),
          .settings = {{"robot", genghis.name},
                       {"walks", fmt::format("{} of {:.0f} s", walks.size(), walks[0].asked())},
                       {"noise", fmt::format("{:g} % of ranges, {:g} rad of the pitch",
                                             100.0 * kNoise.range, kNoise.pitch)}},
          .provenance = recording::provenance(genghis.name, genghis, walks[0].simulation),
          .table = table};
}

}  // namespace hexagait::experiments

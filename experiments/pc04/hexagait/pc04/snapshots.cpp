// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/figures/csv.hpp>
#include <hexagait/pc04/snapshots.gp.hpp>
#include <hexagait/pc04/snapshots.hpp>

namespace hexagait::experiments {
namespace {

using recording::Recording;

// Around the panel, and how large it may get [px].
constexpr double kLeft = 75.0, kTop = 120.0, kBottom = 60.0;
constexpr double kWidest = 1400.0, kNarrowest = 800.0, kHighest = 950.0;

// Hips, round the body: the left ones from the front, then the right ones from the rear.
std::vector<Vector3> outline(const Recording::Sample& sample, const RobotModel& robot) {
  std::vector<Vector3> points;
  const int n = robot.num_legs();
  for (LegId i = 0; i < n; i += 2) points.push_back(sample.X_WB * robot.legs[i].X_BH.p);
  for (LegId i = n - 1; i > 0; i -= 2) points.push_back(sample.X_WB * robot.legs[i].X_BH.p);
  points.push_back(points.front());
  return points;
}

// One polyline per body and per leg, with blank lines between.
void write_snapshots(figures::StagedFiles& files, const std::string& stem,
                     const std::vector<double>& times, const Recording& recording,
                     const RobotModel& robot) {
  figures::Csv outlines("snapshot,x_m,y_m,z_m"), legs("snapshot,x_m,y_m,z_m"),
      names("snapshot,time_s,x_m,y_m,yaw_rad");
  char name = 'A';
  for (const double time : times) {
    const Recording::Sample& sample = sample_at(recording, time);
    for (const Vector3& p : outline(sample, robot)) outlines.row(name, p);
    outlines.gap();
    for (LegId i = 0; i < robot.num_legs(); ++i) {
      legs.row(name, Vector3(sample.X_WB * robot.legs[i].X_BH.p));
      legs.row(name, sample.p_WF[i]);
      legs.gap();
    }
    names.row(name++, sample.time, sample.X_WB.p.x(), sample.X_WB.p.y(),
              roll_pitch_yaw(sample.X_WB.R).z());
  }
  figures::write_tables(files, stem,
                        {{"body", recording.body_table()},
                         {"steps", recording.steps_table(robot)},
                         {"outlines", outlines},
                         {"legs", legs},
                         {"snapshots", names}});
}

void write_commands(figures::StagedFiles& files, const std::string& stem,
                    const std::vector<double>& commands, const Recording& recording) {
  figures::Csv csv("time_s,x_m,y_m");
  for (const double time : commands) {
    const Vector3& p_WB = sample_at(recording, time).X_WB.p;
    csv.row(time, p_WB.x(), p_WB.y());
  }
  figures::write_tables(files, stem, {{"commands", csv}});
}

void write_terrain(figures::StagedFiles& files, const std::string& name,
                   const sim3d::Terrain& terrain, const figures::Box& shown) {
  figures::Csv csv("x_min_m,x_max_m,y_min_m,y_max_m,height_m");
  const sim3d::CellAxis &x = terrain.x_axis(), &y = terrain.y_axis();
  const int last_x = x.index(shown.greatest.x()), last_y = y.index(shown.greatest.y());
  for (int i = x.index(shown.least.x()); i <= last_x; ++i)
    for (int j = y.index(shown.least.y()); j <= last_y; ++j)
      csv.row(x.edge(i), x.edge(i + 1), y.edge(j), y.edge(j + 1), terrain.level(i, j));
  files.write(name, csv.text());
}

}  // namespace

const Recording::Sample& sample_at(const Recording& recording, double time) {
  const auto& samples = recording.samples();
  const auto it = std::ranges::lower_bound(samples, time, {}, &Recording::Sample::time);
  return it == samples.end() ? samples.back() : *it;
}

double longest_pause(const Recording& recording) {
  double pause = 0.0, before = 0.0;
  for (const Recording::Step& step : recording.steps()) {
    pause = std::max(pause, step.lift - before);
    before = step.lift;
  }
  return std::max(pause, recording.samples().back().time - before);
}

RecordedWalk record(const ExperimentContext& context, const recording::Simulation& simulation) {
  RecordedWalk walk{Recording({simulation.terrain, simulation.seed}), {}};
  const auto observe = [&](const auto& record, const auto& truth, const auto& referee) {
    walk.recording.observe(record, truth, referee);
    if (context.progress)
      context.progress(walk.recording.samples().back().time / simulation.trial.seconds);
  };
  walk.summary = simulate_shown(*context.robot, simulation, observe, context);
  return walk;
}

void draw_snapshots(figures::StagedFiles& files, figures::Figure figure,
                    const std::vector<double>& times, const sim3d::Terrain& terrain,
                    const Recording& recording, const RobotModel& robot,
                    const std::vector<double>& commands) {
  write_snapshots(files, figure.stem, times, recording, robot);
  if (!commands.empty()) write_commands(files, figure.stem, commands, recording);

  // The figure's size, from the ground that is shown: a metre is as long across as up.
  figures::Box shown;
  for (const Recording::Sample& sample : recording.samples())
    for (const Vector3& p : sample.p_WF) shown.include(p.head<2>());
  shown = shown.grown(0.15);
  const double pixels = std::min(kWidest / shown.size().x(), kHighest / shown.size().y());
  const double widening = std::max(0.0, kNarrowest / pixels - shown.size().x());
  shown.least.x() -= 0.5 * widening;
  shown.greatest.x() += 0.5 * widening;
  const Vector2 panel = pixels * shown.size();

  const bool rough = terrain.highest() > 0.0;
  if (rough) write_terrain(files, figure.stem + "-terrain.csv", terrain, shown);
  const double width = kLeft + panel.x() + (rough ? 110.0 : 25.0);
  const double height = kTop + panel.y() + kBottom;
  figure.width = static_cast<int>(std::lround(width));
  figure.height = static_cast<int>(std::lround(height));
  const figures::Panel ground{kLeft / width, (kLeft + panel.x()) / width, kBottom / height,
                              (kBottom + panel.y()) / height};
  figures::draw_figure(files, figure,
                       {{"ground", ground},
                        {"ground", shown},
                        {"rough", rough ? 1 : 0},
                        {"commanded", commands.empty() ? 0 : 1},
                        {"level_max", terrain.highest()}},
                       scripts::pc04::snapshots);
}

}  // namespace hexagait::experiments

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/figures/figure.hpp>
#include <hexagait/recording/robot_view.hpp>
#include <hexagait/recording/snapshot_figure.hpp>
#include <hexagait/recording/snapshots.gp.hpp>
#include <sstream>

namespace hexagait::recording {
namespace {

using figures::Box;

// Around the panel, and how large it may get [px].
constexpr double kLeft = 75.0, kTop = 120.0, kBottom = 60.0;
constexpr double kWidest = 1400.0, kNarrowest = 800.0, kHighest = 950.0;

std::size_t sample_at(const Recording& recording, double time) {
  const auto& samples = recording.samples();
  const auto it = std::ranges::lower_bound(samples, time, {}, &Recording::Sample::time);
  return static_cast<std::size_t>(std::min(it, std::prev(samples.end())) - samples.begin());
}

// Where the robot was at each of the instants A, B, C …
figures::Csv instants(const Recording& recording, const std::vector<std::size_t>& samples) {
  figures::Csv csv("snapshot,time_s,x_m,y_m,yaw_rad");
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const Recording::Sample& sample = recording.samples()[samples[k]];
    csv.row(static_cast<char>('A' + k), sample.time, Vector2(sample.X_WB.p.head<2>()),
            roll_pitch_yaw(sample.X_WB.R).z());
  }
  return csv;
}

Box bounds(const Recording& recording) {
  Box box;
  for (const Recording::Sample& sample : recording.samples()) {
    box.include(sample.X_WB.p.head<2>());
    for (const Vector3& p : sample.p_WF) box.include(p.head<2>());
  }
  return box.grown(0.15);
}

}  // namespace

void draw_snapshots(figures::StagedFiles& files, const SnapshotFigure& figure,
                    const Recording& recording, const RobotModel& robot) {
  const RobotView view(recording, robot);
  std::vector<std::size_t> samples;
  for (const double time : figure.times) samples.push_back(sample_at(recording, time));
  const bool rough = figure.terrain != nullptr && figure.terrain->spec().height > 0.0;

  // The sheet's size is that of the ground: a metre is as long across as up.
  Box shown = bounds(recording);
  const double pixels = std::min(kWidest / shown.size().x(), kHighest / shown.size().y());
  const double widening = std::max(0.0, kNarrowest / pixels - shown.size().x());
  shown.least.x() -= 0.5 * widening;
  shown.greatest.x() += 0.5 * widening;
  const Vector2 panel = pixels * shown.size();
  const double width = kLeft + panel.x() + (rough ? 110.0 : 25.0);
  const double height = kTop + panel.y() + kBottom;

  const auto table = [&](const char* name, const std::string& text) {
    files.write(figure.stem + "-" + name + ".csv", text);
  };
  std::ostringstream body, steps;
  recording.write_body(body);
  recording.write_steps(steps, robot);
  table("body", body.str());
  table("steps", steps.str());
  table("outlines", view.above(samples).text());
  table("legs", view.legs(samples).text());
  table("snapshots", instants(recording, samples).text());
  if (rough) table("terrain", view.cells(shown).text());
  figures::draw_figure(files,
                       {.stem = figure.stem,
                        .headline = figure.headline,
                        .subtitle = figure.subtitle,
                        .width = static_cast<int>(std::lround(width)),
                        .height = static_cast<int>(std::lround(height))},
                       {{"walk", figures::Panel{kLeft / width, (kLeft + panel.x()) / width,
                                                kBottom / height, (kBottom + panel.y()) / height}},
                        {"walk", shown},
                        {"half_cell", 0.5 * recording.cell()},
                        {"level_max", rough ? recording.highest() : 0.0}},
                       scripts::recording::snapshots);
}

}  // namespace hexagait::recording

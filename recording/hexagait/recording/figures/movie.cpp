// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <hexagait/figures/figure.hpp>
#include <hexagait/figures/gnuplot.hpp>
#include <hexagait/recording/figures/movie.gp.hpp>
#include <hexagait/recording/figures/movie.hpp>
#include <hexagait/recording/figures/robot_view.hpp>

namespace hexagait::recording {
namespace {

using figures::Box;
using figures::Panel;

constexpr double kFrameWidth = 720.0;                                           // [px]
constexpr double kTallestPanel = 460.0;                                         // of a panel [px]
constexpr double kTop = 34.0, kBetween = 34.0, kBottom = 10.0, kBeside = 10.0;  // [px]

// What both panels show; a metre is as long in one as in the other.
struct Camera {
  Box side, above;
  double scale = 0.0;  ///< [px/m]
};

Camera camera(const Recording& recording, const RobotView& view,
              const std::vector<std::size_t>& frames) {
  const double length = view.body_length();
  Camera camera;
  for (const std::size_t k : frames) {
    const Recording::Sample& s = recording.samples()[k];
    const Vector2 base = view.from_side(k, s.X_WB.p);
    camera.side.include(base + Vector2(0.6 * length, 0.25 * length));
    camera.side.include(base - Vector2(0.6 * length, 0.0));
    camera.above.include(s.X_WB.p.head<2>() + Vector2::Constant(0.6 * length));
    camera.above.include(s.X_WB.p.head<2>() - Vector2::Constant(0.6 * length));
    for (const Vector3& p : s.p_WF) {
      camera.side.include(view.from_side(k, p) - Vector2(0.0, 0.06 * length));
      camera.above.include(p.head<2>());
    }
  }
  camera.above = camera.above.grown(0.05 * length);
  const double across = kFrameWidth - 2.0 * kBeside;
  const double widest = std::max(camera.side.size().x(), camera.above.size().x());
  const double tallest = std::max(camera.side.size().y(), camera.above.size().y());
  camera.scale = std::min(across / widest, kTallestPanel / tallest);
  for (Box* box : {&camera.side, &camera.above}) {
    const double spare = 0.5 * (across / camera.scale - box->size().x());
    box->least.x() -= spare;
    box->greatest.x() += spare;
  }
  return camera;
}

// Samples of the end of the walk, which is shown, and those of them that make a picture each.
struct Reel {
  std::vector<std::size_t> samples, frames;
};

Reel reel(const Recording& recording, const MovieOptions& options) {
  const auto per_frame = static_cast<std::size_t>(options.samples_per_frame);
  const auto most = static_cast<std::size_t>(
      std::lround(options.seconds / (Recording::kSampling * options.samples_per_frame)));
  const std::size_t count =
      std::min(most, (recording.samples().size() + per_frame - 1) / per_frame);
  const std::size_t first = recording.samples().size() - (count - 1) * per_frame - 1;
  Reel reel;
  for (std::size_t k = first; k < recording.samples().size(); ++k) {
    reel.samples.push_back(k);
    if ((k - first) % per_frame == 0) reel.frames.push_back(k);
  }
  return reel;
}

}  // namespace

std::vector<std::string> movie_files(const std::string& stem) {
  std::vector<std::string> names = {stem + "-movie.gp"};
  for (const char* name :
       {"side", "above", "legs", "support", "feet", "steps", "profile", "cells", "body"})
    names.push_back(fmt::format("{}-movie-{}.csv", stem, name));
  return names;
}

void draw_movie(figures::StagedFiles& files, const std::string& stem, const Recording& recording,
                const RobotModel& robot, const MovieOptions& options) {
  const RobotView view(recording, robot);
  const auto [samples, frames] = reel(recording, options);
  const std::size_t first = samples.front();
  const Camera seen = camera(recording, view, frames);
  const double side = std::round(seen.scale * seen.side.size().y());
  const double above = std::round(seen.scale * seen.above.size().y());
  const double height = kTop + side + kBetween + above + kBottom;
  const double left = kBeside / kFrameWidth, right = 1.0 - left;

  figures::write_tables(files, stem + "-movie",
                        {{"side", view.side(frames)},
                         {"above", view.above(frames)},
                         {"legs", view.legs(frames)},
                         {"support", view.support(frames)},
                         {"feet", view.feet(samples)},
                         {"steps", recording.steps_table(robot)},
                         {"profile", view.profile()},
                         {"cells", view.cells(seen.above)},
                         {"body", recording.body_table()}});

  const figures::Variables variables = {
      {"stem", stem + "-movie"},
      {"width", kFrameWidth},
      {"height", height},
      {"delay", 100.0 * Recording::kSampling * options.samples_per_frame},
      {"frames", static_cast<double>(frames.size())},
      {"per_frame", static_cast<double>(options.samples_per_frame)},
      {"start", recording.samples()[first].time},
      {"first", static_cast<double>(first)},
      {"outlines", static_cast<double>(view.num_outlines())},
      {"legs", static_cast<double>(robot.num_legs())},
      {"half_cell", 0.5 * recording.cell()},
      {"highest", recording.highest()},
      {"z_min", seen.side.least.y()},
      {"side", seen.side},
      {"above", seen.above},
      {"side_bottom", (kBottom + above + kBetween) / height},
      {"side_top", 1.0 - kTop / height},
      {"above_bottom", kBottom / height},
      {"above_top", (kBottom + above) / height},
      {"left", left},
      {"right", right}};
  const std::string script = stem + "-movie.gp";
  files.write(script, fmt::format("# gnuplot draws it.\nif (!exists(\"figure\")) figure = {}\n{}{}",
                                  figures::in_quotes(stem + ".gif"), variables.text(),
                                  scripts::recording::movie));
  figures::run_gnuplot(files.staging(), script, stem + ".gif");
}

}  // namespace hexagait::recording

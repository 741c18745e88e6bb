// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <hexagait/recording/figures/detail/sheet.hpp>
#include <hexagait/recording/figures/robot_view.hpp>
#include <hexagait/recording/figures/walk.gp.hpp>
#include <hexagait/recording/figures/walk_figure.hpp>

namespace hexagait::recording {
namespace {

using detail::kWidth;
using figures::Box;
using figures::Panel;

constexpr int kAboveSide = 125;       // above the side view [px]
constexpr int kBelow = 930;           // for the panels below it [px]
constexpr double kTallestSide = 420;  // side view [px]
constexpr double kLeft = 0.05, kRight = 0.985;

// Where the panels below the side view stand, in shares of 1000 px. A long path lies across, any
// other one stands on the left.
struct Layout {
  Panel path, gait, height, tilt;
};
constexpr Layout kLong = {{kLeft, kRight, 0.57, 0.85},
                          {kLeft, 0.475, 0.07, 0.475},
                          {0.55, kRight, 0.32, 0.475},
                          {0.55, kRight, 0.07, 0.245}};
constexpr Layout kSquare = {{kLeft, 0.475, 0.07, 0.86},
                            {0.55, kRight, 0.555, 0.86},
                            {0.55, kRight, 0.325, 0.475},
                            {0.55, kRight, 0.07, 0.245}};

// The part of the walk that is seen from the side, and how tall it is drawn.
struct SidePanel {
  Box shown;
  double height = 0.0;  ///< [px]
};

SidePanel side_panel(const Recording& recording, const RobotView& view) {
  const double length = view.body_length();
  SidePanel side;
  for (std::size_t k = 0; k < recording.samples().size(); ++k) {
    const Recording::Sample& s = recording.samples()[k];
    if (std::abs(s.along) > 6.5 * length) break;
    const Vector2 base = view.from_side(k, s.X_WB.p);
    side.shown.include(base + Vector2(0.75 * length, 0.3 * length));
    side.shown.include(base - Vector2(0.75 * length, 0.0));
    for (const Vector3& p : s.p_WF) side.shown.include({s.along, p.z() - 0.08 * length});
  }
  const double pixels = kWidth * (kRight - kLeft);
  const Vector2 size = side.shown.size();
  const double scale = std::min(pixels / size.x(), kTallestSide / size.y());
  const double spare = 0.5 * (pixels / scale - size.x());
  side.shown.least.x() -= spare;
  side.shown.greatest.x() += spare;
  side.height = scale * size.y();
  return side;
}

// About a body's length apart.
std::vector<std::size_t> instants(const Recording& recording, const Box& shown, double apart) {
  std::vector<std::size_t> chosen;
  for (std::size_t k = 0; k < recording.samples().size(); ++k) {
    const double along = recording.samples()[k].along;
    if (along > shown.greatest.x() - 0.5 * apart) break;
    if (chosen.empty() || std::abs(along - recording.samples()[chosen.back()].along) >= apart)
      chosen.push_back(k);
  }
  return chosen;
}

Box drawn_ground(const Recording& recording) {
  Box box;
  for (const Recording::Sample& sample : recording.samples()) {
    box.include(sample.X_WB.p.head<2>());
    box.include(sample.ideal.shift);
  }
  for (const Recording::Step& step : recording.steps())
    if (!std::isnan(step.land)) box.include(step.p_WF.head<2>());
  return box.grown(0.04 * box.size().maxCoeff() + 0.1);
}

}  // namespace

std::vector<std::string> walk_figure_files(const std::string& stem) {
  std::vector<std::string> names = {stem + ".gp"};
  for (const char* name : {"body", "steps", "gait", "outlines", "legs", "ground"})
    names.push_back(stem + "-" + name + ".csv");
  return names;
}

void draw_walk(figures::StagedFiles& files, figures::Figure figure, const Recording& recording,
               const RobotModel& robot) {
  const RobotView view(recording, robot);
  const SidePanel side = side_panel(recording, view);
  const Box ground = drawn_ground(recording);
  const Layout& layout = ground.size().x() > 1.6 * ground.size().y() ? kLong : kSquare;
  figure.width = kWidth;
  figure.height = static_cast<int>(std::lround(kAboveSide + side.height + kBelow));
  const auto placed = [&](Panel panel) {
    panel.bottom *= 1000.0 / figure.height;
    panel.top *= 1000.0 / figure.height;
    return panel;
  };
  const Panel path = placed(layout.path);
  const double top = 1.0 - static_cast<double>(kAboveSide) / figure.height;

  const auto shown = instants(recording, side.shown, 1.1 * view.body_length());
  figures::write_tables(files, figure.stem,
                        {{"body", recording.body_table()},
                         {"steps", recording.steps_table(robot)},
                         {"gait", recording.gait_table()},
                         {"outlines", view.side(shown)},
                         {"legs", view.legs(shown)},
                         {"ground", view.profile()}});
  draw_figure(files, figure,
              {{"side", Panel{kLeft, kRight, top - side.height / figure.height, top}},
               {"side", side.shown},
               {"z_min", side.shown.least.y()},
               {"path", path},
               {"path", ground.fitted(path, figure.width, figure.height)},
               {"gait", placed(layout.gait)},
               {"height", placed(layout.height)},
               {"tilt", placed(layout.tilt)},
               {"t_max", recording.samples().back().time},
               {"legs", static_cast<double>(robot.num_legs())},
               {"row_names", fmt::format("({})", row_names(robot))}},
              scripts::recording::walk);
}

}  // namespace hexagait::recording

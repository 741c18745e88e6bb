// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <hexagait/figures/gnuplot.hpp>
#include <hexagait/recording/snapshot_figure.hpp>
#include <ostream>

namespace hexagait::recording {
namespace {

// Around the panel, and how large it may get [px].
constexpr double kLeft = 75.0, kTop = 120.0, kBottom = 60.0;
constexpr double kWidest = 1400.0, kNarrowest = 800.0, kHighest = 950.0;

const Recording::Sample& sample_at(const Recording& recording, double time) {
  const auto& samples = recording.samples();
  const auto it = std::ranges::lower_bound(samples, time, {}, &Recording::Sample::time);
  return it == samples.end() ? samples.back() : *it;
}

void write_point(std::ostream& out, const std::string& name, const Vector3& p) {
  out << fmt::format("{},{:.4f},{:.4f}\n", name, p.x(), p.y());
}

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
void write_snapshots(figures::StagedFiles& files, const SnapshotFigure& figure,
                     const Recording& recording, const RobotModel& robot) {
  std::ofstream outlines = files.create(figure.stem + "-outlines.csv");
  std::ofstream legs = files.create(figure.stem + "-legs.csv");
  std::ofstream names = files.create(figure.stem + "-snapshots.csv");
  outlines << "snapshot,x_m,y_m\n\n";
  legs << "snapshot,x_m,y_m\n\n";
  names << "snapshot,time_s,x_m,y_m,yaw_rad\n";
  for (std::size_t k = 0; k < figure.times.size(); ++k) {
    const std::string name(1, static_cast<char>('A' + k));
    const Recording::Sample& sample = sample_at(recording, figure.times[k]);
    for (const Vector3& p : outline(sample, robot)) write_point(outlines, name, p);
    outlines << '\n';
    for (LegId i = 0; i < robot.num_legs(); ++i) {
      write_point(legs, name, sample.X_WB * robot.legs[i].X_BH.p);
      write_point(legs, name, sample.p_WF[i]);
      legs << '\n';
    }
    names << fmt::format("{},{:.3f},{:.4f},{:.4f},{:.4f}\n", name, sample.time, sample.X_WB.p.x(),
                         sample.X_WB.p.y(), roll_pitch_yaw(sample.X_WB.R).z());
  }
}

struct Bounds {
  Vector2 least, greatest;
};

Bounds bounds(const Recording& recording) {
  Vector2 least = recording.samples().front().X_WB.p.head<2>(), greatest = least;
  for (const Recording::Sample& sample : recording.samples())
    for (const Vector3& p : sample.p_WF) {
      least = least.cwiseMin(p.head<2>());
      greatest = greatest.cwiseMax(p.head<2>());
    }
  return {least - Vector2::Constant(0.15), greatest + Vector2::Constant(0.15)};
}

void write_terrain(figures::StagedFiles& files, const std::string& name,
                   const sim3d::Terrain& terrain, const Bounds& shown) {
  std::ofstream file = files.create(name);
  file << "x_min_m,x_max_m,y_min_m,y_max_m,height_m\n";
  const double cell = terrain.spec().cell;
  const int last_x = terrain.cell_index(shown.greatest.x());
  const int last_y = terrain.cell_index(shown.greatest.y());
  for (int i = terrain.cell_index(shown.least.x()); i <= last_x; ++i)
    for (int j = terrain.cell_index(shown.least.y()); j <= last_y; ++j)
      file << fmt::format("{:.3f},{:.3f},{:.3f},{:.3f},{:.4f}\n", i * cell, (i + 1) * cell,
                          j * cell, (j + 1) * cell, terrain.level(i, j));
}

bool is_rough(const SnapshotFigure& figure) {
  return figure.terrain != nullptr && figure.terrain->spec().height > 0.0;
}

// The figure's size, from the ground that is shown: a metre is as long across as up.
struct Canvas {
  Bounds shown;
  double panel_width, panel_height;  // [px]
  double width, height;              // with all around [px]
};

Canvas canvas(Bounds shown, bool rough) {
  const Vector2 size = shown.greatest - shown.least;
  const double pixels = std::min(kWidest / size.x(), kHighest / size.y());
  const double widening = std::max(0.0, kNarrowest / pixels - size.x());
  shown.least.x() -= 0.5 * widening;
  shown.greatest.x() += 0.5 * widening;
  const double width = pixels * (size.x() + widening), height = pixels * size.y();
  return {shown, width, height, kLeft + width + (rough ? 110.0 : 25.0), kTop + height + kBottom};
}

std::string variables(const SnapshotFigure& figure, const Canvas& c) {
  return fmt::format("stem = {}\nheadline = {}\nsubtitle = {}\n", figures::quoted(figure.stem),
                     figures::quoted(figure.headline), figures::quoted(figure.subtitle)) +
         fmt::format("left = {:.4f}; pixel = {:.6f}\n", kLeft / c.width, 1.0 / c.height) +
         fmt::format("set lmargin at screen left; set rmargin at screen {:.4f}\n",
                     (kLeft + c.panel_width) / c.width) +
         fmt::format("set bmargin at screen {:.4f}; set tmargin at screen {:.4f}\n",
                     kBottom / c.height, (kBottom + c.panel_height) / c.height) +
         fmt::format("set xrange [{:.3f}:{:.3f}]; set yrange [{:.3f}:{:.3f}]\n", c.shown.least.x(),
                     c.shown.greatest.x(), c.shown.least.y(), c.shown.greatest.y()) +
         fmt::format("rough = {}; level_max = {}\n", is_rough(figure) ? 1 : 0,
                     is_rough(figure) ? figure.terrain->spec().height : 1.0);
}

constexpr const char* kScript = R"(
set label 1 headline at screen left, 1 - 34*pixel left noenhanced font sized("", 15) \
    textcolor rgb ink
set label 2 subtitle at screen left, 1 - 68*pixel left noenhanced font sized("", 10.5) \
    textcolor rgb grey
small = sized("", 9.5)
set key at graph 1, screen 1 - 88*pixel right top horizontal samplen 1.4 font small
set label 3 "From above [m]" at graph 0, screen 1 - 104*pixel left textcolor rgb ink
set style fill transparent solid 0.85 noborder
set palette defined (0 "#f7f4ef", 1 "#b3a184")
set cbrange [0:level_max]
set cblabel "height of the ground [m]" textcolor rgb ink
set colorbox user origin graph 1.012, graph 0 size 0.012, graph 0.5 noborder

terrain = rough ? stem."-terrain.csv" : ""
ground = rough ? "terrain using (($1+$2)/2):(($3+$4)/2):1:2:3:4:5 with boxxyerror fs solid 1 \
    border lc rgb '#ffffff' lc palette notitle, " : ""
plot @ground stem."-steps.csv" using 6:7 with points pt 7 ps 0.4 lc rgb "#80".ink[2:7] \
         title "footholds", \
     stem."-body.csv" using 8:9 with lines lw 7 lc rgb "#c3ccd4" title "commanded", \
     stem."-legs.csv" using 2:3 with lines lw 1.6 lc rgb left_side notitle, \
     stem."-legs.csv" using 2:3 every 2::1 with points pt 7 ps 0.6 lc rgb left_side notitle, \
     stem."-outlines.csv" using 2:3 with filledcurves closed fs transparent solid 0.28 \
         lc rgb left_side notitle, \
     stem."-outlines.csv" using 2:3 with lines lw 1.6 lc rgb left_side title "the robot", \
     stem."-body.csv" using 2:3 with lines lw 1.8 lc rgb accent title "walked", \
     stem."-snapshots.csv" using 3:4:(0.3*cos($5)):(0.3*sin($5)) with vectors filled \
         size screen 0.007, 22 lw 1.6 lc rgb ink notitle, \
     stem."-snapshots.csv" using ($3-0.18*cos($5)-0.08*sin($5)):($4-0.18*sin($5)+0.08*cos($5)):1 with labels \
         font sized(":Bold", 14) textcolor rgb ink notitle
)";

}  // namespace

void draw_snapshots(figures::StagedFiles& files, const SnapshotFigure& figure,
                    const Recording& recording, const RobotModel& robot) {
  std::ofstream body = files.create(figure.stem + "-body.csv");
  recording.write_body(body);
  body.close();
  std::ofstream steps = files.create(figure.stem + "-steps.csv");
  recording.write_steps(steps, robot);
  steps.close();
  write_snapshots(files, figure, recording, robot);
  const Canvas drawn = canvas(bounds(recording), is_rough(figure));
  if (is_rough(figure))
    write_terrain(files, figure.stem + "-terrain.csv", *figure.terrain, drawn.shown);

  std::ofstream script = files.create(figure.stem + ".gp");
  script << figures::figure_preamble(figure.stem + ".svg",
                                     static_cast<int>(std::lround(drawn.width)),
                                     static_cast<int>(std::lround(drawn.height)))
         << variables(figure, drawn) << "set macros\n"
         << kScript;
  script.close();

  figures::draw_figure(files, figure.stem);
}

}  // namespace hexagait::recording

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <hexagait/figures/gnuplot.hpp>
#include <hexagait/recording/genghis_figure.hpp>
#include <ostream>

namespace hexagait::recording {
namespace {

using sim2d::GenghisModel;
using sim2d::Side;
using Sample = GenghisRecording::Sample;

constexpr int kWidth = 1500;      // [px]
constexpr int kHead = 120;        // above the side view [px]
constexpr int kBelow = 535;       // for the panels below it [px]
constexpr int kTallest = 420;     // side view [px]
constexpr double kLongest = 3.0;  // of it [m]
constexpr double kApart = 0.45;   // from one drawn robot to the next [m]
constexpr double kLeft = 0.05, kRight = 0.985;

// The part of the world that is seen from the side, and how tall it is drawn.
struct View {
  double x_min = 0.0, x_max = 0.0, z_min = 0.0, z_max = 0.0;  ///< [m]
  int height = 0;                                             ///< [px]
};

View side_view(const GenghisRecording& recording) {
  const GenghisModel model;
  const double half = 0.5 * model.body_length + 0.06;
  View view{1e9, -1e9, 0.0, 0.0, 0};
  const double x0 = recording.samples().front().p_WB.x();
  for (const Sample& s : recording.samples()) {
    if (std::abs(s.p_WB.x() - x0) > kLongest - 2.0 * half) continue;
    view.x_min = std::min(view.x_min, s.p_WB.x() - half);
    view.x_max = std::max(view.x_max, s.p_WB.x() + half);
    view.z_max = std::max(view.z_max, s.p_WB.y() + std::abs(0.25 * std::sin(s.pitch)) + 0.08);
    for (const Vector2& foot : s.p_WF) view.z_min = std::min(view.z_min, foot.y());
  }
  view.z_min -= 0.035;

  // A metre is as long up as across.
  const double pixels = kWidth * (kRight - kLeft), tall = view.z_max - view.z_min;
  const double scale = std::min(pixels / (view.x_max - view.x_min), kTallest / tall);
  const double spare = pixels / scale - (view.x_max - view.x_min);
  view.x_min -= 0.5 * spare;
  view.x_max += 0.5 * spare;
  view.height = static_cast<int>(std::lround(scale * tall));
  return view;
}

std::vector<const Sample*> snapshots(const GenghisRecording& recording, const View& view) {
  const double half = 0.5 * GenghisModel{}.body_length;
  std::vector<const Sample*> chosen;
  for (const Sample& s : recording.samples()) {
    const double x = s.p_WB.x();
    if (x - half < view.x_min || x + half > view.x_max) continue;
    if (chosen.empty() || std::abs(x - chosen.back()->p_WB.x()) >= kApart) chosen.push_back(&s);
  }
  return chosen;
}

Vector2 in_world(const Sample& s, const Vector2& p_B) {
  const double c = std::cos(s.pitch), d = std::sin(s.pitch);
  return s.p_WB + Vector2(c * p_B.x() - d * p_B.y(), d * p_B.x() + c * p_B.y());
}

void write_outlines(std::ostream& out, const std::vector<const Sample*>& samples) {
  const GenghisModel m;
  const double x = 0.5 * m.body_length, low = -m.belly, high = m.body_height - m.belly;
  out << "time_s,x_m,z_m\n";
  for (const Sample* s : samples) {
    for (const Vector2& corner : {Vector2(x, high), Vector2(-x, high), Vector2(-x, low + m.bevel),
                                  Vector2(-x + m.bevel, low), Vector2(x - m.bevel, low),
                                  Vector2(x, low + m.bevel), Vector2(x, high)}) {
      const Vector2 p = in_world(*s, corner);
      out << fmt::format("{:.3f},{:.5f},{:.5f}\n", s->time, p.x(), p.y());
    }
    out << '\n';
  }
}

// From the hip to the foot, as the eye sees the leg from the side.
void write_legs(std::ostream& out, const std::vector<const Sample*>& samples) {
  out << "leg,x_m,z_m\n";
  for (const Sample* s : samples)
    for (LegId i = 0; i < sim2d::kGenghisLegs; ++i) {
      const Vector2 hip = in_world(*s, sim2d::hip(GenghisModel{}, i));
      out << fmt::format("{0},{1:.5f},{2:.5f}\n{0},{3:.5f},{4:.5f}\n\n", i, hip.x(), hip.y(),
                         s->p_WF[i].x(), s->p_WF[i].y());
    }
}

void write_ground(std::ostream& out, const sim2d::Terrain2d& terrain, Side side, const View& view) {
  out << "x_m,z_m\n";
  for (const Vector2& p : terrain.profile(side, view.x_min, view.x_max))
    out << fmt::format("{:.5f},{:.5f}\n", p.x(), p.y());
}

// What the script below is told: files, places, ranges and texts.
std::string variables(const figures::Figure& figure, const GenghisRecording& recording,
                      const View& view) {
  const double height = kHead + view.height + kBelow;
  const double side_top = 1.0 - kHead / height;
  const double side_bottom = side_top - view.height / height;
  std::string text;
  for (const char* name : {"body", "steps", "gait", "outlines", "legs", "left", "right"})
    text += fmt::format("{} = {}\n", name, figures::quoted(figure.stem + "-" + name + ".csv"));
  const auto panel = [&](const char* name, double left, double right, double bottom, double top) {
    text += fmt::format(
        "{0}_top = {4}\n{0}_panel = \"set lmargin at screen {1}; set rmargin at screen {2}; set "
        "bmargin at screen {3}; set tmargin at screen {4}\"\n",
        name, left, right, bottom, top);
  };
  panel("side", kLeft, kRight, side_bottom, side_top);
  panel("gait", kLeft, 0.58, 70 / height, 440 / height);
  panel("height", 0.65, kRight, 285 / height, 440 / height);
  panel("pitch", 0.65, kRight, 70 / height, 215 / height);
  return text +
         fmt::format("x_min = {:.4f}; x_max = {:.4f}; z_min = {:.4f}; z_max = {:.4f}\n", view.x_min,
                     view.x_max, view.z_min, view.z_max) +
         fmt::format("t_max = {:.3f}; px_top = {:.5f}\nset macros\n",
                     recording.samples().back().time, 1.0 / height) +
         fmt::format("headline = {}\nsubtitle = {}\n", figures::quoted(figure.headline),
                     figures::quoted(figure.subtitle));
}

constexpr const char* kScript = R"(
set multiplot
small = sized("", 9)
set label 1 headline at screen 0.05, 1 - 36*px_top left noenhanced font sized("", 15) textcolor rgb ink
set label 2 subtitle at screen 0.05, 1 - 68*px_top left noenhanced font sized("", 10.5) textcolor rgb grey

# a: from the side. Right legs and their ground lie behind the body, left ones before it.
@side_panel
set label 3 "{/:Bold a}   From the side [m]" at graph 0, graph 1 offset 0, 0.9 left textcolor rgb ink
set xrange [x_min:x_max]; set yrange [z_min:z_max]
set ytics 0.1
set grid noxtics noytics
set key at graph 1, screen side_top + 14*px_top right top horizontal samplen 1 width -1 font small
is_left(k) = int(k) % 2 == 0
plot right using 1:2:(z_min) with filledcurves fs solid 1 lc rgb "#e9dfc6" notitle, \
     right using 1:2 with lines lw 1 lc rgb right_side notitle, \
     legs using 2:(is_left($1) ? NaN : $3) with lines lw 3 lc rgb right_side notitle, \
     legs using 2:(is_left($1) ? NaN : $3) every 2::1 with points pt 7 ps 0.8 lc rgb right_side notitle, \
     outlines using 2:3 with filledcurves closed fs solid 1 lc rgb "#dfe5ea" notitle, \
     outlines using 2:3 with lines lw 1.4 lc rgb ink notitle, \
     left using 1:2:(z_min) with filledcurves fs transparent solid 0.55 lc rgb "#c3d3df" notitle, \
     left using 1:2 with lines lw 1 lc rgb left_side notitle, \
     legs using 2:(is_left($1) ? $3 : NaN) with lines lw 3 lc rgb left_side notitle, \
     legs using 2:(is_left($1) ? $3 : NaN) every 2::1 with points pt 7 ps 0.8 lc rgb left_side notitle, \
     body using 2:3 with lines lw 1.6 lc rgb accent title "middle of the body", \
     steps using 6:($3 <  3 ? $7 : NaN) with points pt 6 ps 0.6 lw 1.4 lc rgb left_side title "left footfalls", \
     steps using 6:($3 >= 3 ? $7 : NaN) with points pt 6 ps 0.6 lw 1.4 lc rgb right_side title "right footfalls"
unset label 1; unset label 2

# b: the gait diagram; below it the type of the gait state, and where the CCN was adjusted
@gait_panel
set label 3 "{/:Bold b}   Legs in the air"
set xlabel "time [s]" offset 0, 0.5
legend_x = 0.50; legend_step = 0.05
@gait_legend
set label 15 "|" at graph 0.78, graph 1 offset 0, 0.9 left textcolor rgb accent font sized(":Bold", 10.5)
set label 25 "CCN adjusted" at graph 0.795, graph 1 offset 0, 0.9 left textcolor rgb ink font small
set xrange [0:t_max]; set yrange [6.75:-0.65]
set ytics ("LF" 0, "LM" 1, "LR" 2, "RF" 3, "RM" 4, "RR" 5, "state" 6) scale 0
set grid xtics noytics
set style fill solid 1 noborder
unset key
plot steps using 4:($3 <  3 ? $3 : NaN):4:5:($3-0.32):($3+0.32) with boxxyerror lc rgb left_side, \
     steps using 4:($3 >= 3 ? $3 : NaN):4:5:($3-0.32):($3+0.32) with boxxyerror lc rgb right_side, \
     gait using 1:(6):1:2:(5.68):(6.16):(type_shade($5)) with boxxyerror lc rgb variable, \
     gait using 1:($3 == 3 ? NaN : 6.28):(0):(0.3) with vectors nohead lw 1.3 lc rgb accent
do for [k=10:15] { unset label k }
do for [k=20:25] { unset label k }

# c, d: the body
@height_panel
set label 3 "{/:Bold c}   Height of the hips [m]"
unset ytics; set ytics nomirror scale 0.5 textcolor rgb ink autofreq
set grid ytics
set yrange [0:*]; set offsets 0, 0, 0.02, 0
set format x ""; set xlabel ""
plot body using 1:3 with lines lw 1.6 lc rgb accent

@pitch_panel
set label 3 "{/:Bold d}   Pitch, nose up [°]"
set yrange [*<-1:1<*]; set offsets 0, 0, 0.2, 0.2
set format x "%g"
set xlabel "time [s]" offset 0, 0.5
plot body using 1:(0) with lines lw 0.8 lc rgb grey, body using 1:4 with lines lw 1.4 lc rgb ink
unset multiplot
)";

}  // namespace

void draw_genghis(figures::StagedFiles& files, const figures::Figure& figure,
                  const GenghisRecording& recording, const sim2d::Terrain2d& terrain) {
  const View view = side_view(recording);
  const std::vector<const Sample*> shown = snapshots(recording, view);
  const auto table = [&](const char* name, const auto& write) {
    std::ofstream file = files.create(figure.stem + "-" + name + ".csv");
    write(file);
    file.close();
  };
  table("body", [&](std::ostream& out) { recording.write_body(out); });
  table("steps", [&](std::ostream& out) { recording.write_steps(out); });
  table("gait", [&](std::ostream& out) { recording.write_gait(out); });
  table("outlines", [&](std::ostream& out) { write_outlines(out, shown); });
  table("legs", [&](std::ostream& out) { write_legs(out, shown); });
  table("left", [&](std::ostream& out) { write_ground(out, terrain, Side::left, view); });
  table("right", [&](std::ostream& out) { write_ground(out, terrain, Side::right, view); });

  figures::draw_figure(files, figure, kWidth, kHead + view.height + kBelow,
                       variables(figure, recording, view) + kScript);
}

}  // namespace hexagait::recording

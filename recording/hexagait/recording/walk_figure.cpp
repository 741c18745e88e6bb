// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <hexagait/figures/gnuplot.hpp>
#include <hexagait/recording/walk_figure.hpp>
#include <ostream>

namespace hexagait::recording {
namespace {

constexpr int kWidth = 1500, kHeight = 1000;  // [px]

// A panel's place in the figure, in shares of its size.
struct Panel {
  double left, right, bottom, top;
};

// Where the four panels stand. A long path lies across the top, any other one stands on the left.
struct Layout {
  Panel path, gait, height, tilt;
};
constexpr Layout kLong = {{0.05, 0.985, 0.57, 0.85},
                          {0.05, 0.475, 0.07, 0.475},
                          {0.55, 0.985, 0.32, 0.475},
                          {0.55, 0.985, 0.07, 0.245}};
constexpr Layout kSquare = {{0.05, 0.475, 0.07, 0.86},
                            {0.55, 0.985, 0.555, 0.86},
                            {0.55, 0.985, 0.325, 0.475},
                            {0.55, 0.985, 0.07, 0.245}};

// The part of the ground that is drawn [m].
struct Box {
  Vector2 least = Vector2::Constant(1e9), greatest = Vector2::Constant(-1e9);
  void include(const Vector2& p) {
    least = least.cwiseMin(p);
    greatest = greatest.cwiseMax(p);
  }
  [[nodiscard]] Vector2 size() const { return greatest - least; }
};

Box drawn_ground(const Recording& recording) {
  Box box;
  for (const Recording::Sample& sample : recording.samples()) {
    box.include(sample.X_WB.p.head<2>());
    box.include(sample.ideal.shift);
  }
  for (const Recording::Step& step : recording.steps())
    if (!std::isnan(step.land)) box.include(step.p_WF.head<2>());
  const Vector2 margin = Vector2::Constant(0.04 * box.size().maxCoeff() + 0.1);
  box.least -= margin;
  box.greatest += margin;
  return box;
}

// Widened about its middle to the panel's proportions: a metre is as long across as up.
Box fitted(const Box& box, const Panel& panel) {
  const Vector2 pixels(kWidth * (panel.right - panel.left), kHeight * (panel.top - panel.bottom));
  const double metres_per_pixel = box.size().cwiseQuotient(pixels).maxCoeff();
  const Vector2 middle = 0.5 * (box.least + box.greatest);
  return {middle - 0.5 * metres_per_pixel * pixels, middle + 0.5 * metres_per_pixel * pixels};
}

std::string place(const char* name, const Panel& panel) {
  return fmt::format(
      "{0}_top = {4}\n{0}_panel = \"set lmargin at screen {1}; set rmargin at screen {2}; "
      "set bmargin at screen {3}; set tmargin at screen {4}\"\n",
      name, panel.left, panel.right, panel.bottom, panel.top);
}

// What the script below is told: files, places, ranges and texts.
std::string variables(const figures::Figure& figure, const Recording& recording,
                      const RobotModel& robot) {
  const Box ground = drawn_ground(recording);
  const bool is_long = ground.size().x() > 1.6 * ground.size().y();
  const Layout& layout = is_long ? kLong : kSquare;
  const Box shown = fitted(ground, layout.path);
  const auto quote = [&](const char* ending) { return figures::quoted(figure.stem + ending); };
  return fmt::format("body = {}; steps = {}; gait = {}\n", quote("-body.csv"), quote("-steps.csv"),
                     quote("-gait.csv")) +
         place("path", layout.path) + place("gait", layout.gait) + place("height", layout.height) +
         place("tilt", layout.tilt) +
         fmt::format("x_min = {:.4f}; x_max = {:.4f}; y_min = {:.4f}; y_max = {:.4f}\n",
                     shown.least.x(), shown.greatest.x(), shown.least.y(), shown.greatest.y()) +
         fmt::format("t_max = {:.3f}; legs = {}\n", recording.samples().back().time,
                     robot.num_legs()) +
         fmt::format("set macros\nrow_names = '({})'\n", row_names(robot)) +
         fmt::format("headline = {}\nsubtitle = {}\n", figures::quoted(figure.headline),
                     figures::quoted(figure.subtitle));
}

constexpr const char* kScript = R"(
set multiplot
small = sized("", 9)
set label 1 headline at screen 0.05, 0.965 left noenhanced font sized("", 15) textcolor rgb ink
set label 2 subtitle at screen 0.05, 0.925 left noenhanced font sized("", 10.5) textcolor rgb grey

# a: the path from above; arrows show where the body faces
@path_panel
set label 3 "{/:Bold a}   Path from above [m]" at graph 0, graph 1 offset 0, 0.9 left textcolor rgb ink
set xrange [x_min:x_max]; set yrange [y_min:y_max]
set key at graph 1, screen path_top + 0.025 right top horizontal samplen 1 width -1 font small
across = 0.04*(x_max - x_min); up = 0.1*(y_max - y_min)
arrow = across < up ? across : up
arrows = 8.0
set style arrow 1 head filled size screen 0.007, 22 lw 1.3 lc rgb ink
plot steps using 6:($3 <  legs/2 ? $7 : NaN) with points pt 7 ps 0.55 lc rgb "#60".left_side[2:7] \
         title "left feet", \
     steps using 6:($3 >= legs/2 ? $7 : NaN) with points pt 7 ps 0.55 lc rgb "#60".right_side[2:7] \
         title "right feet", \
     body using 8:9 with lines lw 6 lc rgb "#c3ccd4" title "commanded", \
     body using 2:3 with lines lw 1.8 lc rgb accent title "walked", \
     body using 2:3:(arrow*cos($7*pi/180)):(arrow*sin($7*pi/180)) every ceil(50*t_max/arrows) \
         with vectors as 1 notitle
unset label 1; unset label 2

# b: the gait diagram; below it the type of the gait state, and where the CCN was adjusted
@gait_panel
set label 3 "{/:Bold b}   Legs in the air"
legend_x = 0.50; legend_step = 0.05
@gait_legend
set label 15 "|" at graph 0.78, graph 1 offset 0, 0.9 left textcolor rgb accent font sized(":Bold", 10.5)
set label 25 "CCN adjusted" at graph 0.795, graph 1 offset 0, 0.9 left textcolor rgb ink font small
set xrange [0:t_max]; set yrange [legs+0.75:-0.65]
set ytics @row_names scale 0
set grid noytics
set style fill solid 1 noborder
unset key
plot steps using 4:($3 <  legs/2 ? $3 : NaN):4:5:($3-0.32):($3+0.32) with boxxyerror \
         lc rgb left_side, \
     steps using 4:($3 >= legs/2 ? $3 : NaN):4:5:($3-0.32):($3+0.32) with boxxyerror \
         lc rgb right_side, \
     gait using 1:(legs):1:2:(legs-0.32):(legs+0.16):(type_shade($5)) with boxxyerror \
         lc rgb variable, \
     gait using 1:($3 == legs/2 ? NaN : legs+0.28):(0):(0.3) with vectors nohead lw 1.3 \
         lc rgb accent
do for [k=10:15] { unset label k }
do for [k=20:25] { unset label k }

# c: the body
@height_panel
set label 3 "{/:Bold c}   Height [m]"
unset ytics; set ytics nomirror scale 0.5 textcolor rgb ink 0.1
set grid ytics
set yrange [0:*]; set offsets 0, 0, 0.04, 0
set format x ""
set key at graph 1, screen height_top + 0.025 right top horizontal samplen 1.2 width 0 font small
plot body using 1:12 with filledcurves y1=0 fs solid 0.6 lc rgb earth title "ground below", \
     body using 1:4 with lines lw 1.6 lc rgb ink title "body"

@tilt_panel
set label 3 "{/:Bold d}   Tilt of the body [°]"
set key at graph 1, screen tilt_top + 0.025
set yrange [*<-1:1<*]; set offsets 0, 0, 0.2, 0.2
set ytics autofreq
set format x "%g"
set xlabel "time [s]" offset 0, 0.5
plot body using 1:(0) with lines lw 0.8 lc rgb grey notitle, \
     body using 1:5 with lines lw 1.4 lc rgb left_side title "roll", \
     body using 1:6 with lines lw 1.4 lc rgb right_side title "pitch"
unset multiplot
)";

}  // namespace

void draw_walk(figures::StagedFiles& files, const figures::Figure& figure,
               const Recording& recording, const RobotModel& robot) {
  std::ofstream body = files.create(figure.stem + "-body.csv");
  recording.write_body(body);
  body.close();
  std::ofstream steps = files.create(figure.stem + "-steps.csv");
  recording.write_steps(steps, robot);
  steps.close();
  std::ofstream gait = files.create(figure.stem + "-gait.csv");
  recording.write_gait(gait);
  gait.close();
  figures::draw_figure(files, figure, kWidth, kHeight,
                       variables(figure, recording, robot) + kScript);
}

}  // namespace hexagait::recording

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <hexagait/figures/gnuplot.hpp>
#include <hexagait/recording/action_figure.hpp>
#include <ostream>

namespace hexagait::recording {
namespace {

constexpr int kWidth = 1500, kHeight = 1000;  // [px]
constexpr double kInterval = 0.02;            // between samples [s]

// A panel's place in the figure, in shares of its size.
struct Panel {
  double left, right, bottom, top;
};
constexpr Panel kAbove = {0.05, 0.475, 0.42, 0.86}, kSide = {0.55, 0.985, 0.42, 0.86},
                kMargin = {0.05, 0.985, 0.07, 0.31};

// A part of a plane [m].
struct Box {
  Vector2 least = Vector2::Constant(1e9), greatest = Vector2::Constant(-1e9);
  void include(const Vector2& p) {
    least = least.cwiseMin(p);
    greatest = greatest.cwiseMax(p);
  }
};

// Of the coordinates k and l of everything that is drawn, with room around it, and widened to the
// panel's proportions: a metre is as long across as up.
Box shown(const ActionRecording& recording, int k, int l, const Panel& panel) {
  Box box;
  const auto include = [&](const Vector3& p) { box.include({p[k], p[l]}); };
  for (const ActionRecording::Sample& sample : recording.samples()) {
    include(sample.base);
    for (const Vector3& foot : sample.feet) include(foot);
  }
  const Vector2 pixels(kWidth * (panel.right - panel.left), kHeight * (panel.top - panel.bottom));
  const Vector2 room = Vector2::Constant(0.05);
  const Vector2 size = box.greatest - box.least + 2.0 * room;
  const Vector2 half = 0.5 * size.cwiseQuotient(pixels).maxCoeff() * pixels;
  const Vector2 middle = 0.5 * (box.least + box.greatest);
  return {middle - half, middle + half};
}

std::string place(const char* name, const Panel& panel) {
  return fmt::format(
      "{0}_top = {4}\n{0}_panel = \"set lmargin at screen {1}; set rmargin at screen {2}; "
      "set bmargin at screen {3}; set tmargin at screen {4}\"\n",
      name, panel.left, panel.right, panel.bottom, panel.top);
}

std::string range(const char* name, const Box& box) {
  return fmt::format("{0}_range = \"set xrange [{1:.4f}:{2:.4f}]; set yrange [{3:.4f}:{4:.4f}]\"\n",
                     name, box.least.x(), box.greatest.x(), box.least.y(), box.greatest.y());
}

std::string margin_range(const ActionRecording& recording) {
  double least = 0.0, greatest = 0.04;
  for (const ActionRecording::Sample& sample : recording.samples()) {
    if (!std::isfinite(sample.margin)) continue;
    least = std::min(least, 1.1 * sample.margin);
    greatest = std::max(greatest, 1.25 * sample.margin);
  }
  return fmt::format("bottom = {:.4f}; top = {:.4f}\n", least, greatest);
}

// Names of the legs where their feet are at the beginning.
std::string leg_names(const ActionRecording& recording, const RobotModel& robot) {
  std::string text = "legs_above = \"";
  for (LegId i = 0; i < robot.num_legs(); ++i) {
    const Vector3& p = recording.samples().front().feet[i];
    text += fmt::format(
        "set label {} '{}' at {:.4f}, {:.4f} center offset 0, {}0.8 textcolor rgb "
        "grey font small; ",
        100 + i, robot.legs[i].name, p.x(), p.y(), i % 2 == 0 ? "" : "-");
  }
  return text + "\"\n";
}

// What the script below is told: files, places, ranges and texts.
std::string variables(const figures::Figure& figure, const ActionRecording& recording,
                      const RobotModel& robot) {
  const auto quote = [&](const char* ending) { return figures::quoted(figure.stem + ending); };
  return fmt::format("base = {}; feet = {}; steps = {}\n", quote("-base.csv"), quote("-feet.csv"),
                     quote("-steps.csv")) +
         place("above", kAbove) + place("side", kSide) + place("margin", kMargin) +
         range("above", shown(recording, 0, 1, kAbove)) +
         range("side", shown(recording, 0, 2, kSide)) +
         fmt::format("t_max = {:.3f}; num_steps = {}\nset macros\n",
                     recording.samples().back().time, recording.steps().size()) +
         margin_range(recording) + leg_names(recording, robot) +
         fmt::format("headline = {}\nsubtitle = {}\n", figures::quoted(figure.headline),
                     figures::quoted(figure.subtitle));
}

constexpr const char* kScript = R"(
set datafile columnheaders
set multiplot
small = sized("", 9)
set label 1 headline at screen 0.05, 0.965 left noenhanced font sized("", 15) textcolor rgb ink
set label 2 subtitle at screen 0.05, 0.925 left noenhanced font sized("", 10.5) textcolor rgb grey

# a: from above. Lines are the ways of the feet in the air, points where they stood.
@above_panel
set label 3 "{/:Bold a}   From above [m]" at graph 0, graph 1 offset 0, 0.9 left textcolor rgb ink
@above_range
@legs_above
set key at graph 1, screen above_top + 0.025 right top horizontal samplen 1 width -1 font small
is_left(leg) = int(leg) % 2 == 0
plot feet using 3:(is_left($1) ? $4 : NaN) with lines lw 1.4 lc rgb left_side title "left feet", \
     feet using 3:(is_left($1) ? NaN : $4) with lines lw 1.4 lc rgb right_side title "right feet", \
     feet using 3:($6 == 1 ? $4 : NaN) with points pt 7 ps 0.35 lc rgb grey title "on the ground", \
     base using 2:3 with lines lw 2 lc rgb accent title "base", \
     base using 2:3 every ::0::0 with points pt 6 ps 1 lw 1.6 lc rgb accent notitle
unset label 1; unset label 2
do for [k=100:107] { unset label k }

# b: from the side
@side_panel
set label 3 "{/:Bold b}   From the side [m]"
@side_range
unset key
plot feet using 3:(is_left($1) ? NaN : $5) with lines lw 1.4 lc rgb right_side, \
     feet using 3:(is_left($1) ? $5 : NaN) with lines lw 1.4 lc rgb left_side, \
     feet using 3:($6 == 1 ? $5 : NaN) with points pt 7 ps 0.35 lc rgb grey, \
     base using 2:4 with lines lw 2 lc rgb accent, \
     base using 2:4 every ::0::0 with points pt 6 ps 1 lw 1.6 lc rgb accent

# c: the margin, in alternating shades the steps
@margin_panel
set label 3 "{/:Bold c}   Stability margin [m], and the steps"
set xrange [0:t_max]
set grid noxtics
set xlabel "time [s]" offset 0, 0.5
set yrange [bottom:top]
every_nth = ceil(num_steps/40.0)
set style fill solid 1 noborder
plot steps using ($2):(top):($2):($3):(bottom):(top) with boxxyerror lc rgb "#ffffff" notitle, \
     steps using (int($1) % 2 == 0 ? $2 : NaN):(top):($2):($3):(bottom):(top) with boxxyerror \
         lc rgb "#eef1f4" notitle, \
     steps using (0.5*($2 + $3)):(0.93*top):(int($1) % every_nth == 0 ? sprintf("%d", int($1)) : "") \
         with labels font small textcolor rgb grey notitle, \
     base using 1:(0) with lines lw 0.8 lc rgb grey notitle, \
     base using 1:5 with lines lw 1.6 lc rgb ink notitle
unset multiplot
)";

void write_base(std::ostream& out, const ActionRecording& recording) {
  out << "time_s,x_m,y_m,z_m,margin_m\n";
  for (const ActionRecording::Sample& s : recording.samples()) {
    const std::string margin = std::isfinite(s.margin) ? fmt::format("{:.5f}", s.margin) : "";
    out << fmt::format("{:.4f},{:.5f},{:.5f},{:.5f},{}\n", s.time, s.base.x(), s.base.y(),
                       s.base.z(), margin);
  }
}

// Leg by leg, with a blank line between them: a line of its own each.
void write_feet(std::ostream& out, const ActionRecording& recording, const RobotModel& robot) {
  out << "leg,time_s,x_m,y_m,z_m,support\n";
  for (LegId i = 0; i < robot.num_legs(); ++i) {
    for (const ActionRecording::Sample& s : recording.samples())
      out << fmt::format("{},{:.4f},{:.5f},{:.5f},{:.5f},{}\n", i, s.time, s.feet[i].x(),
                         s.feet[i].y(), s.feet[i].z(), s.support.contains(i) ? 1 : 0);
    out << "\n";
  }
}

void write_steps(std::ostream& out, const ActionRecording& recording) {
  out << "step,from_s,to_s\n";
  for (const ActionRecording::Step& step : recording.steps())
    out << fmt::format("{},{:.4f},{:.4f}\n", step.number, step.from, step.to);
}

}  // namespace

void ActionRecording::observe(const ActionRecord& record) {
  LegArray<Vector3> feet(record.legs.size());
  for (LegId i = 0; i < feet.size(); ++i) feet[i] = record.state.X_OB * record.legs[i].p_BF;
  add(record, record.state.X_OB.p, feet);
}

void ActionRecording::observe(const ActionRecord& record, const GroundTruth& truth) {
  LegArray<Vector3> feet(truth.feet.size());
  for (LegId i = 0; i < feet.size(); ++i) feet[i] = truth.feet[i].p_WF;
  add(record, truth.X_WB.p, feet);
}

void ActionRecording::add(const ActionRecord& record, const Vector3& base,
                          const LegArray<Vector3>& feet) {
  if (start_ < 0.0) start_ = record.state.time;
  const double time = record.state.time - start_;
  const int step = record.feedback.step;
  if (step > 0 && (steps_.empty() || steps_.back().number != step))
    steps_.push_back({step, time, time});
  if (step > 0) steps_.back().to = time;
  if (!samples_.empty() && time < samples_.back().time + kInterval - 1e-9) return;
  samples_.push_back({time, base, feet, record.margin, record.desired.support});
}

void draw_action(figures::StagedFiles& files, const figures::Figure& figure,
                 const ActionRecording& recording, const RobotModel& robot) {
  const auto table = [&](const char* name, const auto& write) {
    std::ofstream file = files.create(figure.stem + "-" + name + ".csv");
    write(file);
    file.close();
  };
  table("base", [&](std::ostream& out) { write_base(out, recording); });
  table("feet", [&](std::ostream& out) { write_feet(out, recording, robot); });
  table("steps", [&](std::ostream& out) { write_steps(out, recording); });

  figures::draw_figure(files, figure, kWidth, kHeight,
                       variables(figure, recording, robot) + kScript);
}

}  // namespace hexagait::recording

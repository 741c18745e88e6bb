// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// All wave gaits in one walk ([PC04] 3.2): the duty factor goes from 1/2 (tripod) up to 5/6 (slow
// wave) and back while the robot walks straight on. The gait diagram of the whole walk, and of two
// periods at each duty factor on the way up; what is measured against what was asked for.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <hexagait/figures/gnuplot.hpp>
#include <hexagait/pc04/judges.hpp>
#include <hexagait/pc04/pc04.hpp>
#include <hexagait/recording/recording.hpp>

namespace hexagait::experiments {
namespace {

using heading_control::Heading;

constexpr double kHold = 18.0;     // time at each duty factor [s]
constexpr double kJudged = 10.51;  // of that, the last part is judged: two periods at 5/6 [s]

using Segment = WaveSegment;

std::vector<Segment> segments() {
  std::vector<Segment> all = {{1.0 / 2.0, "1/2"}, {5.0 / 8.0, "5/8"}, {2.0 / 3.0, "2/3"},
                              {3.0 / 4.0, "3/4"}, {5.0 / 6.0, "5/6"}, {3.0 / 4.0, "3/4"},
                              {2.0 / 3.0, "2/3"}, {5.0 / 8.0, "5/8"}, {1.0 / 2.0, "1/2"}};
  for (std::size_t k = 0; k < all.size(); ++k) {
    all[k].from = kHold * static_cast<double>(k);
    all[k].to = all[k].from + kHold;
  }
  return all;
}

walk::Schedule schedule(const std::vector<Segment>& segments) {
  walk::Schedule commands;
  for (const Segment& segment : segments)
    commands.push_back({segment.from, Heading::straight(0.0), segment.duty_factor});
  return commands;
}

// Where in the period leg i of six lifts after the right rear one, (gait 5): each side from the
// rear forwards, one step time apart; the sides half a period apart.
double due_phase(LegId leg, double duty_factor) {
  const double side = leg % 2 == 1 ? 0.0 : 0.5;
  const int pairs_behind = 2 - leg / 2;
  return side + pairs_behind * (1.0 - duty_factor);
}

// Between −1/2 and 1/2.
double wrapped(double phase) { return phase - std::round(phase); }

Vector2 place_at(const recording::Recording& recording, double time) {
  const auto& samples = recording.samples();
  const auto it = std::ranges::lower_bound(samples, time, {}, &recording::Recording::Sample::time);
  return (it == samples.end() ? samples.back() : *it).X_WB.p.head<2>();
}

// Speed if each foot sweeps the whole stroke S: while m = n (1 − β) legs of n are in the air,
// v = S m / ((n − m) T).
double speed_by_law(const Segment& segment) {
  const double stroke = footstep_gen::StepParams{}.stroke;
  const double beta = segment.duty_factor;
  return segment.step_time > 0.0 ? stroke * (1.0 - beta) / (beta * segment.step_time) : 0.0;
}

void measure(Segment& segment, const recording::Recording& recording) {
  constexpr LegId kRightRear = 5;
  std::vector<double> lifts;
  for (const recording::Recording::Step& step : recording.steps())
    if (step.leg == kRightRear && segment.to - kJudged <= step.lift && step.lift < segment.to)
      lifts.push_back(step.lift);
  if (lifts.size() < 2) return;
  const double begin = lifts.front(), end = lifts.back();
  segment.judged_from = begin;
  segment.period = (end - begin) / static_cast<double>(lifts.size() - 1);

  int count = 0;
  std::vector<double> air(6, 0.0);
  const double early = 0.25 * segment.period;
  for (const recording::Recording::Step& step : recording.steps()) {
    if (step.lift < begin - early || step.lift >= end - early || std::isnan(step.land)) continue;
    const double phase = (step.lift - begin) / segment.period;
    const double error = wrapped(phase - due_phase(step.leg, segment.duty_factor));
    segment.phase_error = std::max(segment.phase_error, std::abs(error));
    air[static_cast<std::size_t>(step.leg)] += step.land - step.lift;
    segment.step_time += step.land - step.lift;
    ++count;
  }
  segment.step_time /= count;
  for (const double in_air : air) {
    const double duty = 1.0 - in_air / (end - begin);
    segment.least_duty = std::min(segment.least_duty, duty);
    segment.greatest_duty = std::max(segment.greatest_duty, duty);
    segment.mean_duty += duty / 6.0;
  }
  segment.speed = (place_at(recording, end) - place_at(recording, begin)).norm() / (end - begin);
  segment.speed_by_law = speed_by_law(segment);
}

void write_segments(std::ostream& out, const std::vector<Segment>& segments) {
  out << "from_s,to_s,duty_factor,name,measured_mean,measured_least,measured_greatest,period_s,"
         "step_time_s,phase_error,speed_m_s,speed_by_law_m_s\n";
  for (const Segment& s : segments)
    out << fmt::format("{},{},{:.6f},{},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f}\n",
                       s.from, s.to, s.duty_factor, s.name, s.mean_duty, s.least_duty,
                       s.greatest_duty, s.period, s.step_time, s.phase_error, s.speed,
                       s.speed_by_law);
}

// The duty factor of every single step: from its lift to the leg's next.
void write_duty(std::ostream& out, const recording::Recording& recording) {
  out << "leg,time_s,duty_factor\n";
  const auto& steps = recording.steps();
  for (auto step = steps.begin(); step != steps.end(); ++step) {
    const auto next = std::find_if(step + 1, steps.end(), [&](const recording::Recording::Step& s) {
      return s.leg == step->leg;
    });
    if (next == steps.end() || std::isnan(step->land)) continue;
    out << fmt::format("{},{:.4f},{:.4f}\n", step->leg, step->lift,
                       1.0 - (step->land - step->lift) / (next->lift - step->lift));
  }
}

constexpr int kWidth = 1500, kHeight = 1000;  // [px]
constexpr double kWindow = 7.0;               // of the windows below [s]

constexpr const char* kScript = R"gp(
set multiplot
set macros
small = sized("", 9)
set label 1 headline at screen 0.05, 0.965 left noenhanced font sized("", 15) textcolor rgb ink
set label 2 subtitle at screen 0.05, 0.925 left noenhanced font sized("", 10.5) textcolor rgb grey
set lmargin at screen 0.05; set rmargin at screen 0.985

# a: the duty factor, asked for and of every step
set bmargin at screen 0.72; set tmargin at screen 0.86
set label 3 "{/:Bold a}   Duty factor: the share of the time that a leg stands" \
    at graph 0, graph 1 offset 0, 0.9 left textcolor rgb ink
set key at graph 1, screen 0.885 right top horizontal samplen 1.5 width 0 font small
set xrange [0:t_max]; set yrange [0.44:0.89]
set xtics holding
set format x ""
set ytics ("1/2" 0.5, "5/8" 0.625, "3/4" 0.75, "5/6" 0.8333)
plot segments using 1:3:($2-$1):(0) with vectors nohead lw 6 lc rgb "#c3ccd4" title "asked for", \
     duty using 2:3 with points pt 7 ps 0.35 lc rgb accent title "of each step"
unset label 1; unset label 2; unset key

# b: the gait diagram of the whole walk; below it the type of the gait state
set bmargin at screen 0.45; set tmargin at screen 0.66
set label 3 "{/:Bold b}   Legs in the air"
legend_x = 0.865; legend_step = 0.03
@gait_legend
set yrange [legs+0.75:-0.65]
set ytics @row_names scale 0
set grid noytics
set format x "%g"
set xlabel "time [s]" offset 0, 0.6
set style fill solid 1 noborder
set style data boxxyerror
left_bars = '($4-begin):($3 <  legs/2 ? $3 : NaN):($4-begin):($5-begin):($3-0.34):($3+0.34)'
right_bars = '($4-begin):($3 >= legs/2 ? $3 : NaN):($4-begin):($5-begin):($3-0.34):($3+0.34)'
state_bars = '($1-begin):(legs):($1-begin):($2-begin):(legs-0.3):(legs+0.4):(type_shade($5))'
bars = 'plot steps using @left_bars lc rgb left_side, steps using @right_bars lc rgb right_side, ' \
       .'gait using @state_bars lc rgb variable'
begin = 0
@bars
do for [k=10:24] { unset label k }

# c: the end of each duty factor on the way up, all on one scale of time
set bmargin at screen 0.07; set tmargin at screen 0.325
set label 3 "{/:Bold c}   Settled, on the way up; from a lift of the right rear leg on" \
    at graph 0, graph 1 offset 0, 2.9
set xtics 0, 1
set xrange [0:window]
width = (0.935 + 0.014)/words(begins)
do for [k=1:words(begins)] {
  set lmargin at screen 0.05 + (k-1)*width; set rmargin at screen 0.05 + k*width - 0.014
  begin = word(begins, k) + 0.0
  set label 4 word(names, k) at graph 0, graph 1 offset 0, 0.9 left textcolor rgb ink \
      font sized(":Bold", 11)
  set label 5 word(notes, k) at graph 1, graph 1 offset 0, 0.9 right textcolor rgb grey font small
  @bars
  unset label 3
  set ytics ("" 0) scale 0
}
unset multiplot
)gp";

// What the script is told: files, texts, and the windows of panel c.
std::string variables(const std::vector<Segment>& segments, const recording::Recording& recording,
                      const RobotModel& robot) {
  std::string begins, names, notes;
  for (std::size_t k = 0; k <= segments.size() / 2; ++k) {
    const Segment& s = segments[k];
    begins += fmt::format("{:.4f} ", s.judged_from);
    names += fmt::format("\"β = {}\" ", s.name);
    notes += fmt::format("\"measured {:.3f}, {:.3f} m/s\" ", s.mean_duty, s.speed);
  }
  return fmt::format(
      "segments = 'wave_family-segments.csv'; duty = 'wave_family-duty.csv'\n"
      "steps = 'wave_family-steps.csv'; gait = 'wave_family-gait.csv'\n"
      "legs = {}; row_names = '({})'\nt_max = {:.3f}; holding = {}; window = {}\n"
      "begins = '{}'\nnames = '{}'\nnotes = '{}'\nheadline = {}\nsubtitle = {}\n",
      robot.num_legs(), recording::row_names(robot), recording.samples().back().time, kHold,
      kWindow, begins, names, notes,
      figures::quoted(
          "One knob from the tripod gait to the slow wave and back, turned while walking"),
      figures::quoted(
          fmt::format("{} · straight on, flat ground · β changes every {:.0f} s · after [PC04] "
                      "3.2, Fig. 3",
                      robot.name, kHold)));
}

void draw(figures::StagedFiles& files, const std::vector<Segment>& segments,
          const recording::Recording& recording, const RobotModel& robot) {
  const auto table = [&](const char* name, const auto& write) {
    std::ofstream out = files.create(std::string("wave_family-") + name + ".csv");
    write(out);
  };
  table("segments", [&](std::ostream& out) { write_segments(out, segments); });
  table("duty", [&](std::ostream& out) { write_duty(out, recording); });
  table("steps", [&](std::ostream& out) { recording.write_steps(out, robot); });
  table("gait", [&](std::ostream& out) { recording.write_gait(out); });

  std::ofstream script = files.create("wave_family.gp");
  script << figures::figure_preamble("wave_family.svg", kWidth, kHeight)
         << variables(segments, recording, robot) << kScript;
  script.close();
  for (const char* suffix : {".svg", ".pdf", ".png"}) {
    files.expect(std::string("wave_family") + suffix);
    figures::run_gnuplot(files.staging(), "wave_family.gp", std::string("wave_family") + suffix);
  }
}

}  // namespace

Outcome wave_family(const ExperimentContext& context, figures::StagedFiles& files) {
  std::vector<Segment> parts = segments();
  recording::Simulation simulation;
  simulation.gait.stepper = {.stepping = gait_state::Stepping::wave, .duty_factor = 0.5};
  simulation.trial.schedule = schedule(parts);
  simulation.trial.seconds = parts.back().to;

  recording::Recording recording({simulation.terrain, simulation.seed});
  const auto observe = [&](const auto& record, const auto& truth, const auto& referee) {
    recording.observe(record, truth, referee);
    if (context.progress) context.progress(recording.samples().back().time / parts.back().to);
  };
  const walk::Summary summary =
      recording::simulate(*context.robot, simulation, observe, context.stop);
  for (Segment& segment : parts) measure(segment, recording);
  draw(files, parts, recording, *context.robot);
  return {.walk = recording::WalkReport{context.robot->name, simulation, summary},
          .verdicts = judge_wave_family(parts, summary)};
}

}  // namespace hexagait::experiments

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// All wave gaits in one walk ([PC04] 3.2): the duty factor goes from 1/2 (tripod) up to 5/6 (slow
// wave) and back while the robot walks straight on. The gait diagram of the whole walk, and of two
// periods at each duty factor on the way up; what is measured against what was asked for.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <hexagait/figures/csv.hpp>
#include <hexagait/pc04/judges.hpp>
#include <hexagait/pc04/pc04.hpp>
#include <hexagait/pc04/snapshots.hpp>
#include <hexagait/pc04/wave_family.gp.hpp>
#include <limits>

namespace hexagait::experiments {
namespace {

using heading_control::Heading;

constexpr double kHold = 18.0;     // time at each duty factor [s]
constexpr double kJudged = 10.51;  // of that, the last part is judged: two periods at 5/6 [s]

using Segment = WaveSegment;

std::vector<Segment> segments(bool short_form) {
  std::vector<Segment> all = {{1.0 / 2.0, "1/2"}, {5.0 / 8.0, "5/8"}, {2.0 / 3.0, "2/3"},
                              {3.0 / 4.0, "3/4"}, {5.0 / 6.0, "5/6"}, {3.0 / 4.0, "3/4"},
                              {2.0 / 3.0, "2/3"}, {5.0 / 8.0, "5/8"}, {1.0 / 2.0, "1/2"}};
  if (short_form) all = {all[0], all[3], all[0]};
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

// Speed if each foot sweeps the whole stroke S: while m = n (1 − β) legs of n are in the air,
// v = S m / ((n − m) T).
double speed_by_law(const Segment& segment, double stroke) {
  const double beta = segment.duty_factor;
  return segment.step_time > 0.0 ? stroke * (1.0 - beta) / (beta * segment.step_time) : 0.0;
}

void measure(Segment& segment, const recording::Recording& recording, double stroke) {
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
  for (LegId leg = 0; leg < 6; ++leg) {
    // From a leg's first lift to its last, so in whole periods of its own.
    double first = std::numeric_limits<double>::quiet_NaN(), last = first, air = 0.0, in_air = 0.0;
    for (const recording::Recording::Step& step : recording.steps()) {
      if (step.leg != leg || step.lift < segment.to - kJudged || step.lift >= segment.to) continue;
      const double phase = (step.lift - begin) / segment.period;
      const double error = wrapped(phase - due_phase(leg, segment.duty_factor));
      segment.phase_error = std::max(segment.phase_error, std::abs(error));
      if (std::isnan(first)) first = step.lift;
      last = step.lift;
      air += in_air;
      if (std::isnan(step.land)) continue;
      in_air = step.land - step.lift;
      segment.step_time += in_air;
      ++count;
    }
    const double duty = 1.0 - air / (last - first);
    segment.least_duty = std::min(segment.least_duty, duty);
    segment.greatest_duty = std::max(segment.greatest_duty, duty);
    segment.mean_duty += duty / 6.0;
  }
  segment.step_time /= count;
  const Vector3 way = sample_at(recording, end).X_WB.p - sample_at(recording, begin).X_WB.p;
  segment.speed = way.head<2>().norm() / (end - begin);
  segment.speed_by_law = speed_by_law(segment, stroke);
}

// What each part was found to be; and the duty factor of every single step: from its lift to the
// leg's next.
void write_tables(figures::StagedFiles& files, const std::vector<Segment>& segments,
                  const recording::Recording& recording, const RobotModel& robot) {
  figures::Csv parts(
      "from_s,to_s,duty_factor,name,measured_mean,measured_least,measured_greatest,period_s,"
      "step_time_s,phase_error,speed_m_s,speed_by_law_m_s");
  for (const Segment& s : segments)
    parts.row(s.from, s.to, s.duty_factor, s.name, s.mean_duty, s.least_duty, s.greatest_duty,
              s.period, s.step_time, s.phase_error, s.speed, s.speed_by_law);
  figures::Csv duty("leg,time_s,duty_factor");
  const auto& steps = recording.steps();
  for (auto step = steps.begin(); step != steps.end(); ++step) {
    const auto next = std::find_if(step + 1, steps.end(),
                                   [&](const auto& later) { return later.leg == step->leg; });
    if (next == steps.end() || std::isnan(step->land)) continue;
    duty.row(step->leg, step->lift, 1.0 - (step->land - step->lift) / (next->lift - step->lift));
  }
  figures::write_tables(files, "wave_family",
                        {{"segments", parts},
                         {"duty", duty},
                         {"steps", recording.steps_table(robot)},
                         {"gait", recording.gait_table()}});
}

void draw(figures::StagedFiles& files, const ExperimentContext& context,
          const std::vector<Segment>& segments, const recording::Recording& recording) {
  constexpr double kWindow = 7.0;  // of the panels at the bottom [s]
  const RobotModel& robot = *context.robot;
  write_tables(files, segments, recording, robot);

  std::vector<double> begins;
  std::vector<std::string> titles, notes;
  for (std::size_t k = 0; k <= segments.size() / 2; ++k) {
    const Segment& s = segments[k];
    begins.push_back(s.judged_from);
    titles.push_back(fmt::format("β = {}", s.name));
    notes.push_back(fmt::format("measured {:.3f}, {:.3f} m/s", s.mean_duty, s.speed));
  }
  figures::draw_figure(
      files,
      context.figure("wave_family", 1500, 1000,
                     fmt::format("Duty factors from {} to {} and back in one walk",
                                 segments.front().name, segments[segments.size() / 2].name),
                     fmt::format("{} · straight on, flat ground · β changes every {:.0f} s · after "
                                 "[PC04] 3.2, Fig. 3",
                                 robot.name, kHold)),
      {{"legs", robot.num_legs()},
       {"row_names", fmt::format("({})", recording::row_names(robot))},
       {"t_max", recording.samples().back().time},
       {"holding", kHold},
       {"window", kWindow},
       {"begins", begins},
       {"titles", titles},
       {"notes", notes}},
      scripts::pc04::wave_family);
}

}  // namespace

Outcome wave_family(const ExperimentContext& context, figures::StagedFiles& files) {
  std::vector<Segment> parts = segments(context.short_form);
  recording::Simulation simulation;
  simulation.plant = context.plant;
  simulation.gait.stepper = {.stepping = gait_state::Stepping::wave, .duty_factor = 0.5};
  simulation.trial.schedule = schedule(parts);
  simulation.trial.seconds = parts.back().to;

  const auto [recording, summary] = record(context, simulation);
  const double stroke = params_for(*context.robot).step.stroke;
  for (Segment& segment : parts) measure(segment, recording, stroke);
  draw(files, context, parts, recording);
  return {.walk = recording::WalkReport{context.robot->name, simulation, summary},
          .verdicts = judged_in_full_only(judge_wave_family(parts, summary), context.short_form)};
}

}  // namespace hexagait::experiments

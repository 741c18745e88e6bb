// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/figures/csv.hpp>
#include <hexagait/recording/figures/action.gp.hpp>
#include <hexagait/recording/figures/action_figure.hpp>
#include <hexagait/recording/figures/detail/sheet.hpp>

namespace hexagait::recording {
namespace {

constexpr double kInterval = 0.02;  // between samples [s]

using detail::kHeight;
using detail::kWidth;
using figures::Box;
using figures::Csv;
using figures::Panel;

// Of the coordinates k and l of everything that is drawn, with room around it, and widened to the
// panel's proportions: a metre is as long across as up.
Box shown(const ActionRecording& recording, int k, int l, const Panel& panel) {
  Box box;
  const auto include = [&](const Vector3& p) { box.include({p[k], p[l]}); };
  for (const ActionRecording::Sample& sample : recording.samples()) {
    include(sample.base);
    for (const Vector3& foot : sample.feet) include(foot);
  }
  return box.grown(0.05).fitted(panel, kWidth, kHeight);
}

// Of the margin [m].
std::pair<double, double> margin_range(const ActionRecording& recording) {
  double least = 0.0, greatest = 0.04;
  for (const ActionRecording::Sample& sample : recording.samples()) {
    if (!std::isfinite(sample.margin)) continue;
    least = std::min(least, 1.1 * sample.margin);
    greatest = std::max(greatest, 1.25 * sample.margin);
  }
  return {least, greatest};
}

Csv base_table(const ActionRecording& recording) {
  Csv csv("time_s,x_m,y_m,z_m,margin_m");
  for (const ActionRecording::Sample& s : recording.samples())
    csv.row(s.time, s.base, std::isfinite(s.margin) ? s.margin : std::nan(""));
  return csv;
}

// Leg by leg, with a blank line between them: a line of its own each.
Csv feet_table(const ActionRecording& recording, const RobotModel& robot) {
  Csv csv("leg,time_s,x_m,y_m,z_m,support");
  for (LegId i = 0; i < robot.num_legs(); ++i) {
    for (const ActionRecording::Sample& s : recording.samples())
      csv.row(i, s.time, s.feet[i], s.support.contains(i) ? 1 : 0);
    csv.gap();
  }
  return csv;
}

Csv steps_table(const ActionRecording& recording) {
  Csv csv("step,from_s,to_s");
  for (const ActionRecording::Step& step : recording.steps())
    csv.row(step.number, step.from, step.to);
  return csv;
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

void draw_action(figures::StagedFiles& files, figures::Figure figure,
                 const ActionRecording& recording, const RobotModel& robot) {
  figure.width = kWidth;
  figure.height = kHeight;
  figures::write_tables(files, figure.stem,
                        {{"base", base_table(recording)},
                         {"feet", feet_table(recording, robot)},
                         {"steps", steps_table(recording)}});

  // Names of the legs where their feet are at the beginning.
  std::vector<std::string> names;
  std::vector<double> x, y;
  for (LegId i = 0; i < robot.num_legs(); ++i) {
    names.push_back(robot.legs[i].name);
    x.push_back(recording.samples().front().feet[i].x());
    y.push_back(recording.samples().front().feet[i].y());
  }
  const auto [bottom, top] = margin_range(recording);
  constexpr Panel kAbove = {0.05, 0.475, 0.42, 0.86}, kSide = {0.55, 0.985, 0.42, 0.86},
                  kMargin = {0.05, 0.985, 0.07, 0.31};
  draw_figure(files, figure,
              {{"above", kAbove},
               {"side", kSide},
               {"margin", kMargin},
               {"above", shown(recording, 0, 1, kAbove)},
               {"side", shown(recording, 0, 2, kSide)},
               {"t_max", recording.samples().back().time},
               {"num_steps", static_cast<double>(recording.steps().size())},
               {"bottom", bottom},
               {"top", top},
               {"leg_names", names},
               {"leg_x", x},
               {"leg_y", y}},
              scripts::recording::action);
}

}  // namespace hexagait::recording

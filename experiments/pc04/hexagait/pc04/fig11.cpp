// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// [PC04] Fig. 11: a spider-like robot with the controller of argos, and headings at random.
#include <fmt/format.h>

#include <algorithm>
#include <hexagait/heading_control/path_arc.hpp>
#include <hexagait/pc04/pc04.hpp>
#include <hexagait/pc04/robot_judges.hpp>
#include <hexagait/pc04/snapshots.hpp>

namespace hexagait::experiments {
namespace {

constexpr double kPeriod = 6.0;  // between commands [s]

// Angle by which the body's direction of motion changes at once; of a turn in place there is none.
double sharpest_change(const walk::Schedule& schedule, const RobotModel& robot) {
  const auto stance = nominal_stance(robot);
  double sharpest = 0.0;
  for (std::size_t k = 1; k < schedule.size(); ++k) {
    const Vector2 before = path_arc(schedule[k - 1].heading, stance).per_metre.v,
                  after = path_arc(schedule[k].heading, stance).per_metre.v;
    if (before.norm() * after.norm() > 0.0)
      sharpest =
          std::max(sharpest, std::abs(portable::atan2(cross(before, after), before.dot(after))));
  }
  return sharpest;
}

double median_step(const recording::Recording& recording) {
  std::vector<double> times;
  for (const recording::Recording::Step& step : recording.steps())
    if (step.land > step.lift) times.push_back(step.land - step.lift);
  return walk::percentile(times, 0.5);
}

// Of the base, between two samples.
double greatest_speed(const recording::Recording& recording) {
  double speed = 0.0;
  const auto& samples = recording.samples();
  for (std::size_t k = 1; k < samples.size(); ++k)
    speed = std::max(speed, (samples[k].X_WB.p - samples[k - 1].X_WB.p).head<2>().norm() /
                                (samples[k].time - samples[k - 1].time));
  return speed;
}

}  // namespace

Outcome fig11(const ExperimentContext& context, figures::StagedFiles& files) {
  const RobotModel spider = context.robot_named("spider");
  ExperimentContext of_spider = context;
  of_spider.robot = &spider;
  recording::Simulation simulation;
  simulation.plant = context.plant;
  simulation.trial.seconds = context.short_form ? 2.0 * kPeriod : 90.0;
  simulation.trial.schedule = walk::random_schedule(
      simulation.seed, kPeriod, simulation.trial.seconds, walk::tightest_radius(spider));

  const auto [recording, summary] = record(of_spider, simulation);
  std::vector<double> commands;
  for (const walk::TimedCommand& command : simulation.trial.schedule)
    commands.push_back(command.time);
  draw_snapshots(
      files,
      of_spider.figure("fig11", 0, 0, "A spider-like robot that receives headings at random",
                       fmt::format("{} · a command every {:.0f} s, at the circles · {:.1f} m in "
                                   "{:.0f} s · {:.1f} mm off the commanded path on average · after "
                                   "[PC04] Fig. 11",
                                   spider.name, kPeriod, summary.distance, summary.seconds,
                                   1e3 * summary.lateral_mean)),
      {0.0, summary.seconds}, {simulation.terrain, simulation.seed}, recording, spider, commands);
  const RobotParams params = params_for(spider);
  const RandomHeadings walk{summary,
                            scale_of(spider).size,
                            greatest_speed(recording),
                            params.base.acceleration,
                            sharpest_change(simulation.trial.schedule, spider),
                            longest_pause(recording),
                            median_step(recording)};
  return {.walk = recording::WalkReport{spider.name, simulation, summary},
          .verdicts = judged_in_full_only(judge_fig11(walk), context.short_form)};
}

}  // namespace hexagait::experiments

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <hexagait/figures/gnuplot.hpp>
#include <hexagait/recording/trace.hpp>
#include <hexagait/recording/walk_figure.hpp>
#include <hexagait/urdf/urdf.hpp>

#include "commands.hpp"
#include "interrupt.hpp"
#include "output_file.hpp"
#include "progress.hpp"
#include "words.hpp"

namespace hexagait::app {
namespace {

using recording::WalkReport;

// What is written of a walk beside its summary.
class Writer {
 public:
  Writer(const WalkArguments& arguments, const WalkReport& report, const RobotModel& robot)
      : robot_(robot),
        plot_(output_file("--plot", arguments.plot, {".png", ".svg", ".pdf"})),
        trace_(output_file("--trace", arguments.trace, {".csv"})),
        recording_({report.simulation.terrain, report.simulation.seed}) {
    if (plot_) figures::require_gnuplot();
    if (!trace_) return;
    rows_ = trace_->files.open(trace_->path.filename());
    recording::write_trace_header(rows_, robot);
  }

  void observe(const footstep_gen::TickRecord& record, const GroundTruth& truth,
               const walk::Referee& referee) {
    if (plot_) recording_.observe(record, truth, referee);
    if (trace_) recording::write_trace_row(rows_, record, truth, referee);
  }

  void finish(const WalkReport& report) {
    if (trace_) {
      rows_.close();
      trace_->files.publish();
    }
    if (!plot_) return;
    draw_walk(plot_->files,
              {plot_->path.stem(), plot_->path.extension(), headline(report), subtitle(report)},
              recording_, robot_);
    plot_->files.publish();
  }

 private:
  const RobotModel& robot_;
  std::optional<OutputFile> plot_, trace_;
  recording::Recording recording_;
  std::ofstream rows_;
};

}  // namespace

int walk_command(const WalkArguments& arguments) {
  if (arguments.robot == kGenghis) return genghis_command(arguments);
  const RobotModel robot = load_urdf(robot_file(arguments.robot));
  WalkReport report;
  report.robot = robot.name;
  report.simulation = simulation(arguments, robot);
  Writer writer(arguments, report, robot);

  const std::atomic<bool>& interrupted = watch_interrupts();
  {
    Progress progress(report.simulation.trial.seconds, Progress::Measure::simulated_seconds,
                      arguments.quiet);
    const auto observe = [&](const footstep_gen::TickRecord& record, const GroundTruth& truth,
                             const walk::Referee& referee) {
      progress.at(record.state.time);
      writer.observe(record, truth, referee);
    };
    report.summary = simulate(robot, report.simulation, observe, &interrupted);
  }
  report.interrupted = interrupted;
  fmt::print("{}", arguments.json ? to_json(report) + "\n" : in_words(report));
  std::fflush(stdout);
  writer.finish(report);
  if (report.interrupted) return kInterrupted;
  return report.summary.ok() ? kOk : kFailed;
}

}  // namespace hexagait::app

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/figures/gnuplot.hpp>
#include <hexagait/recording/trace.hpp>
#include <hexagait/recording/walk_figure.hpp>
#include <hexagait/urdf/urdf.hpp>

#include "commands.hpp"
#include "interrupt.hpp"
#include "output.hpp"
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
    problem_ = write_problem([&] { recording::write_trace_header(rows_, robot); });
  }

  // What can't be written is told in the end: the walk goes on, and its summary is shown.
  void observe(const footstep_gen::TickRecord& record, const GroundTruth& truth,
               const walk::Referee& referee) {
    if (plot_) recording_.observe(record, truth, referee);
    if (trace_ && problem_.empty())
      problem_ = write_problem([&] { recording::write_trace_row(rows_, record, truth, referee); });
  }

  /// @throws InvalidInput  naming the file that could not be written
  void finish(const WalkReport& report) {
    if (plot_)
      write_output("--plot", *plot_, [&] {
        draw_walk(plot_->files,
                  {plot_->path.stem(), plot_->path.extension(), headline(report), subtitle(report)},
                  recording_, robot_);
        plot_->files.publish();
      });
    if (!trace_) return;
    if (!problem_.empty()) refuse_output("--trace", *trace_, problem_);
    write_output("--trace", *trace_, [&] {
      rows_.close();
      trace_->files.publish();
    });
  }

 private:
  const RobotModel& robot_;
  std::optional<OutputFile> plot_, trace_;
  recording::Recording recording_;
  std::ofstream rows_;
  std::string problem_;  // why the trace could not be written any further
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
  print_out(arguments.json ? to_json(report) + "\n" : in_words(report));
  writer.finish(report);
  if (report.interrupted) return kInterrupted;
  return report.summary.ok() && arrived(report) ? kOk : kFailed;
}

}  // namespace hexagait::app

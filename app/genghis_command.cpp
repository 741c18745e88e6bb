// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <hexagait/figures/gnuplot.hpp>
#include <hexagait/recording/genghis_figure.hpp>
#include <hexagait/recording/genghis_report.hpp>

#include "commands.hpp"
#include "interrupt.hpp"
#include "output_file.hpp"
#include "progress.hpp"

namespace hexagait::app {

int genghis_command(const WalkArguments& arguments) {
  recording::GenghisReport report{genghis_trial(arguments), {}, false};
  std::optional<OutputFile> plot = output_file("--plot", arguments.plot, {".png", ".svg", ".pdf"});
  std::optional<OutputFile> trace = output_file("--trace", arguments.trace, {".csv"});
  if (plot) figures::require_gnuplot();
  std::ofstream rows;
  if (trace) {
    rows = trace->files.open(trace->path.filename());
    recording::write_genghis_trace_header(rows);
  }

  recording::GenghisRecording recording;
  const std::atomic<bool>& interrupted = watch_interrupts();
  {
    Progress progress(report.trial.seconds, Progress::Measure::simulated_seconds, arguments.quiet);
    const auto observe = [&](const auto& record, const auto& truth) {
      progress.at(record.measurement.time);
      if (plot) recording.observe(record, truth);
      if (trace) recording::write_genghis_trace_row(rows, record, truth);
    };
    report.summary = sim2d::run_genghis(report.trial, observe, &interrupted);
  }
  report.interrupted = interrupted;
  fmt::print("{}", arguments.json ? to_json(report) + "\n" : in_words(report));
  std::fflush(stdout);

  if (trace) {
    rows.close();
    trace->files.publish();
  }
  if (plot) {
    draw_genghis(plot->files,
                 {plot->path.stem(), plot->path.extension(), headline(report), subtitle(report)},
                 recording, {report.trial.terrain, report.trial.seed});
    plot->files.publish();
  }
  if (report.interrupted) return kInterrupted;
  return report.summary.ok() ? kOk : kFailed;
}

}  // namespace hexagait::app

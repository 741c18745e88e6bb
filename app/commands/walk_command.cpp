// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <hexagait/figures/gnuplot.hpp>
#include <hexagait/recording/figures/movie.hpp>
#include <hexagait/recording/figures/walk_figure.hpp>
#include <hexagait/recording/trace.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <map>

#include "commands/commands.hpp"
#include "files/output_file.hpp"
#include "files/replay_output.hpp"
#include "terminal/interrupt.hpp"
#include "terminal/output.hpp"
#include "terminal/progress.hpp"
#include "words/words.hpp"

namespace hexagait::app {
namespace {

using recording::Recording;
using recording::WalkReport;

// What is written of a walk beside its summary.
class Writer {
 public:
  Writer(const WalkArguments& arguments, const RobotModel& robot, Recording recording)
      : robot_(robot),
        plot_(output_file("--plot", arguments.plot, {".png", ".svg", ".pdf"})),
        movie_(output_file("--movie", arguments.movie, {".gif"})),
        trace_(output_file("--trace", arguments.trace, {".csv"})),
        replay_(arguments.record, arguments.html),
        recording_(std::move(recording)) {
    if (plot_) add("--plot", *plot_, recording::walk_figure_files(plot_->path.stem()));
    if (movie_) add("--movie", *movie_, recording::movie_files(movie_->path.stem()));
    if (trace_) add("--trace", *trace_, {});
    for (const auto& [option, file] : replay_.files()) add(option, *file, {});
    if (plot_ || movie_) figures::require_gnuplot();
    if (!trace_) return;
    rows_ = trace_->files.open(trace_->path.filename());
    problem_ = write_problem([&] { recording::write_trace_header(rows_, robot); });
  }

  // All files that there will be.
  [[nodiscard]] const std::vector<std::string>& files() const { return files_; }

  void begin(const recording::Simulation& simulation) { replay_.begin(robot_, simulation); }

  // What can't be written is told in the end: the walk goes on, and its summary is shown.
  void observe(const footstep_gen::TickRecord& record, const GroundTruth& truth,
               const walk::Referee& referee, const sim3d::World& world) {
    observe(record, truth, referee);
    replay_.observe(record, truth, referee, world);
  }
  void observe(const footstep_gen::TickRecord& record, const GroundTruth& truth,
               const walk::Referee& referee) {
    if (plot_ || movie_) recording_.observe(record, truth, referee);
    if (trace_ && problem_.empty())
      problem_ = write_problem([&] { recording::write_trace_row(rows_, record, truth, referee); });
  }

  /// @throws InvalidInput  naming the file that could not be written
  void finish(const WalkReport& report) {
    if (plot_)
      write_output("--plot", *plot_, [&] {
        draw_walk(plot_->files,
                  {.stem = plot_->path.stem(),
                   .suffix = plot_->path.extension(),
                   .headline = headline(report),
                   .subtitle = subtitle(report)},
                  recording_, robot_);
        plot_->files.publish();
      });
    if (movie_)
      write_output("--movie", *movie_, [&] {
        draw_movie(movie_->files, movie_->path.stem(), recording_, robot_);
        movie_->files.publish();
      });
    replay_.finish();
    if (!trace_) return;
    if (!problem_.empty()) refuse_output("--trace", *trace_, problem_);
    write_output("--trace", *trace_, [&] {
      rows_.close();
      trace_->files.publish();
    });
  }

 private:
  // An output and the files beside it; none may be that of another option.
  void add(const char* option, const OutputFile& file, std::vector<std::string> names) {
    names.insert(names.begin(), file.path.filename());
    for (const std::string& name : names) {
      const auto path = file.path.parent_path() / name;
      const auto [other, is_new] =
          option_of_.emplace(std::filesystem::weakly_canonical(path), option);
      if (!is_new)
        throw InvalidInput(
            fmt::format("{} and {} would both write '{}'; name one of them otherwise",
                        other->second, option, path.string()));
      files_.push_back(path);
    }
  }

  const RobotModel& robot_;
  std::optional<OutputFile> plot_, movie_, trace_;
  ReplayOutput replay_;
  std::map<std::filesystem::path, const char*> option_of_;
  std::vector<std::string> files_;
  Recording recording_;
  std::ofstream rows_;
  std::string problem_;  // why the trace could not be written any further
};

std::string in_print(const WalkArguments& arguments, const WalkReport& report,
                     const Writer& writer) {
  if (arguments.json) return to_json(report, writer.files()) + "\n";
  std::string text = in_words(report);
  if (!writer.files().empty())
    add(text, "files", fmt::format("{}", fmt::join(writer.files(), ", ")));
  return text;
}

}  // namespace

int walk_command(const WalkArguments& arguments) {
  if (arguments.teleop) return teleop_command(arguments);
  std::optional<sim2d::GenghisTrial> genghis;
  if (arguments.robot == kGenghis) genghis = genghis_trial(arguments);
  const RobotModel robot = genghis
                               ? robot_in_space(sim2d::GenghisModel{})
                               : load_robot(arguments.robot, arguments.overrides, arguments.quiet);
  WalkReport report = genghis ? recording::report_of(*genghis) : WalkReport{};
  report.robot = robot.name;
  if (!genghis) report.simulation = simulation(arguments, robot);
  const recording::Simulation& walk = report.simulation;
  Writer writer(arguments, robot,
                genghis ? Recording(sim2d::Terrain2d(genghis->terrain, genghis->seed))
                        : Recording(sim3d::Terrain(walk.terrain, walk.seed)));

  if (!genghis) writer.begin(walk);
  const std::atomic<bool>& interrupted = watch_interrupts();
  {
    Progress progress(walk.trial.seconds, Progress::Measure::simulated_seconds, arguments.quiet);
    const auto observe = [&](const footstep_gen::TickRecord& record, const auto&... seen) {
      progress.at(record.state.time);
      writer.observe(record, seen...);
    };
    if (genghis)
      take(report, recording::simulate(*genghis, observe, &interrupted));
    else
      report.summary = simulate_in_world(robot, walk, observe, &interrupted);
  }
  report.interrupted = interrupted;
  if (report.summary.stuck) report.hindrance = in_words(report.summary.hindrance, robot);
  report.found = found_in_words(report.summary, robot);
  print_out(in_print(arguments, report, writer));
  writer.finish(report);
  if (report.interrupted) return kInterrupted;
  return report.summary.ok() && arrived(report) ? kOk : kFailed;
}

}  // namespace hexagait::app

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <hexagait/figures/gnuplot.hpp>
#include <hexagait/recording/figures/action_figure.hpp>
#include <hexagait/recording/simulation.hpp>
#include <hexagait/sim3d/world.hpp>
#include <hexagait/walk/actions/action_check.hpp>

#include "commands/commands.hpp"
#include "files/output_file.hpp"
#include "files/replay_output.hpp"
#include "terminal/interrupt.hpp"
#include "terminal/output.hpp"
#include "terminal/step_progress.hpp"
#include "words/action_words.hpp"

namespace hexagait::app {
namespace {

using recording::ActionRecording;

// The figure that an option asks for; drawn when all is done.
class Figure {
 public:
  Figure(const char* option, const std::string& name)
      : option_(option), file_(output_file(option, name, {".png", ".svg", ".pdf"})) {
    if (file_) figures::require_gnuplot();
  }

  template <class... State>
  void observe(const State&... state) {
    if (file_) recording_.observe(state...);
  }

  void draw(const ActionReport& report, const std::string& headline, const std::string& subtitle) {
    if (!file_ || recording_.samples().empty()) return;
    write_output(option_, *file_, [&] {
      draw_action(file_->files,
                  {.stem = file_->path.stem(),
                   .suffix = file_->path.extension(),
                   .headline = headline,
                   .subtitle = subtitle},
                  recording_, report.input->robot);
      file_->files.publish();
    });
  }

 private:
  const char* option_;
  std::optional<OutputFile> file_;
  ActionRecording recording_;
};

// Played ahead and drawn, not simulated.
int preview_command(const ActionArguments& arguments) {
  Figure figure("--preview", arguments.preview_plot);
  const ActionInput input = action_input(arguments);
  ActionReport report{.input = &input, .ahead = {}, .summary = {}};
  report.ahead = preview(input, [&](const ActionRecord& record) { figure.observe(record); });
  print_out(arguments.json ? check_json(report) + "\n"
                           : findings(report) + check_verdict(report) + "\n");
  figure.draw(report, check_verdict(report), "Preview: ground as every foot expects it");
  return walk::has_errors(report.ahead) ? kFailed : kOk;
}

// The first interrupt stops the action, so that the robot comes to a stance; the second ends all.
walk::ActionSummary simulate(const ActionInput& input, double seconds, Figure& figure,
                             ReplayOutput& replay, bool quiet) {
  sim3d::WorldParams params = recording::world_params(input.plant, input.params.plant);
  params.seed = input.seed;
  params.start_height = input.start.height;
  sim3d::World world(with_loads(input.robot, input.plant.parts), input.terrain, params,
                     input.start.q);
  RunnerParams runner_params = walk::runner_params(input.params);
  walk::PartFaultPlant broken(world, input.plant.parts, recording::body_of(world),
                              params.control_dt, 0.0, input.seed);
  walk::FaultyPlant plant(broken, input.robot, input.plant.faults, params.control_dt, input.seed);
  runner_params.executor.controller = input.controller;
  ActionRunner runner(input.robot, runner_params);
  walk::ActionTrialOptions options;
  options.rests_on = input.start.rests_on;
  options.seconds = 2.0 * seconds + 60.0;  // more than any search for ground takes

  const std::atomic<int>& interrupts = count_interrupts();
  recording::Simulation simulation;
  simulation.seed = input.seed;
  simulation.control_dt = params.control_dt;
  replay.begin(input.robot, simulation);
  StepProgress progress(quiet);
  const auto observe = [&](const ActionRecord& record, const GroundTruth& truth) {
    progress.at(record.feedback);
    figure.observe(record, truth);
    replay.observe(record, truth, world);
    if (interrupts > 0) runner.stop();
    return interrupts < 2;
  };
  return run_action(runner, plant, world.truth(), input.action, options, observe);
}

}  // namespace

int run_command(const ActionArguments& arguments) {
  if (arguments.preview) return preview_command(arguments);
  Figure figure("--plot", arguments.plot);
  ReplayOutput replay(arguments.record, arguments.html);
  const ActionInput input = action_input(arguments);
  ActionReport report{.input = &input, .ahead = preview(input), .summary = {}};
  const bool refused = walk::has_errors(report.ahead) && !arguments.force;
  if (refused || !arguments.quiet) fmt::print(stderr, "{}", findings(report));
  if (refused) {
    fmt::print(stderr, "hexagait: not run: {} --force runs it all the same\n",
               check_verdict(report));
    return kFailed;
  }

  report.summary = simulate(input, report.ahead.seconds, figure, replay, arguments.quiet);
  report.interrupted = count_interrupts() > 0;
  print_out(arguments.json ? run_json(report) + "\n" : run_in_words(report));
  figure.draw(report, run_headline(report), "Simulated: the true paths");
  replay.finish();
  if (report.interrupted) return kInterrupted;
  return report.summary.ok() ? kOk : kFailed;
}

}  // namespace hexagait::app

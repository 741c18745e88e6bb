// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <hexagait/all/all.hpp>
#include <hexagait/figures/gnuplot.hpp>
#include <hexagait/figures/staged_files.hpp>
#include <hexagait/recording/simulation.hpp>
#include <hexagait/sim2d/slice_model.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/text_file.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <limits>

#include "commands/commands.hpp"
#include "commands/experiment_context.hpp"
#include "commands/sweep_command.hpp"
#include "terminal/interrupt.hpp"
#include "terminal/output.hpp"
#include "terminal/progress.hpp"
#include "words/results_page.hpp"

namespace hexagait::app {
namespace {

namespace fs = std::filesystem;
using experiments::Check;
using experiments::Experiment;
using experiments::ExperimentContext;
using experiments::Manifest;
using experiments::Measured;
using experiments::Verdict;

constexpr const char* kSpeedGroup = "speed";
constexpr const char* kSpeedTitle = "Speed of the program";
constexpr const char* kMoreToFeel =
    "feeling gravity, roughness and lag takes half as many instructions again as before";

recording::Simulation straight_walk(double seconds) {
  recording::Simulation simulation;
  simulation.trial.schedule = {{0.0, heading_control::Heading::straight(0.0)}};
  simulation.trial.seconds = seconds;
  return simulation;
}

// Instructions that Walker::tick() takes in a walk of this program, by callgrind; NaN without it.
double instructions_in_walk(double seconds) {
  const std::string command = fmt::format(
      "valgrind --tool=callgrind --callgrind-out-file=/dev/null "
      "--toggle-collect='hexagait::footstep_gen::Walker::tick(*' '{}' walk --seconds {} --quiet "
      "2>&1 >/dev/null",
      fs::read_symlink("/proc/self/exe").string(), seconds);
  double count = std::numeric_limits<double>::quiet_NaN();
  std::FILE* const output = popen(command.c_str(), "r");
  if (output == nullptr) return count;
  char line[256];
  while (std::fgets(line, sizeof line, output) != nullptr)
    if (const char* const found = std::strstr(line, "Collected : "))
      count = std::atof(found + std::strlen("Collected : "));
  pclose(output);
  return count;
}

// Of two walks of which one is 500 ticks longer: all else takes as many in both.
double instructions_per_tick() {
  return (instructions_in_walk(2.0) - instructions_in_walk(1.0)) / 500.0;
}

double million_slices_per_second() {
  constexpr int kSlices = 2'000'000;
  sim2d::SliceRobot robot({.slices = kSlices}, {1, 0});
  const std::clock_t start = std::clock();  // processor time
  for (int slice = 0; slice < kSlices; ++slice) robot.advance();
  const auto ticks = static_cast<double>(std::clock() - start);
  return 1e-6 * kSlices * CLOCKS_PER_SEC / ticks;
}

ResultsGroup speed(const RobotModel& robot) {
  // The fastest of five runs: other load on the machine can only slow them down.
  double factor = 0.0, median = std::numeric_limits<double>::infinity(), p99 = median, slices = 0.0;
  for (int run = 0; run < 5; ++run) {
    const walk::Summary s = recording::simulate(robot, straight_walk(10.0));
    factor = std::max(factor, s.real_time_factor);
    median = std::min(median, s.tick_median);
    p99 = std::min(p99, s.tick_p99);
    slices = std::max(slices, million_slices_per_second());
  }
  const double instructions = instructions_per_tick();
  return {
      kSpeedTitle,
      "hexagait results --only speed",
      {{.claim = "A robot of 18 joints is simulated faster than it walks, on one core, with 2 ms "
                 "physics",
        .checks = {{Measured("simulated time over processor time", "", factor),
                    experiments::at_least(15.0)}}},
       {.claim = "A tick of the controller is short",
        .checks = {Check(Measured("wall time, median", "µs", 1e-3 * median),
                         experiments::at_most(2.0))
                       .expected_to_fail(experiments::between(2.0, 5.0), kMoreToFeel),
                   {Measured("99th percentile", "µs", 1e-3 * p99), experiments::at_most(50.0)}},
        .remark = std::isnan(instructions)
                      ? "instructions: not measured, as there is no valgrind"
                      : fmt::format("{:.0f} instructions on average, by callgrind", instructions)},
       {.claim = "The slice model is fast",
        .checks = {
            {Measured("slices on one core", "million/s", slices), experiments::at_least(5.0)}}}}};
}

// The name, or the title, of each group in the order of the page.
std::vector<std::string> of_each_group(std::string Experiment::*what, const char* of_speed) {
  std::vector<std::string> all;
  for (const Experiment& experiment : experiments::experiments()) all.push_back(experiment.*what);
  all.emplace_back(of_speed);
  return all;
}

// What measures these figures alone.
std::string command_of(const Experiment& experiment, bool short_form) {
  const std::string seeds =
      experiment.name == "rough" ? fmt::format(" --seeds {}", kRoughSeedsOfMany) : "";
  return fmt::format("hexagait experiment {}{}{}", experiment.name, seeds,
                     short_form ? " --short" : "");
}

// The page whose sections are to be replaced; empty where there is none.
ResultsPage page_as_it_is(const fs::path& out) {
  if (!fs::exists(out)) return {};
  constexpr std::size_t kMaxSize = 1 << 22;
  const std::string text = read_text(out.string(), kMaxSize, "a page of hexagait results");
  try {
    return ResultsPage(text);
  } catch (const InvalidInput& problem) {
    throw InvalidInput(
        fmt::format("--out is '{}': {}; give another file", out.string(), problem.what()));
  }
}

void write_page(const fs::path& out, const ResultsPage& page) {
  figures::StagedFiles files(out.parent_path());
  files.write(out.filename().string(), page.text(of_each_group(&Experiment::title, kSpeedTitle)));
  files.publish();
}

}  // namespace

int results_command(const ResultsArguments& arguments) {
  const std::vector<std::string> all = of_each_group(&Experiment::name, kSpeedGroup);
  for (const std::string& name : arguments.only)
    if (std::ranges::find(all, name) == all.end())
      throw InvalidInput(
          fmt::format("--only is '{}'; it must be one of {}", name, fmt::join(all, ", ")));
  const auto wanted = [&](const std::string& name) {
    return arguments.only.empty() ||
           std::ranges::find(arguments.only, name) != arguments.only.end();
  };
  const fs::path out = arguments.out;
  ResultsPage page = page_as_it_is(out);
  figures::StagedFiles(out.parent_path()).expect(out.filename().string());  // before the work
  const RobotModel robot = load_urdf(robot_file("argos"));
  figures::require_gnuplot();
  const std::atomic<bool>& interrupted = watch_interrupts();

  bool well = true;
  const auto add = [&](const ResultsGroup& group) {
    page.set(group);
    write_page(out, page);
    well = well && std::ranges::all_of(group.verdicts, &Verdict::is_accounted_for);
  };
  for (const Experiment& experiment : experiments::experiments()) {
    if (!wanted(experiment.name)) continue;
    if (!arguments.quiet) fmt::print(stderr, "{}\n", experiment.title);
    Progress progress(1.0, Progress::Measure::share, arguments.quiet);
    ExperimentContext context =
        experiment_context(robot, progress, interrupted, arguments.short_form);
    context.jobs = jobs("", cores());
    context.seeds = kRoughSeedsOfMany;
    const Manifest manifest = run(experiment, context, arguments.figures);
    if (interrupted) return kInterrupted;
    add({experiment.title, command_of(experiment, arguments.short_form), manifest.outcome.verdicts,
         arguments.short_form});
  }
  if (wanted(kSpeedGroup)) {
    if (!arguments.quiet) fmt::print(stderr, "{}\n", kSpeedTitle);
    add(speed(robot));
  }
  print_out(
      fmt::format("{}: {}\n", out.string(),
                  well ? "each claim holds, or fails as it was declared to" : "a claim FAILS"));
  return well ? kOk : kFailed;
}

}  // namespace hexagait::app

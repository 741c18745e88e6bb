// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <hexagait/all/all.hpp>
#include <hexagait/figures/gnuplot.hpp>
#include <hexagait/figures/staged_files.hpp>
#include <hexagait/recording/provenance.hpp>
#include <hexagait/recording/simulation.hpp>
#include <hexagait/sim2d/slice_model.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <limits>
#include <thread>

#include "commands/commands.hpp"
#include "commands/experiment_context.hpp"
#include "commands/sweep_command.hpp"
#include "terminal/interrupt.hpp"
#include "terminal/output.hpp"
#include "terminal/progress.hpp"

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
constexpr const char* kMoreToFeel =
    "feeling gravity, roughness and lag takes half as many instructions again as before";

// A group of figures, and the command that shows them alone.
struct Group {
  std::string title, command;
  std::vector<Verdict> verdicts;
};

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "an unknown processor";
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  return fmt::format("{:04}-{:02}-{:02}", utc.tm_year + 1900, utc.tm_mon + 1, utc.tm_mday);
}

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

Group speed(const RobotModel& robot) {
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
      "Speed of the program",
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

// A cell may hold anything but the line that ends it.
std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2)
    text.insert(at, 1, '\\');
  return text;
}

std::string number(double value) {
  return std::isnan(value) ? "not measured" : fmt::format("{:.4g}", value == 0.0 ? 0.0 : value);
}

void write_check(std::ostream& out, const Check& check, bool safety) {
  const Measured& m = check.measured();
  const std::string unit = m.unit.empty() ? "" : ' ' + m.unit;
  std::string found = number(m.value) + unit;
  if (!m.detail.empty()) found += fmt::format(" ({})", m.detail);
  const std::string interval =
      m.interval ? fmt::format("{} … {}", number(m.interval->lower), number(m.interval->upper))
                 : "";
  std::string claimed = to_string(check.bound(), m.unit);
  if (check.band()) claimed += "; expected " + to_string(*check.band(), m.unit);
  fmt::print(out, "| {}{} | {} | {} | {} |\n", cell(m.name), safety ? " (safety)" : "",
             cell(claimed), cell(found), interval);
}

void write_verdict(std::ostream& out, const Verdict& verdict) {
  fmt::print(out, "| **{}**: {} | | | |\n", verdict.word(), cell(verdict.claim));
  for (const auto& safe : verdict.safety) write_check(out, safe.check(), true);
  if (verdict.not_judged.empty())
    for (const Check& check : verdict.checks) write_check(out, check, false);
  else
    fmt::print(out, "| not judged: {} | | | |\n", cell(verdict.not_judged));
  for (const Check& check : verdict.checks)
    if (check.band()) fmt::print(out, "| because {} | | | |\n", cell(check.reason()));
  if (!verdict.remark.empty()) fmt::print(out, "| {} | | | |\n", cell(verdict.remark));
}

void write_page(std::ostream& out, const std::vector<Group>& groups, bool short_form) {
  const recording::Provenance made_by = recording::provenance();
  std::string libraries;
  for (const auto& [name, version] : made_by.libraries)
    libraries += fmt::format("{}{} {}", libraries.empty() ? "" : ", ", name, version);
  fmt::print(
      out,
      "# Results\n\n"
      "`hexagait results` made this page on {}, with hexagait {} ({}), {}, {}, on {} with {} "
      "cores. No number is typed by hand.{}\n\n"
      "A claim *holds* if every figure below it is within what is claimed. Where there is a "
      "95 % interval and the claim is about a mean, all of the interval must be. "
      "*As expected, does not hold*: it is known to fail, by how much, and why; it would be "
      "reported as failed if it failed by more, or held. Figures marked as safety are "
      "never excused. Definitions: [theory.md](theory.md#the-referee).\n",
      today(), made_by.version, made_by.revision, made_by.compiler, libraries, processor(),
      std::thread::hardware_concurrency(),
      short_form ? " **Short forms: not the figures that are claimed.**" : "");
  for (const Group& group : groups) {
    fmt::print(out,
               "\n## {}\n\n`{}`\n\n| figure | claimed | measured | 95 % interval |\n"
               "|---|---|---|---|\n",
               group.title, group.command);
    for (const Verdict& verdict : group.verdicts) write_verdict(out, verdict);
  }
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const Experiment& experiment : experiments::experiments()) all.push_back(experiment.name);
  all.emplace_back(kSpeedGroup);
  return all;
}

}  // namespace

int results_command(const ResultsArguments& arguments) {
  const std::vector<std::string> all = names();
  for (const std::string& name : arguments.only)
    if (std::ranges::find(all, name) == all.end())
      throw InvalidInput(
          fmt::format("--only is '{}'; it must be one of {}", name, fmt::join(all, ", ")));
  const auto wanted = [&](const std::string& name) {
    return arguments.only.empty() ||
           std::ranges::find(arguments.only, name) != arguments.only.end();
  };
  const fs::path out = arguments.out;
  figures::StagedFiles files(out.has_parent_path() ? out.parent_path() : ".");
  const RobotModel robot = load_urdf(robot_file("argos"));
  figures::require_gnuplot();
  const std::atomic<bool>& interrupted = watch_interrupts();

  std::vector<Group> groups;
  bool well = true;
  for (const Experiment& experiment : experiments::experiments()) {
    if (!wanted(experiment.name)) continue;
    if (!arguments.quiet) fmt::print(stderr, "{}\n", experiment.title);
    Progress progress(1.0, Progress::Measure::share, arguments.quiet);
    ExperimentContext context =
        experiment_context(robot, progress, interrupted, arguments.short_form);
    context.jobs = jobs("", cores());
    if (arguments.only.empty()) context.seeds = kRoughSeedsOfMany;
    const Manifest manifest = run(experiment, context, arguments.figures);
    if (interrupted) return kInterrupted;
    well = well && manifest.is_accounted_for();
    groups.push_back({experiment.title,
                      fmt::format("hexagait experiment {}{}", experiment.name,
                                  arguments.short_form ? " --short" : ""),
                      manifest.outcome.verdicts});
  }
  if (wanted(kSpeedGroup)) {
    if (!arguments.quiet) fmt::print(stderr, "Speed of the program\n");
    groups.push_back(speed(robot));
    well = well && std::ranges::all_of(groups.back().verdicts, &Verdict::is_accounted_for);
  }

  std::ofstream page = files.create(out.filename().string());
  write_page(page, groups, arguments.short_form);
  page.close();
  files.publish();
  print_out(
      fmt::format("{}: {}\n", out.string(),
                  well ? "each claim holds, or fails as it was declared to" : "a claim FAILS"));
  return well ? kOk : kFailed;
}

}  // namespace hexagait::app

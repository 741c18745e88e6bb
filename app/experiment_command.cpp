// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <hexagait/all/all.hpp>
#include <hexagait/experiments/page.hpp>
#include <hexagait/figures/gnuplot.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/urdf/urdf.hpp>

#include "commands.hpp"
#include "interrupt.hpp"
#include "progress.hpp"

namespace hexagait::app {
namespace {

using experiments::Experiment;
using experiments::Manifest;

int list() {
  for (const Experiment& experiment : experiments::experiments())
    fmt::print("{:<12} {}\n", experiment.name, experiment.title);
  return kOk;
}

std::vector<Experiment> chosen(const std::string& name) {
  const std::vector<Experiment>& all = experiments::experiments();
  if (name == "all") return all;
  const auto found = std::ranges::find(all, name, &Experiment::name);
  if (found != all.end()) return {*found};
  std::string names = "all";
  for (const Experiment& experiment : all) names += ", " + experiment.name;
  throw InvalidInput(fmt::format("the experiment is '{}'; it must be one of {}", name, names));
}

void print(const Manifest& manifest, const std::filesystem::path& out) {
  fmt::print("{}\n", manifest.title);
  for (const experiments::Verdict& verdict : manifest.outcome.verdicts) {
    fmt::print("  {}: {}\n", verdict.word(), verdict.claim);
    for (const std::string& line : verdict.lines()) fmt::print("      {}\n", line);
  }
  fmt::print("  written to {}\n\n", (out / manifest.experiment).string());
}

}  // namespace

int experiment_command(const ExperimentArguments& arguments) {
  if (arguments.list) return list();
  const std::vector<Experiment> selection = chosen(arguments.name);
  const RobotModel robot = load_urdf(robot_file("argos"));
  figures::require_gnuplot();
  const std::atomic<bool>& interrupted = watch_interrupts();

  std::vector<Manifest> manifests;
  for (const Experiment& experiment : selection) {
    Progress progress(1.0, Progress::Measure::share, arguments.quiet);
    manifests.push_back(run(experiment,
                            {.robot = &robot,
                             .progress = [&](double share) { progress.at(share); },
                             .stop = &interrupted,
                             .short_form = arguments.short_form,
                             .titles = arguments.title != "none"},
                            arguments.out));
    if (interrupted) return kInterrupted;
  }

  if (arguments.name == "all") experiments::write_page(manifests, arguments.out);

  bool well = true;
  for (const Manifest& manifest : manifests) {
    well = well && manifest.is_accounted_for();
    if (!arguments.json) print(manifest, arguments.out);
  }
  if (arguments.json) fmt::print("{}\n", to_json(manifests));
  return well ? kOk : kFailed;
}

}  // namespace hexagait::app

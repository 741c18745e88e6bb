// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <hexagait/all/all.hpp>
#include <hexagait/experiments/page.hpp>
#include <hexagait/figures/gnuplot.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/nearest_word.hpp>
#include <hexagait/text/parse_number.hpp>
#include <hexagait/urdf/urdf.hpp>

#include "commands/commands.hpp"
#include "commands/experiment_context.hpp"
#include "commands/sweep_command.hpp"
#include "files/replay_output.hpp"
#include "terminal/interrupt.hpp"
#include "terminal/output.hpp"
#include "terminal/progress.hpp"

namespace hexagait::app {
namespace {

using experiments::Experiment;
using experiments::ExperimentContext;
using experiments::Manifest;

std::vector<Experiment> chosen(const std::vector<std::string>& wanted) {
  const std::vector<Experiment>& all = experiments::experiments();
  std::vector<std::string> names = {"all"};
  for (const Experiment& experiment : all) names.push_back(experiment.name);
  std::vector<Experiment> selection;
  for (const std::string& name : wanted) {
    const auto found = std::ranges::find(all, name, &Experiment::name);
    if (found != all.end())
      selection.push_back(*found);
    else if (name != "all")
      throw InvalidInput(fmt::format("the experiment is '{}'{}; it must be one of {}", name,
                                     did_you_mean(name, names), fmt::join(names, ", ")));
  }
  return std::ranges::find(wanted, "all") == wanted.end() ? selection : all;
}

// The plant that was typed, if all of these experiments walk on it.
recording::PlantSetup plant_for(const std::vector<Experiment>& selection,
                                const PlantArguments& arguments) {
  const recording::PlantSetup setup = plant(arguments);
  if (setup.is_ideal()) return setup;
  for (const Experiment& experiment : selection) {
    if (experiment.takes_plant) continue;
    std::vector<std::string> others;
    for (const Experiment& other : experiments::experiments())
      if (other.takes_plant) others.push_back(other.name);
    throw InvalidInput(
        fmt::format("the plant is '{}', but {} doesn't walk in 3D or has plants of its own; those "
                    "that take a plant are {}",
                    setup.name, experiment.name, fmt::join(others, ", ")));
  }
  return setup;
}

// What --robots or --seeds says, that only one experiment knows; 0: nothing.
std::uint64_t how_many(const char* option, const std::string& text, const char* experiment,
                       const std::vector<Experiment>& selection) {
  if (text.empty()) return 0;
  constexpr std::uint64_t kMost = 1000000;
  const auto count = parse_number<std::uint64_t>(text);
  if (!count || *count < 1 || *count > kMost)
    throw InvalidInput(
        fmt::format("{} is '{}'; it must be a whole number from 1 to {}", option, text, kMost));
  if (std::ranges::find(selection, experiment, &Experiment::name) == selection.end())
    throw InvalidInput(fmt::format("{} is an option of {}, not of {}", option, experiment,
                                   selection.front().name));
  return *count;
}

sweep::Shard part_of(const std::string& text, const std::vector<Experiment>& selection) {
  if (!text.empty() && (selection.size() > 1 || selection.front().name != "rough"))
    throw InvalidInput("--shard is an option of rough alone");
  return shard(text);
}

// The replay that was asked for, if this is one experiment with a walk to show.
ReplayOutput replay_of(const std::vector<Experiment>& selection,
                       const ExperimentArguments& arguments) {
  ReplayOutput replay(arguments.record, arguments.html);
  if (!replay.wanted()) return replay;
  const char* const option = arguments.html.empty() ? "--record" : "--html";
  if (selection.size() > 1)
    throw InvalidInput(fmt::format("{} shows one walk; name one experiment, not {}", option,
                                   arguments.names.size() > 1 ? "several" : "all"));
  if (!selection.front().shows.empty()) return replay;
  std::vector<std::string> others;
  for (const Experiment& other : experiments::experiments())
    if (!other.shows.empty()) others.push_back(other.name);
  throw InvalidInput(
      fmt::format("{}: {} has no walk in 3D that stands for it; those that have one are {}", option,
                  selection.front().name, fmt::join(others, ", ")));
}

void print(const Manifest& manifest, const std::filesystem::path& out) {
  print_out(fmt::format("{}\n", manifest.title));
  if (!manifest.outcome.left.empty()) {
    print_out(fmt::format("  {}\n\n", manifest.outcome.left));
    return;
  }
  for (const experiments::Verdict& verdict : manifest.outcome.verdicts) {
    print_out(fmt::format("  {}: {}\n", verdict.word(), verdict.claim));
    for (const std::string& line : verdict.lines()) print_out(fmt::format("      {}\n", line));
  }
  print_out(fmt::format("  written to {}\n\n", (out / manifest.experiment).string()));
}

}  // namespace

int experiment_command(const ExperimentArguments& arguments) {
  if (arguments.list || arguments.names.empty()) return list_command("experiments", arguments.json);
  const std::vector<Experiment> selection = chosen(arguments.names);
  const recording::PlantSetup plant = plant_for(selection, arguments.plant);
  const std::uint64_t robots = how_many("--robots", arguments.robots, "random_robots", selection);
  const std::uint64_t seeds = how_many("--seeds", arguments.seeds, "rough", selection);
  const sweep::Shard part = part_of(arguments.shard, selection);
  ReplayOutput replay = replay_of(selection, arguments);
  const RobotModel robot = load_urdf(robot_file("argos"));
  figures::require_gnuplot();
  const std::atomic<bool>& interrupted = watch_interrupts();

  std::vector<Manifest> manifests;
  for (const Experiment& experiment : selection) {
    const std::string problem = write_problem([&] {
      Progress progress(1.0, Progress::Measure::share, arguments.quiet);
      ExperimentContext context =
          experiment_context(robot, progress, interrupted, arguments.short_form);
      context.titles = arguments.title != "none";
      context.jobs = jobs(arguments.jobs, cores());
      context.count = robots;
      context.seeds = seeds == 0 && selection.size() > 1 ? kRoughSeedsOfMany : seeds;
      context.part = part.index;
      context.parts = part.count;
      if (!arguments.quiet)
        context.say = [](const std::string& text) { fmt::print(stderr, "{}\n", text); };
      context.plant = plant;
      if (replay.wanted()) context.spectator = &replay;
      manifests.push_back(run(experiment, context, arguments.out));
    });
    if (!problem.empty())
      throw InvalidInput(fmt::format("--out is '{}', in which the files of {} can't be written: {}",
                                     arguments.out, experiment.name, problem));
    if (interrupted) return kInterrupted;
    if (!arguments.json) print(manifests.back(), arguments.out);
  }
  replay.finish();
  if (!arguments.json)
    for (const auto& [option, file] : replay.files())
      print_out(fmt::format("  {}: {}\n", selection.front().shows, file->path.string()));

  if (selection.size() > 1) experiments::write_page(manifests, arguments.out);

  bool well = true;
  for (const Manifest& manifest : manifests) well = well && manifest.is_accounted_for();
  if (arguments.json) print_out(fmt::format("{}\n", to_json(manifests)));
  return well ? kOk : kFailed;
}

}  // namespace hexagait::app

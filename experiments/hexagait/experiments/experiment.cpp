// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <hexagait/experiments/experiment.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <ostream>

namespace hexagait::experiments {

namespace fs = std::filesystem;

Manifest run(const Experiment& experiment, const ExperimentContext& asked, const fs::path& out) {
  const fs::path directory = out / experiment.name;
  ExperimentContext context = asked;
  context.directory = directory;
  std::error_code error;
  fs::create_directories(directory, error);
  if (error)
    throw InvalidInput(
        fmt::format("can't make the directory '{}': {}", directory.string(), error.message()));

  figures::StagedFiles files(directory);
  Manifest manifest{
      experiment.name, experiment.title, context.short_form, experiment.run(context, files), {}};
  manifest.plant = context.plant;
  if (!context.plant.is_ideal())
    for (Verdict& verdict : manifest.outcome.verdicts)
      verdict = only_told(verdict, "it is a claim about the ideal plant");
  const Outcome& outcome = manifest.outcome;
  manifest.provenance = outcome.walk ? recording::provenance(outcome.walk->robot, *context.robot,
                                                             outcome.walk->simulation)
                                     : outcome.provenance.value_or(recording::provenance());
  if (context.stopped() || !outcome.left.empty()) return manifest;

  // A PDF carries the date, so its bytes differ from run to run.
  for (const std::string& name : files.names())
    if (!name.ends_with(".pdf")) manifest.outputs.push_back({name, files.hash(name)});
  files.write("manifest.json", to_json(manifest) + '\n');
  files.publish();
  return manifest;
}

void Spectator::begin_action(const RobotModel& robot, const sim3d::WorldParams& world) {
  recording::Simulation simulation;
  simulation.seed = world.seed;
  simulation.control_dt = world.control_dt;
  begin(robot, simulation);
}

walk::Summary simulate_shown(const RobotModel& robot, const recording::Simulation& simulation,
                             const walk::Observer& observer, const ExperimentContext& context) {
  if (context.spectator == nullptr)
    return recording::simulate(robot, simulation, observer, context.stop);
  context.spectator->begin(robot, simulation);
  const auto observe = [&](const auto& record, const auto& truth, const auto& referee,
                           const sim3d::World& world) {
    if (observer) observer(record, truth, referee);
    context.spectator->observe(record, truth, referee, world);
  };
  return recording::simulate_in_world(robot, simulation, observe, context.stop);
}

void show(const RobotModel& robot, const recording::Simulation& simulation,
          const ExperimentContext& context) {
  if (context.spectator != nullptr) (void)simulate_shown(robot, simulation, {}, context);
}

}  // namespace hexagait::experiments

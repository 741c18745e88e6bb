// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <hexagait/experiments/manifest.hpp>
#include <hexagait/figures/figure.hpp>
#include <hexagait/recording/simulation.hpp>
#include <hexagait/script/action_runner.hpp>
#include <string>
#include <vector>

namespace hexagait::experiments {

/// Watches the walk, or the action, that stands for an experiment: what a replay of it is made of.
/// Calls may come from another thread, but all from the same one.
class Spectator {
 public:
  Spectator() = default;
  Spectator(Spectator&&) noexcept = default;
  virtual ~Spectator() = default;

  /// Before the first tick. @param robot  must outlive the last observe()
  virtual void begin(const RobotModel& robot, const recording::Simulation& simulation) = 0;
  /// After every tick of a walk, or of an action.
  virtual void observe(const footstep_gen::TickRecord& record, const GroundTruth& truth,
                       const walk::Referee& referee, const sim3d::World& world) = 0;
  virtual void observe(const ActionRecord& record, const GroundTruth& truth,
                       const sim3d::World& world) = 0;

  /// begin() of an action in a world of these parameters.
  void begin_action(const RobotModel& robot, const sim3d::WorldParams& world);
};

/// What an experiment is given.
struct ExperimentContext {
  const RobotModel* robot = nullptr;
  /// Of figures that show other robots: those that come with hexagait, by their names.
  std::vector<std::string> robot_names = {};
  std::function<RobotModel(const std::string& name)> robot_named = {};
  std::function<void(double share)> progress;  ///< called now and then with 0 … 1
  const std::atomic<bool>* stop = nullptr;     ///< once true, the experiment ends early
  bool short_form = false;  ///< some seconds; claims that need more are not judged, and say so
  bool titles = true;       ///< above the figures
  int jobs = 1;             ///< workers, where an experiment has some
  std::uint64_t count = 0;  ///< how many random robots; 0: as many as usual
  std::uint64_t seeds = 0;  ///< terrains a point, where that may be chosen; 0: as many as usual
  /// Only this one of so many parts of its walks, on one of several machines.
  std::uint64_t part = 0, parts = 1;
  std::function<void(const std::string&)> say =
      {};  ///< told how long it will take, before it begins
  /// Where its files will be. An experiment may keep others there while it runs, and removes them.
  std::filesystem::path directory = {};
  recording::PlantSetup plant = {};  ///< of the walks; claims are made for the ideal one
  /// Of the walk that Experiment::shows names; null: nobody watches.
  Spectator* spectator = nullptr;

  /// Whether it is to end early.
  [[nodiscard]] bool stopped() const { return stop != nullptr && stop->load(); }
  /// Reports progress: `done` of `all` parts.
  void tell(std::size_t done, std::size_t all) const {
    if (progress) progress(static_cast<double>(done) / static_cast<double>(all));
  }

  /// A figure in all formats, on a sheet of width × height [px of a PNG].
  [[nodiscard]] figures::Figure figure(const std::string& stem, int width, int height,
                                       const std::string& headline,
                                       const std::string& subtitle) const {
    const std::string of_plant = plant.is_ideal() ? "" : " · plant " + plant.name;
    return {stem, "", titles ? headline : "", titles ? subtitle + of_plant : "", width, height};
  }
};

/// A figure or a claim of a paper, made again: runs, draws, and says whether the claim holds.
struct Experiment {
  std::string name;   ///< of the command, and of the files' stem
  std::string title;  ///< one line
  Outcome (*run)(const ExperimentContext& context, figures::StagedFiles& files);
  bool takes_plant = false;  ///< its walks are on ExperimentContext::plant
  /// The walk that ExperimentContext::spectator sees, in words; empty: there is none.
  std::string shows = {};
};

/// recording::simulate() of the walk that the context's spectator sees.
[[nodiscard]] walk::Summary simulate_shown(const RobotModel& robot,
                                           const recording::Simulation& simulation,
                                           const walk::Observer& observer,
                                           const ExperimentContext& context);

/// One more walk for the context's spectator, of an experiment whose own walks go to many workers, or come
/// from a journal; without one nothing is walked.
void show(const RobotModel& robot, const recording::Simulation& simulation,
          const ExperimentContext& context);

/// Runs one into a directory of its name in `out`, which is made: figures, tables, manifest.json.
/// Nothing is written if it is stopped.
/// @throws InvalidInput  if the directory can't be made or written
[[nodiscard]] Manifest run(const Experiment& experiment, const ExperimentContext& context,
                           const std::filesystem::path& out);

Outcome walks(const ExperimentContext& context, figures::StagedFiles& files);
Outcome rates(const ExperimentContext& context, figures::StagedFiles& files);

}  // namespace hexagait::experiments

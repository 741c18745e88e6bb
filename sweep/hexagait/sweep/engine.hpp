// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <hexagait/gait_state/gait_choice.hpp>
#include <hexagait/model/robot_model.hpp>
#include <hexagait/recording/plant_setup.hpp>
#include <string>
#include <string_view>
#include <vector>

/// Sweeps: a grid of trials, run by many processes on many machines. The result has the same bytes
/// on whichever machine, and in whatever order, its trials ran.
///
///     sweep file ─ load_sweep ─▶ Sweep ─ trial(k) ─▶ TrialConfig ─ run ─▶ cells    a pure function
///     Sweep + Shard ─ run_shard: WorkerPool ─▶ Journal                    durable, in any order
///     Journals ─ merge ─▶ Journal ─ publish ─▶ trials.csv, timings.csv, manifest.json ─▶ report
namespace hexagait::sweep {

/// What simulates a trial.
enum class Engine {
  slice,  ///< the slice model of [PC04] 5.1: no physics, exact
  box2d,  ///< Genghis II from the side, in Box2D
  ode,    ///< a robot in ODE, in three dimensions
};
inline constexpr std::array kEngines = {Engine::slice, Engine::box2d, Engine::ode};

/// As in a sweep file: "slice", "box2d", "ode".
[[nodiscard]] std::string_view to_string(Engine engine);

/// How long a trial goes on; each engine reads what it knows.
struct Limits {
  int slices = 500;             ///< of a trial in the slice model
  double seconds = 40.0;        ///< of a walk, at most [s]
  double distance = 0.0;        ///< of a walk, at most [m]; 0 for no limit
  double random_posture = 0.0;  ///< a walk starts with feet displaced by up to this [m]
};

/// Everything that decides the outcome of a trial.
struct TrialConfig {
  Engine engine = Engine::slice;
  gait_state::GaitChoice controller;
  const RobotModel* robot = nullptr;  ///< of the ODE engine, not null there
  recording::PlantSetup plant;        ///< of the ODE engine
  std::string terrain;                ///< as the engine spells it: "flat", "boxes:0.05"
  std::uint64_t seed = 0;             ///< of terrain, start and plant
  Limits limits;
};

/// How a trial ended.
enum class Outcome {
  arrived,  ///< at the distance that was asked for
  walked,   ///< to the end of its time; no distance was asked for
  late,     ///< to the end of its time, which was too short for the distance
  fell,
  stuck,
  fault,      ///< the controller stopped
  failed,     ///< no result: it threw, or the process that ran it died
  timed_out,  ///< no result: it took longer than a trial may
};
inline constexpr std::array kOutcomes = {Outcome::arrived, Outcome::walked,   Outcome::late,
                                         Outcome::fell,    Outcome::stuck,    Outcome::fault,
                                         Outcome::failed,  Outcome::timed_out};

/// As in trials.csv: "arrived", …, "timed_out".
[[nodiscard]] std::string_view to_string(Outcome outcome);

/// Whether a trial walked on until it had to end: what it measured is not that of an accident.
[[nodiscard]] constexpr bool walked_on(Outcome outcome) {
  return outcome == Outcome::arrived || outcome == Outcome::walked || outcome == Outcome::late;
}

/// A column of measures.
struct Column {
  std::string name;         ///< in trials.csv, with its unit: "speed_m_s"
  std::string label, unit;  ///< for people: "speed", "m/s"; a count has no unit
  bool yes_no = false;      ///< its cells are 0 or 1, and make a proportion
};

/// What an engine measures. The first is the speed.
[[nodiscard]] const std::vector<Column>& columns(Engine engine);

/// What "roughness" counts, with its unit.
[[nodiscard]] std::string_view roughness_label(Engine engine);

/// Runs one trial: a pure function, the same bytes in every process.
/// @returns outcome, reason, and a cell per column, joined by commas; what was not reached is empty
[[nodiscard]] std::string run(const TrialConfig& config);

/// The same cells for a trial that has no result, all measures empty.
[[nodiscard]] std::string no_result(Engine engine, Outcome outcome, std::string_view reason);

/// Kinds of terrain that a roughness completes, "boxes" of "boxes:0.05".
[[nodiscard]] const std::vector<std::string>& rough_terrains(Engine engine);

/// A terrain of an engine.
struct Ground {
  std::string terrain;     ///< as the engine spells it, e.g. "boxes:0.05"
  double roughness = 0.0;  ///< height of boxes [m], half the spread of descents [slices]; 0 if flat
};

/// @throws InvalidInput  if the engine has no such terrain, saying which it has
[[nodiscard]] Ground ground(Engine engine, const std::string& terrain);

}  // namespace hexagait::sweep

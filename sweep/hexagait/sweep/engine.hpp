// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <hexagait/gait_state/gait_choice.hpp>
#include <hexagait/model/robot_model.hpp>
#include <string>
#include <string_view>
#include <vector>

/// Sweeps: a grid of trials, run by many processes on many machines, with the same bytes as result
/// whoever ran what, and when.
///
///     sweep file ─ load_sweep ─▶ Sweep ─ trial(k) ─▶ TrialConfig ─ run ─▶ cells     a pure
///     function Sweep + Shard ─ run_shard: WorkerPool ─▶ Journal                    durable, in any
///     order Journals ─ merge ─▶ Journal ─ publish ─▶ trials.csv, timings.csv, manifest.json ─▶
///     report
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
  double random_posture = 0.0;  ///< a walk starts with feet displaced by up to this [m]; ODE only
};

/// Everything that decides the outcome of a trial.
struct TrialConfig {
  Engine engine = Engine::slice;
  gait_state::GaitChoice controller;
  const RobotModel* robot = nullptr;  ///< of the ODE engine, not null there
  std::string terrain;                ///< as the engine spells it: "flat", "boxes:0.05"
  std::uint64_t seed = 0;             ///< of terrain and start
  Limits limits;
};

/// Names of the cells that run() returns, units in the names. The first is the speed.
[[nodiscard]] const std::vector<std::string>& columns(Engine engine);

/// Runs one trial: a pure function, the same bytes in every process.
/// @returns the cells, one per column, joined by commas; what was not reached is empty
[[nodiscard]] std::string run(const TrialConfig& config);

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

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <hexagait/sweep/engine.hpp>

namespace hexagait::sweep {

/// A robot of a sweep. Only the ODE engine has a choice; the others have one, without a model.
struct Robot {
  std::string name;  ///< as the sweep file spells it
  RobotModel model;
};

/// A grid of trials: robots × plants × terrains × seeds × controllers, the last varying fastest, so that the
/// trials that are compared are neighbours.
struct Sweep {
  Engine engine = Engine::slice;
  std::vector<gait_state::GaitChoice> controllers;
  std::vector<Robot> robots;
  std::vector<recording::PlantSetup> plants = {{}};  ///< how ideal the robots are; ODE only
  std::vector<Ground> terrains;
  std::uint64_t num_seeds = 0;       ///< seeds drawn from the master seed, …
  std::vector<std::uint64_t> seeds;  ///< … unless they are listed here
  std::uint64_t master_seed = 1;
  Limits limits;
  std::string measure;  ///< the column that a report is about
};

/// Where a trial is in the grid.
struct GridPoint {
  std::size_t robot = 0, plant = 0, terrain = 0, controller = 0;
  std::uint64_t seed_index = 0;

  friend bool operator==(const GridPoint&, const GridPoint&) = default;
};

/// Number of trials; they are numbered from 0.
[[nodiscard]] std::uint64_t num_trials(const Sweep& sweep);

/// Place of trial k: a bijection of 0 … num_trials − 1 and the grid.
[[nodiscard]] GridPoint grid_point(const Sweep& sweep, std::uint64_t k);

/// The seed that all controllers, robots and plants share on a terrain: the listed one, or 48 bits from
/// (master seed, terrain's name, seed index), so that further terrains or seeds move no other.
[[nodiscard]] std::uint64_t seed(const Sweep& sweep, const GridPoint& point);

/// What trial k simulates.
[[nodiscard]] TrialConfig trial(const Sweep& sweep, std::uint64_t k);

/// Columns of trials.csv before those of the engine.
inline constexpr const char* kGridColumns =
    "trial,controller,robot,plant,terrain,roughness,seed,outcome,reason";

/// First line of trials.csv, and the row of trial k, which is run for it; without line ends. What
/// the trial throws makes a row without a result.
[[nodiscard]] std::string csv_header(const Sweep& sweep);
[[nodiscard]] std::string row(const Sweep& sweep, std::uint64_t k);

/// The row of trial k if it has no result.
[[nodiscard]] std::string row_without_result(const Sweep& sweep, std::uint64_t k, Outcome outcome,
                                             std::string_view reason);

/// Whether a row, or the journal's line of it, is one of those.
[[nodiscard]] bool has_no_result(std::string_view row);

/// A part of a sweep for one of several machines: every count-th group of trials that share robot,
/// terrain and seed, from group index on. Within a shard trials have positions 0, 1, ….
struct Shard {
  std::uint64_t index = 0;  ///< 0 … count − 1; on the command line 1 … count
  std::uint64_t count = 1;

  friend bool operator==(const Shard&, const Shard&) = default;
};

/// Number of trials of a shard.
[[nodiscard]] std::uint64_t num_trials(const Sweep& sweep, const Shard& shard);

/// Number of the trial at a position of a shard, in rising order.
[[nodiscard]] std::uint64_t trial_at(const Sweep& sweep, const Shard& shard,
                                     std::uint64_t position);

/// Finds the URDF of a robot by its name or path. @throws InvalidInput
using RobotFinder = std::function<std::string(const std::string& robot)>;

/// Reads a sweep file: see docs/sweeps.md.
/// @throws InvalidInput  with everything that is wrong, each with file, line and column
[[nodiscard]] Sweep load_sweep(const std::string& path, const RobotFinder& robot_file);

}  // namespace hexagait::sweep

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <hexagait/sim/fnv1a.hpp>
#include <hexagait/sim/random.hpp>
#include <hexagait/sweep/sweep.hpp>

namespace hexagait::sweep {
namespace {

std::uint64_t seeds_per_terrain(const Sweep& sweep) {
  return sweep.seeds.empty() ? sweep.num_seeds : sweep.seeds.size();
}

// Trials that share robot, plant, terrain and seed.
std::uint64_t num_groups(const Sweep& sweep) {
  return sweep.robots.size() * sweep.plants.size() * sweep.terrains.size() *
         seeds_per_terrain(sweep);
}

// The cells that say which trial it is, each with its comma.
std::string grid_cells(const Sweep& sweep, std::uint64_t k) {
  const GridPoint at = grid_point(sweep, k);
  const Ground& ground = sweep.terrains[at.terrain];
  std::string terrain = ground.terrain;
  std::ranges::replace(terrain, ',', ';');  // which the terrain grammar reads as well
  return fmt::format("{},{},{},{},{},{},{},", k, to_string(sweep.controllers[at.controller]),
                     sweep.robots[at.robot].name, sweep.plants[at.plant].name, terrain,
                     ground.roughness, seed(sweep, at));
}

}  // namespace

std::uint64_t num_trials(const Sweep& sweep) {
  return num_groups(sweep) * sweep.controllers.size();
}

GridPoint grid_point(const Sweep& sweep, std::uint64_t k) {
  const std::uint64_t seeds = seeds_per_terrain(sweep), controllers = sweep.controllers.size();
  const std::uint64_t group = k / controllers, place = group / seeds;
  return {.robot = place / sweep.terrains.size() / sweep.plants.size(),
          .plant = place / sweep.terrains.size() % sweep.plants.size(),
          .terrain = place % sweep.terrains.size(),
          .controller = k % controllers,
          .seed_index = group % seeds};
}

std::uint64_t seed(const Sweep& sweep, const GridPoint& point) {
  if (!sweep.seeds.empty()) return sweep.seeds[point.seed_index];
  const auto terrain = static_cast<std::uint32_t>(fnv1a(sweep.terrains[point.terrain].terrain));
  const double u = random_u01(sweep.master_seed, RandomStream::seeds, terrain, point.seed_index);
  return static_cast<std::uint64_t>(std::ldexp(u, 48));
}

TrialConfig trial(const Sweep& sweep, std::uint64_t k) {
  const GridPoint at = grid_point(sweep, k);
  return {.engine = sweep.engine,
          .controller = sweep.controllers[at.controller],
          .robot = &sweep.robots[at.robot].model,
          .plant = sweep.plants[at.plant],
          .terrain = sweep.terrains[at.terrain].terrain,
          .seed = seed(sweep, at),
          .limits = sweep.limits};
}

std::string csv_header(const Sweep& sweep) {
  std::string text = kGridColumns;
  for (const Column& column : columns(sweep.engine)) text += ',' + column.name;
  return text;
}

std::string row(const Sweep& sweep, std::uint64_t k) {
  std::string reason = "an exception that is not std::exception";
  try {
    return grid_cells(sweep, k) + run(trial(sweep, k));
  } catch (const std::exception& error) {
    reason = error.what();
  } catch (...) {
  }
  return row_without_result(sweep, k, Outcome::failed, reason);
}

std::string row_without_result(const Sweep& sweep, std::uint64_t k, Outcome outcome,
                               std::string_view reason) {
  return grid_cells(sweep, k) + no_result(sweep.engine, outcome, reason);
}

bool has_no_result(std::string_view row) {
  for (int comma = 0; comma < 7; ++comma) row.remove_prefix(row.find(',') + 1);
  return row.starts_with("failed,") || row.starts_with("timed_out,");
}

std::uint64_t num_trials(const Sweep& sweep, const Shard& shard) {
  const std::uint64_t groups = num_groups(sweep);
  const std::uint64_t own = groups / shard.count + (shard.index < groups % shard.count ? 1 : 0);
  return own * sweep.controllers.size();
}

std::uint64_t trial_at(const Sweep& sweep, const Shard& shard, std::uint64_t position) {
  const std::uint64_t controllers = sweep.controllers.size();
  const std::uint64_t group = position / controllers * shard.count + shard.index;
  return group * controllers + position % controllers;
}

}  // namespace hexagait::sweep

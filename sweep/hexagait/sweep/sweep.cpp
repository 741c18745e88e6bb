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

// Trials that share robot, terrain and seed.
std::uint64_t num_groups(const Sweep& sweep) {
  return sweep.robots.size() * sweep.terrains.size() * seeds_per_terrain(sweep);
}

}  // namespace

std::uint64_t num_trials(const Sweep& sweep) {
  return num_groups(sweep) * sweep.controllers.size();
}

Cell cell(const Sweep& sweep, std::uint64_t k) {
  const std::uint64_t seeds = seeds_per_terrain(sweep), controllers = sweep.controllers.size();
  const std::uint64_t group = k / controllers, place = group / seeds;
  return {.robot = place / sweep.terrains.size(),
          .terrain = place % sweep.terrains.size(),
          .controller = k % controllers,
          .seed_index = group % seeds};
}

std::uint64_t trial_number(const Sweep& sweep, const Cell& cell) {
  const std::uint64_t place = cell.robot * sweep.terrains.size() + cell.terrain;
  const std::uint64_t group = place * seeds_per_terrain(sweep) + cell.seed_index;
  return group * sweep.controllers.size() + cell.controller;
}

std::uint64_t seed(const Sweep& sweep, const Cell& cell) {
  if (!sweep.seeds.empty()) return sweep.seeds[cell.seed_index];
  const auto terrain = static_cast<std::uint32_t>(fnv1a(sweep.terrains[cell.terrain].terrain));
  const double u = random_u01(sweep.master_seed, RandomStream::seeds, terrain, cell.seed_index);
  return static_cast<std::uint64_t>(std::ldexp(u, 48));
}

TrialConfig trial(const Sweep& sweep, std::uint64_t k) {
  const Cell at = cell(sweep, k);
  return {.engine = sweep.engine,
          .controller = sweep.controllers[at.controller],
          .robot = &sweep.robots[at.robot].model,
          .terrain = sweep.terrains[at.terrain].terrain,
          .seed = seed(sweep, at),
          .limits = sweep.limits};
}

std::string header(const Sweep& sweep) {
  return fmt::format("trial,controller,robot,terrain,roughness,seed,{}",
                     fmt::join(columns(sweep.engine), ","));
}

std::string row(const Sweep& sweep, std::uint64_t k) {
  const Cell at = cell(sweep, k);
  const TrialConfig config = trial(sweep, k);
  return fmt::format("{},{},{},{},{},{},{}", k, to_string(config.controller),
                     sweep.robots[at.robot].name, config.terrain,
                     sweep.terrains[at.terrain].roughness, config.seed, run(config));
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

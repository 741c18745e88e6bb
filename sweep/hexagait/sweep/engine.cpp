// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <hexagait/recording/genghis.hpp>
#include <hexagait/recording/simulation.hpp>
#include <hexagait/sim2d/slice_model.hpp>
#include <hexagait/sweep/engine.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <optional>

namespace hexagait::sweep {
namespace {

// A cell that may be empty.
std::string optional(const std::optional<int>& value) {
  return value ? std::to_string(*value) : "";
}

// ---- slice ------------------------------------------------------------------------------------

const std::vector<std::string> kSliceColumns = {"speed_units_per_slice",
                                                "fraction_of_bound",
                                                "tripod_after_slices",
                                                "steps",
                                                "step_time_slices",
                                                "sweep_units",
                                                "hash"};

sim2d::SliceTerrain slice_terrain(const std::string& text) {
  if (const auto terrain = sim2d::parse_slice_terrain(text)) return *terrain;
  throw InvalidInput(
      fmt::format("the slice model has no terrain '{}'; it has {}", text, sim2d::kSliceTerrains));
}

double slice_roughness(const sim2d::SliceTerrain& terrain) {
  using Kind = sim2d::SliceTerrain::Kind;
  if (terrain.kind == Kind::flat) return 0.0;
  if (terrain.kind == Kind::profile) return terrain.roughness;
  return 0.5 * (terrain.descent_max - terrain.descent_min);
}

std::string run_slice(const TrialConfig& config) {
  const sim2d::SliceSummary s = sim2d::run_slices({.gait = config.controller,
                                                   .terrain = slice_terrain(config.terrain),
                                                   .slices = config.limits.slices},
                                                  {.seed = config.seed});
  return fmt::format("{},{},{},{},{},{},{:016x}", s.speed, s.fraction_of_bound(),
                     s.tripod_after < 0 ? "" : std::to_string(s.tripod_after), s.lifts, s.step_time,
                     s.sweep, s.hash);
}

// ---- box2d ------------------------------------------------------------------------------------

const std::vector<std::string> kGenghisColumns = {
    "speed_m_s",      "walked_to_end",      "fell",   "stuck",         "seconds",  "distance_m",
    "steps",          "tripod_after_steps", "slip_m", "pitch_max_rad", "searches", "blocked",
    "contact_losses", "rule1_violations",   "hash"};

std::string run_genghis(const TrialConfig& config) {
  sim2d::GenghisTrial trial;
  trial.terrain = sim2d::parse_terrain2d(config.terrain);
  trial.gait = config.controller;
  trial.seed = config.seed;
  trial.seconds = config.limits.seconds;
  trial.random_posture = config.limits.random_posture;
  if (config.limits.distance > 0.0) trial.distance = config.limits.distance;

  const recording::GenghisSummary s = recording::simulate(trial);
  return fmt::format("{},{:d},{:d},{:d},{},{},{},{},{},{},{},{},{},{},{:016x}", s.speed, s.ok(),
                     s.fell, s.stuck, s.seconds, s.distance, s.steps,
                     optional(s.tripod_after_steps), s.slip_mean, s.pitch_max, s.side_view.searches,
                     s.side_view.blocked, s.contact_losses, s.rule1_violations, s.state_hash);
}

// ---- ode --------------------------------------------------------------------------------------

const std::vector<std::string> kOdeColumns = {"speed_m_s",
                                              "walked_to_end",
                                              "fell",
                                              "stuck",
                                              "fault",
                                              "seconds",
                                              "distance_m",
                                              "steps",
                                              "tripod_after_steps",
                                              "lateral_max_m",
                                              "heading_max_rad",
                                              "slip_mean_m",
                                              "margin_min_m",
                                              "rule1_violations",
                                              "hash"};

std::string run_ode(const TrialConfig& config) {
  recording::Simulation simulation;
  simulation.terrain = sim3d::parse_terrain(config.terrain);
  simulation.seed = config.seed;
  simulation.gait = config.controller;
  simulation.random_posture = config.limits.random_posture;
  simulation.trial.schedule = {{0.0, heading_control::Heading::straight(0.0)}};
  simulation.trial.seconds = config.limits.seconds;
  if (config.limits.distance > 0.0) simulation.trial.distance = config.limits.distance;

  const walk::Summary s = recording::simulate(*config.robot, simulation);
  return fmt::format("{},{:d},{:d},{:d},{},{},{},{},{},{},{},{},{},{},{:016x}", s.speed, s.ok(),
                     s.fell, s.stuck, footstep_gen::to_string(s.fault), s.seconds, s.distance,
                     s.steps, optional(s.tripod_after_steps), s.lateral_max, s.heading_max,
                     s.slip_mean, s.margin_min, s.rule1_violations, s.state_hash);
}

}  // namespace

std::string_view to_string(Engine engine) {
  switch (engine) {
    case Engine::slice:
      return "slice";
    case Engine::box2d:
      return "box2d";
    case Engine::ode:
      return "ode";
  }
  return "";
}

const std::vector<std::string>& columns(Engine engine) {
  switch (engine) {
    case Engine::slice:
      return kSliceColumns;
    case Engine::box2d:
      return kGenghisColumns;
    case Engine::ode:
      break;
  }
  return kOdeColumns;
}

std::string run(const TrialConfig& config) {
  switch (config.engine) {
    case Engine::slice:
      return run_slice(config);
    case Engine::box2d:
      return run_genghis(config);
    case Engine::ode:
      return run_ode(config);
  }
  return "";
}

const std::vector<std::string>& rough_terrains(Engine engine) {
  static const std::vector<std::string> slice = {"profile"}, genghis = {"rough", "step", "steps"},
                                        ode = {"boxes", "steps"};
  switch (engine) {
    case Engine::slice:
      return slice;
    case Engine::box2d:
      return genghis;
    case Engine::ode:
      break;
  }
  return ode;
}

Ground ground(Engine engine, const std::string& terrain) {
  if (engine == Engine::slice) {
    const sim2d::SliceTerrain slices = slice_terrain(terrain);
    return {to_string(slices), slice_roughness(slices)};
  }
  if (engine == Engine::box2d) {
    const sim2d::TerrainSpec2d spec = sim2d::parse_terrain2d(terrain);
    return {to_string(spec), spec.height};
  }
  const sim3d::TerrainSpec spec = sim3d::parse_terrain(terrain);
  return {to_string(spec), spec.height};
}

}  // namespace hexagait::sweep

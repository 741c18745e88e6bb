// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
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

// Empty if it was not measured.
std::string number(double value) { return std::isnan(value) ? "" : fmt::format("{}", value); }

// How a walk of either simulator ended.
Outcome outcome(const walk::Summary& s, const Limits& limits) {
  if (s.fell) return Outcome::fell;
  if (s.stuck) return Outcome::stuck;
  if (s.fault != footstep_gen::Fault::none) return Outcome::fault;
  if (limits.distance <= 0.0) return Outcome::walked;
  return s.arrived ? Outcome::arrived : Outcome::late;
}

bool to_the_end(Outcome outcome) {
  return outcome == Outcome::arrived || outcome == Outcome::walked;
}

// Empty if no distance was asked for.
std::string arrived(const walk::Summary& s, const Limits& limits) {
  return limits.distance <= 0.0 ? "" : s.arrived ? "1" : "0";
}

// ---- slice ------------------------------------------------------------------------------------

const std::vector<Column> kSliceColumns = {
    {"speed_units_per_slice", "speed", "units per slice"},
    {"fraction_of_bound", "speed / theoretical bound", ""},
    {"tripod_after_slices", "slices before the tripod gait", "slices"},
    {"steps", "steps", ""},
    {"step_time_slices", "time of a step", "slices"},
    {"stroke_units", "stroke", "units"},
    {"hash", "hash", ""}};

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
  return fmt::format("{},,{},{},{},{},{},{},{:016x}", to_string(Outcome::walked), s.speed,
                     s.fraction_of_bound(),
                     s.tripod_after < 0 ? "" : std::to_string(s.tripod_after), s.lifts, s.step_time,
                     s.stroke, s.hash);
}

// ---- box2d and ode: walks with one referee ------------------------------------------------------

// The columns of every walk, with those of one simulator between them.
std::vector<Column> walk_columns(const std::vector<Column>& own) {
  std::vector<Column> columns = {{"speed_m_s", "speed", "m/s"},
                                 {"walked_to_end", "walked to the end", "", true},
                                 {"arrived", "arrived", "", true},
                                 {"fell", "fell", "", true},
                                 {"stuck", "stuck", "", true},
                                 {"seconds", "time walked", "s"},
                                 {"distance_m", "distance", "m"},
                                 {"steps", "steps", ""},
                                 {"tripod_after_steps", "steps before the tripod gait", ""}};
  columns.insert(columns.end(), own.begin(), own.end());
  columns.push_back({"rule1_violations", "violations of rule 1", ""});
  columns.push_back({"hash", "hash", ""});
  return columns;
}

// A text as one cell.
std::string cell(std::string_view text) {
  std::string plain;
  for (const char letter : text.substr(0, 200)) {
    const bool printed =
        static_cast<unsigned char>(letter) >= 0x20 && letter != ',' && letter != '"';
    plain += printed ? letter : letter == ',' ? ';' : ' ';
  }
  return plain;
}

// The cells of these columns; `own` are those of one simulator, with commas between them.
// @param hindrance  why it is stuck, if it is
std::string walk_row(const walk::Summary& s, const Limits& limits, const std::string& hindrance,
                     const std::string& own) {
  const bool fault = s.fault != footstep_gen::Fault::none;
  const Outcome end = outcome(s, limits);
  std::string why;
  if (fault)
    why = footstep_gen::to_string(s.fault);
  else if (end == Outcome::stuck)
    why = hindrance;
  else if (end == Outcome::fell)
    why = fall_in_words(s);
  return fmt::format("{},{},{},{:d},{},{:d},{:d},{},{},{},{},{},{},{:016x}", to_string(end),
                     cell(why), s.speed, to_the_end(end), arrived(s, limits), s.fell, s.stuck,
                     s.seconds, s.distance, s.steps, optional(s.tripod_after_steps), own,
                     s.rule1_violations, s.state_hash);
}

// ---- box2d ------------------------------------------------------------------------------------

const std::vector<Column> kGenghisColumns =
    walk_columns({{"slip_m", "slip per step", "m"},
                  {"pitch_max_rad", "largest pitch", "rad"},
                  {"searches", "searches for ground", ""},
                  {"blocked", "blocked advances", ""},
                  {"contact_losses", "contact losses", ""},
                  {"real_contact_losses", "real contact losses", ""}});

std::string run_genghis(const TrialConfig& config) {
  sim2d::GenghisTrial trial;
  trial.terrain = sim2d::parse_terrain2d(config.terrain);
  trial.gait = config.controller;
  trial.seed = config.seed;
  trial.seconds = config.limits.seconds;
  trial.random_posture = config.limits.random_posture;
  if (config.limits.distance > 0.0) trial.distance = config.limits.distance;

  const recording::GenghisSummary s = recording::simulate(trial);
  return walk_row(s, config.limits, "",
                  fmt::format("{},{},{},{},{},{}", s.slip_mean, s.pitch_max, s.side_view.searches,
                              s.side_view.blocked, s.contact_losses, s.real_contact_losses));
}

// ---- ode --------------------------------------------------------------------------------------

const std::vector<Column> kOdeColumns =
    walk_columns({{"lateral_mean_m", "mean lateral error", "m"},
                  {"lateral_max_m", "largest lateral error", "m"},
                  {"heading_max_rad", "largest heading error", "rad"},
                  {"slip_mean_m", "slip per stance", "m"},
                  {"slip_p95_m", "slip per stance, 95th percentile", "m"},
                  {"touchdown_p95_m_s", "speed of touchdowns, 95th percentile", "m/s"},
                  {"margin_min_m", "least stability margin", "m"},
                  {"cost_of_transport", "cost of transport", ""},
                  {"neighbour_flight_s", "two neighbours off the ground", "s"},
                  {"contact_losses", "contact losses", ""},
                  {"real_contact_losses", "real contact losses", ""}});

std::string run_ode(const TrialConfig& config) {
  recording::Simulation simulation;
  simulation.terrain = sim3d::parse_terrain(config.terrain);
  simulation.seed = config.seed;
  simulation.plant = config.plant;
  simulation.gait = config.controller;
  simulation.random_posture = config.limits.random_posture;
  simulation.trial.schedule = {{0.0, heading_control::Heading::straight(0.0)}};
  simulation.trial.seconds = config.limits.seconds;
  if (config.limits.distance > 0.0) simulation.trial.distance = config.limits.distance;

  const walk::Summary s = recording::simulate(*config.robot, simulation);
  return walk_row(s, config.limits, cause_in_words(s.hindrance, *config.robot),
                  fmt::format("{},{},{},{},{},{},{},{},{},{},{}", s.lateral_mean, s.lateral_max,
                              s.heading_max, s.slip_mean, number(s.slip_p95),
                              number(s.touchdown_p95), s.margin_min, number(s.cost_of_transport),
                              s.neighbour_flight, s.contact_losses, s.real_contact_losses));
}

// ---- all of them --------------------------------------------------------------------------------

Ground slice_ground(const std::string& text) {
  const sim2d::SliceTerrain terrain = slice_terrain(text);
  return {to_string(terrain), slice_roughness(terrain)};
}

Ground genghis_ground(const std::string& text) {
  const sim2d::TerrainSpec2d spec = sim2d::parse_terrain2d(text);
  return {to_string(spec), spec.height};
}

Ground ode_ground(const std::string& text) {
  const sim3d::TerrainSpec spec = sim3d::parse_terrain(text);
  static_cast<void>(sim3d::Terrain(spec, 1));  // its file can be read
  return {to_string(spec), spec.roughness()};
}

struct Simulator {
  std::string_view name, roughness_label;
  const std::vector<Column>& columns;
  std::vector<std::string> rough_terrains;
  Ground (*ground)(const std::string& terrain);
  std::string (*run)(const TrialConfig& config);
};

const Simulator& of(Engine engine) {
  constexpr std::string_view kHeight = "height of the roughness [m]";
  static const std::array<Simulator, kEngines.size()> all = {
      {{"slice",
        "roughness [units per slice]",
        kSliceColumns,
        {"profile"},
        slice_ground,
        run_slice},
       {"box2d", kHeight, kGenghisColumns, {"rough", "step", "steps"}, genghis_ground, run_genghis},
       {"ode",
        kHeight,
        kOdeColumns,
        {"boxes", "steps", "step", "stairs", "waves", "ramps", "rubble"},
        ode_ground,
        run_ode}}};
  return all[static_cast<std::size_t>(engine)];
}

}  // namespace

std::string_view to_string(Engine engine) { return of(engine).name; }

std::string_view to_string(Outcome outcome) {
  constexpr std::array<std::string_view, kOutcomes.size()> kNames = {
      "arrived", "walked", "late", "fell", "stuck", "fault", "failed", "timed_out"};
  return kNames[static_cast<std::size_t>(outcome)];
}

std::string_view roughness_label(Engine engine) { return of(engine).roughness_label; }

const std::vector<Column>& columns(Engine engine) { return of(engine).columns; }

const std::vector<std::string>& rough_terrains(Engine engine) { return of(engine).rough_terrains; }

Ground ground(Engine engine, const std::string& terrain) { return of(engine).ground(terrain); }

std::string run(const TrialConfig& config) { return of(config.engine).run(config); }

std::string no_result(Engine engine, Outcome outcome, std::string_view reason) {
  return fmt::format("{},{}", to_string(outcome), cell(reason)) +
         std::string(columns(engine).size(), ',');
}

}  // namespace hexagait::sweep

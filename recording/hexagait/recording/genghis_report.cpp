// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <hexagait/recording/genghis_report.hpp>
#include <hexagait/recording/version.hpp>
#include <nlohmann/json.hpp>

namespace hexagait::recording {
namespace {

using Json = nlohmann::ordered_json;
using sim2d::GenghisSummary;

double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

std::string ground(const sim2d::TerrainSpec2d& terrain) {
  return terrain.kind == sim2d::TerrainSpec2d::Kind::flat ? "on flat ground"
                                                          : "over " + sim2d::to_string(terrain);
}

std::string tripod(const GenghisSummary& s) {
  if (!s.tripod_after_steps) return "no tripod gait found";
  return *s.tripod_after_steps == 0 ? "tripod gait from the first"
                                    : fmt::format("tripod gait after {}", *s.tripod_after_steps);
}

void add(std::string& text, const char* label, const std::string& value) {
  text += fmt::format("  {:<12}{}\n", label, value);
}

}  // namespace

std::string to_json(const GenghisReport& report) {
  const sim2d::GenghisTrial& t = report.trial;
  const GenghisSummary& s = report.summary;
  return Json{{"robot", "genghis2d"},
              {"terrain", sim2d::to_string(t.terrain)},
              {"seed", t.seed},
              {"gait", gait_state::to_string(t.gait)},
              {"heading", "straight"},
              {"crab_rad", t.backward ? std::numbers::pi : 0.0},
              {"seconds_asked", t.seconds},
              {"distance_asked_m", finite(t.distance)},
              {"random_posture_m", t.random_posture},
              {"physics_step_s", t.physics_dt},
              {"control_period_s", t.control_dt},
              {"seconds", s.seconds},
              {"distance_m", s.distance},
              {"speed_m_s", s.speed},
              {"slip_m", {{"mean", s.slip_mean}}},
              {"pitch_rad", {{"max", s.pitch_max}}},
              {"body_height_m", {{"min", s.height_min}, {"max", s.height_max}}},
              {"body_contact_s", s.body_contact_time},
              {"steps", s.steps},
              {"tripod_after_steps", s.tripod_after_steps ? Json(*s.tripod_after_steps) : Json()},
              {"rule1_violations", s.rule1_violations},
              {"neighbour_flight_s", s.neighbour_flight},
              {"contact_losses", s.contact_losses},
              {"blocked_advances", s.blocked},
              {"foothold_searches", s.searches},
              {"falls", s.fell ? 1 : 0},
              {"stuck", s.stuck},
              {"arrived", s.arrived},
              {"state_hash", fmt::format("{:016x}", s.state_hash)},
              {"real_time_factor", finite(s.real_time_factor)},
              {"interrupted", report.interrupted},
              {"version", kVersion}}
      .dump(2);
}

std::string headline(const GenghisReport& report) {
  const GenghisSummary& s = report.summary;
  std::string beginning = "Genghis walked";
  const std::string so_far = fmt::format("after {:.1f} s Genghis had walked", s.seconds);
  if (s.stuck) beginning = "Stuck, no progress for 30 s: " + so_far;
  if (s.fell) beginning = "Fell: " + so_far;
  if (report.interrupted) beginning = "Interrupted: " + so_far;
  const bool whole = !s.stuck && !s.fell && !report.interrupted;
  return fmt::format("{} {:.2f} m {} {}{}, at {:.1f} cm/s.", beginning, s.distance,
                     report.trial.backward ? "backwards" : "straight ahead",
                     ground(report.trial.terrain),
                     whole ? fmt::format(" in {:.3g} s", s.seconds) : "", 1e2 * s.speed);
}

std::string subtitle(const GenghisReport& report) {
  const GenghisSummary& s = report.summary;
  return fmt::format(
      "Side view in Box2D, {} gait, seed {} · {} steps, {} · slip {:.1f} mm per step · pitch up to "
      "{:.0f}°",
      gait_state::to_string(report.trial.gait), report.trial.seed, s.steps, tripod(s),
      1e3 * s.slip_mean, degrees(s.pitch_max));
}

std::string in_words(const GenghisReport& report) {
  const GenghisSummary& s = report.summary;
  std::string text = headline(report) + "\n";
  add(text, "gait", gait_state::to_string(report.trial.gait));
  add(text, "steps", fmt::format("{}; {}", s.steps, tripod(s)));
  add(text, "rule 1",
      fmt::format("broken {} times; two neighbours off the ground for {:.2f} s", s.rule1_violations,
                  s.neighbour_flight));
  add(text, "feet",
      fmt::format("slip {:.1f} mm per step; hold lost {} times", 1e3 * s.slip_mean,
                  s.contact_losses));
  add(text, "reflexes",
      fmt::format("advance blocked {} times; no ground within reach {} times", s.blocked,
                  s.searches));
  add(text, "body",
      fmt::format("hips at {:.3f} … {:.3f} m, pitch up to {:.1f}°; underside on the ground for "
                  "{:.1f} s",
                  s.height_min, s.height_max, degrees(s.pitch_max), s.body_contact_time));
  add(text, "speed", fmt::format("{:.0f} × real time", s.real_time_factor));
  return text;
}

}  // namespace hexagait::recording

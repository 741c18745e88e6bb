// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <hexagait/walk/paths/path_file.hpp>

namespace hexagait::app {
namespace {

using heading_control::Heading;
using heading_control::Turn;
using recording::Simulation;
using recording::WalkReport;
using walk::Summary;

std::string line(const Heading& heading) {
  const double crab = degrees(heading.crab_angle());
  const std::string crabbing =
      std::abs(crab) < 0.05 ? "" : fmt::format(", crabbing at {:.4g}°", crab);
  if (heading.curvature() == 0.0)
    return crabbing.empty() ? "straight ahead" : "straight" + crabbing + ",";
  return fmt::format("of a {}-hand arc (r = {:.3g} m{})", heading.radius() > 0.0 ? "left" : "right",
                     std::abs(heading.radius()), crabbing);
}

std::string walked(const Simulation& simulation, const Summary& s) {
  if (s.path)
    return fmt::format("followed {:.1f} m of a path of {:.1f} m", s.path->done, s.path->length);
  const walk::Schedule& schedule = simulation.trial.schedule;
  if (schedule.size() > 1)
    return fmt::format("walked {:.1f} m on {} commands", s.distance, schedule.size());
  const Heading& heading = schedule.front().heading;
  if (!heading.moving()) return "stood";
  if (heading.rho() <= 0.0)
    return fmt::format("turned {:.0f}° in place, to the {},", std::abs(degrees(s.turned)),
                       s.turned > 0.0 ? "left" : "right");
  return fmt::format("walked {:.1f} m {}", s.distance, line(heading));
}

std::string ending(const WalkReport& report) {
  const Summary& s = report.summary;
  const std::string so_far = fmt::format("after {:.1f} s it had ", s.seconds);
  if (report.interrupted) return "Interrupted: " + so_far;
  if (s.fell) return "Fell: " + so_far;
  if (s.stuck) return "Stuck, no more progress: " + so_far;
  if (s.fault != footstep_gen::Fault::none)
    return fmt::format("Stopped by a fault ({}): {}", footstep_gen::to_string(s.fault), so_far);
  if (!arrived(report) && s.path) return "Did not arrive at the end of its path: " + so_far;
  if (!arrived(report))
    return fmt::format("Did not arrive at {:.3g} m: {}", report.simulation.trial.distance, so_far);
  return "";
}

std::string gait(const Summary& s) {
  if (!s.tripod_after_steps) return "no tripod gait found";
  return *s.tripod_after_steps == 0 ? "tripod gait from the first"
                                    : fmt::format("tripod gait after {}", *s.tripod_after_steps);
}

void add_path(std::string& text, const walk::TrialOptions& trial, const walk::PathSummary& path) {
  add(text, "end of path",
      path.arrived ? fmt::format("{} off it", length(path.off_end)) : "not reached");
  add(text, "missed", fmt::format("no point of the path by more than {}", length(path.missed)));
  add(text, "believed",
      fmt::format("by its odometry off path by {} on average, at most {}",
                  length(path.believed_mean), length(path.believed_max)));
  add(text, "pursuit",
      fmt::format("facing {}, {} ahead, localised by {}", walk::to_string(trial.path->facing),
                  length(trial.path->look_ahead), walk::to_string(trial.localised_by)));
}

}  // namespace

void add(std::string& text, const char* label, const std::string& value) {
  text += fmt::format("  {:<12}{}\n", label, value);
}

// Two or three digits are enough for a person. The stability margin
// is −∞ with no foot on the ground.
std::string length(double metres) {
  const double size = std::abs(metres);
  if (std::isinf(size)) return "none";
  if (size < 0.00995) return fmt::format("{:.1f} mm", 1e3 * metres);
  if (size < 0.995) return fmt::format("{:.1f} cm", 1e2 * metres);
  return fmt::format("{:.2f} m", metres);
}

std::string ground(const std::string& terrain) {
  return terrain == "flat" ? "on flat ground" : "over " + terrain;
}

std::string headline(const WalkReport& report) {
  const Summary& s = report.summary;
  std::string sentence = ending(report);
  const bool whole = sentence.empty();
  sentence += walked(report.simulation, s) + " " + ground(terrain_of(report));
  if (whole) {
    sentence.front() = static_cast<char>(std::toupper(sentence.front()));
    sentence += fmt::format(" in {:.3g} s", s.seconds);
  }
  if (report.side_view) return sentence + ".";
  return sentence + fmt::format("; never more than {} off {}.", length(s.lateral_max),
                                s.path ? "it" : "the commanded path");
}

bool arrived(const WalkReport& report) {
  const walk::TrialOptions& trial = report.simulation.trial;
  return report.summary.arrived || (!trial.path && !std::isfinite(trial.distance));
}

std::string subtitle(const WalkReport& report) {
  const Summary& s = report.summary;
  if (report.side_view)
    return fmt::format(
        "{}, a plane robot in Box2D, seed {} · {:.3f} m/s · {} steps · slip {} per stance · pitch "
        "up "
        "to {:.0f}°",
        report.robot, report.simulation.seed, s.speed, s.steps, length(s.slip_mean),
        degrees(s.pitch_max));
  return fmt::format(
      "{}, seed {} · {:.3f} m/s · mean distance from the path {} · {} steps · slip {} per stance · "
      "stability margin ≥ {}",
      report.robot, report.simulation.seed, s.speed, length(s.lateral_mean), s.steps,
      length(s.slip_mean), length(s.margin_min));
}

std::string in_words(const WalkReport& report) {
  const Summary& s = report.summary;
  std::string text = headline(report) + "\n";
  add(text, "path",
      fmt::format("{:.2f} m at {:.3f} m/s; turned {:.1f}°", s.distance, s.speed,
                  degrees(s.turned)));
  if (!report.side_view) {
    add(text, "off path",
        fmt::format("mean {}, max {}, at the end {}", length(s.lateral_mean), length(s.lateral_max),
                    length(s.lateral_end)));
    add(text, "off heading",
        fmt::format("max {:.1f}°, at the end {:.1f}°", degrees(s.heading_max),
                    degrees(s.heading_end)));
    add(text, "odometry",
        fmt::format("{} and {:.1f}° from the truth at the end", length(s.odometry_position),
                    std::abs(degrees(s.odometry_heading))));
  }
  if (s.path) add_path(text, report.simulation.trial, *s.path);
  if (s.fell) add(text, "fell", fall_in_words(s));
  if (!report.hindrance.empty()) add(text, "stuck", report.hindrance);
  for (const std::string& found : report.found) add(text, "found", found);
  if (report.simulation.plant.name != "ideal") add(text, "plant", report.simulation.plant.name);
  add(text, "gait", gait_state::to_string(report.simulation.gait));
  add(text, "steps", fmt::format("{}; {}", s.steps, gait(s)));
  add(text, "rule 1",
      fmt::format("{} lifts beside a leg off the ground; two neighbours off it for {:.2f} s",
                  s.rule1_violations, s.neighbour_flight));
  add(text, "feet",
      fmt::format("slip {} mean, {} at the 95th percentile of {} stances; contact "
                  "lost {} times, {} of them really; legs touch the ground for {:.2f} s",
                  length(s.slip_mean), length(s.slip_p95), s.stances, s.contact_losses,
                  s.real_contact_losses, s.leg_touch_time));
  if (std::isfinite(s.touchdown_p95))
    add(text, "touchdowns",
        fmt::format("at {:.2f} m/s, the median, and {:.2f} m/s, the 95th percentile",
                    s.touchdown_median, s.touchdown_p95));
  add(text, "body",
      fmt::format("height {:.3f} … {:.3f} m, roll up to {:.1f}°, pitch up to {:.1f}°", s.height_min,
                  s.height_max, degrees(s.roll_max), degrees(s.pitch_max)));
  if (report.side_view)
    add(text, "reflexes",
        fmt::format("advance blocked {} times; no ground within reach {} times; underside on the "
                    "ground for {:.1f} s",
                    report.side_view->blocked, report.side_view->searches,
                    report.side_view->underside_time));
  add(text, "stability",
      fmt::format("margin at least {}, at the 5th percentile {}", length(s.margin_min),
                  length(s.margin_p5)));
  const std::string tick =
      report.side_view ? ""
                       : fmt::format("; a tick of the controller takes {:.1f} µs (99 %: {:.1f} µs)",
                                     s.tick_median / 1e3, s.tick_p99 / 1e3);
  add(text, "speed", fmt::format("{:.1f} × real time{}", s.real_time_factor, tick));
  return text;
}

}  // namespace hexagait::app

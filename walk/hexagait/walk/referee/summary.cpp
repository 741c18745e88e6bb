// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <hexagait/walk/referee/summary.hpp>
#include <numbers>

namespace hexagait::walk {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

// What such a leg does, and what would help.
struct Advice {
  const char* what;
  const char* help;
};

Advice advice(LegPhase phase) {
  switch (phase) {
    case LegPhase::lift:
    case LegPhase::transfer:
    case LegPhase::retreat:
    case LegPhase::unload:
      return {"its way over is blocked or takes too long",
              "a higher step (--set step.height=…), or a tolerance above the error of its servos "
              "(--set swing.blocked_error=…)"};
    case LegPhase::descend:
    case LegPhase::search:
      return {"it finds no ground, or does not feel it",
              "a lower threshold of its contact sensor (--set plant.contact_threshold=…), or lower "
              "ground"};
    case LegPhase::support:
      return {
          "a neighbour is off the ground, or the base does not move",
          "a lower threshold of the contact sensors (--set plant.contact_threshold=…), a shorter "
          "stroke (--set step.stroke=…) or a smaller --set step.stability_margin=…"};
    case LegPhase::follow:
    case LegPhase::hold:
      return {"it is held in the air", "a new start"};
  }
  return {"", ""};
}

}  // namespace

std::string cause_in_words(const Hindrance& hindrance, const RobotModel& robot) {
  if (hindrance.no_ground > 0)
    return fmt::format(
        "leg {} has reached down in vain {}: {}", robot.legs[hindrance.leg].name,
        hindrance.no_ground == 1 ? "once" : fmt::format("{} times", hindrance.no_ground),
        advice(hindrance.phase).what);
  std::string tries;
  if (hindrance.retreats > 0)
    tries = hindrance.retreats == 1
                ? ", after a try that failed"
                : fmt::format(", after {} tries that failed", hindrance.retreats);
  const bool stands = hindrance.phase == LegPhase::support;
  return fmt::format("leg {} has {} for {:.1f} s{}: {}", robot.legs[hindrance.leg].name,
                     stands ? "not stepped" : "been off the ground", hindrance.seconds,
                     stands ? "" : tries, advice(hindrance.phase).what);
}

std::string fall_in_words(const Summary& summary) {
  if (!std::isfinite(summary.fall_tilt)) return "its simulated state is not finite";
  const double degrees = kDegrees * summary.fall_tilt;
  return summary.fall_tilt > kFallTilt
             ? fmt::format("its body tilted by {:.0f}°", degrees)
             : fmt::format("its body touched the ground, tilted by {:.0f}°", degrees);
}

std::string in_words(const Hindrance& hindrance, const RobotModel& robot) {
  return fmt::format("{}; what may help: {}", cause_in_words(hindrance, robot),
                     advice(hindrance.phase).help);
}

std::string in_words(const footstep_gen::Escape& escape, const RobotModel& robot) {
  std::string legs;
  for (LegId i = 0; i < robot.num_legs(); ++i)
    if (escape.failing.contains(i)) legs += (legs.empty() ? "" : ", ") + robot.legs[i].name;
  if (escape.phase == footstep_gen::EscapePhase::gave_up)
    return fmt::format("it stands: it did not get on, from {} other postures of its body either{}",
                       escape.tries, legs.empty() ? "" : "; no foothold found by " + legs);
  std::string way;
  const auto add = [&way](double centimetres, const char* positive, const char* negative) {
    if (std::abs(centimetres) < 0.5) return;
    way += fmt::format("{}{:.0f} cm {}", way.empty() ? "" : ", ", std::abs(centimetres),
                       centimetres > 0.0 ? positive : negative);
  };
  add(100.0 * escape.way.v.x(), "ahead", "back");
  add(100.0 * escape.way.v.y(), "left", "right");
  const double turn = kDegrees * escape.way.w;
  std::string what = way.empty() ? "" : "moves " + way;
  if (std::abs(turn) >= 0.5)
    what += fmt::format("{}turns {:.0f}° {}", what.empty() ? "" : ", ", std::abs(turn),
                        turn > 0.0 ? "left" : "right");
  return fmt::format("deadlock: body {}{}", what.empty() ? "stays" : what,
                     legs.empty() ? "" : "; after its neighbours steps " + legs);
}

std::vector<std::string> found_in_words(const Summary& summary, const RobotModel& robot) {
  const footstep_gen::LegFindings& found = summary.findings;
  std::vector<std::string> words;
  for (LegId i = 0; i < robot.num_legs(); ++i) {
    const std::string& leg = robot.legs[i].name;
    if (found.silent.contains(i))
      words.push_back(fmt::format("leg {} does not answer; it walks without", leg));
    if (found.stuck_closed.contains(i))
      words.push_back(fmt::format("contact of {} never opens; it is not believed", leg));
    if (found.stuck_open.contains(i))
      words.push_back(fmt::format("contact of {} never closes; it is not believed", leg));
    if (found.flickering.contains(i))
      words.push_back(fmt::format("contact of {} flickers; it is not believed", leg));
    if (found.noisy.contains(i))
      words.push_back(fmt::format("joints of {} are noisy; they are not believed", leg));
  }
  if (summary.very_rough > 0.0)
    words.push_back(fmt::format(
        "very rough ground for {:.1f} s: the free gait is a wave gait there", summary.very_rough));
  if (summary.escapes > 0) words.push_back(in_words(summary.escape, robot));
  if (summary.escapes > 1) words.back() += fmt::format(" (the last of {})", summary.escapes);
  if (summary.refused)
    words.emplace_back(
        "it stands: it does not walk with fewer than two legs on a side, or than four in all");
  return words;
}

}  // namespace hexagait::walk

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <hexagait/walk/summary.hpp>

namespace hexagait::walk {
namespace {

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
          "it stands and does not step: a neighbour is off the ground, or the base does not move",
          "a lower threshold of the contact sensors (--set plant.contact_threshold=…), a shorter "
          "stroke (--set step.stroke=…) or a smaller --set step.stability_margin=…"};
    case LegPhase::follow:
    case LegPhase::hold:
      return {"it is held in the air", "a new start"};
  }
  return {"", ""};
}

}  // namespace

std::string in_words(const Hindrance& hindrance, const RobotModel& robot) {
  const auto [what, help] = advice(hindrance.phase);
  const std::string collisions =
      hindrance.retreats > 0 ? fmt::format(", after {} collisions", hindrance.retreats) : "";
  return fmt::format("leg {} has been in {} for {:.1f} s{}: {}; what may help: {}",
                     robot.legs[hindrance.leg].name, to_string(hindrance.phase), hindrance.seconds,
                     collisions, what, help);
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
    if (found.noisy.contains(i))
      words.push_back(fmt::format("joints of {} are noisy; they are not believed", leg));
  }
  if (summary.refused)
    words.emplace_back(
        "it stands: it does not walk with fewer than two legs on a side, or than four in all");
  return words;
}

}  // namespace hexagait::walk

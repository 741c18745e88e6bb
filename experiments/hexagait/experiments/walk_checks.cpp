// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/experiments/walk_checks.hpp>

namespace hexagait::experiments {

using walk::Summary;

std::vector<SafetyCheck> no_fall_and_rule_1(std::span<const Summary> walks,
                                            double most_flight_percent, double most_lifts) {
  std::vector<SafetyCheck> checks = no_fall(walks);
  checks.emplace_back(Measured("lifts beside a leg that is off the ground, worst walk", "",
                               worst(walks, [](const Summary& s) { return s.rule1_violations; })),
                      at_most(most_lifts));
  checks.emplace_back(
      Measured(
          "two neighbours off the ground, worst walk", "% of the time",
          worst(walks, [](const Summary& s) { return 100.0 * s.neighbour_flight / s.seconds; })),
      at_most(most_flight_percent));
  return checks;
}

}  // namespace hexagait::experiments

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/experiments/walk_checks.hpp>

namespace hexagait::experiments {

using walk::Summary;

Measured worst_lifts(std::span<const Summary> walks) {
  return {"lifts beside a leg that is off the ground, worst walk", "",
          worst(walks, [](const Summary& s) { return s.rule1_violations; })};
}

std::vector<double> flight_percents(std::span<const Summary> walks) {
  return each(walks, [](const Summary& s) { return 100.0 * s.neighbour_flight / s.seconds; });
}

Measured worst_flight(std::span<const Summary> walks) {
  return {"two neighbours off the ground, worst walk", "% of the time",
          statistics::greatest(flight_percents(walks))};
}

std::vector<SafetyCheck> no_fall_and_rule_1(std::span<const Summary> walks,
                                            double most_flight_percent, double most_lifts) {
  std::vector<SafetyCheck> checks = no_fall(walks);
  checks.emplace_back(worst_lifts(walks), at_most(most_lifts));
  checks.emplace_back(worst_flight(walks), at_most(most_flight_percent));
  return checks;
}

std::vector<SafetyCheck> no_fall_on_rough_ground(std::span<const Summary> walks,
                                                 double most_flight_percent, double most_lifts) {
  std::vector<SafetyCheck> checks = no_fall(walks);
  checks.emplace_back(worst_lifts(walks), at_most(most_lifts));
  const Measured flight("two neighbours off the ground, mean of the walks", "% of the time",
                        statistics::estimate(flight_percents(walks)).mean);
  checks.emplace_back(flight, at_most(most_flight_percent));
  return checks;
}

}  // namespace hexagait::experiments

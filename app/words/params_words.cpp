// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "words/words.hpp"

namespace hexagait::app {

std::string params_in_words(const RobotModel& robot, RobotParams given) {
  const RobotScale scale = scale_of(robot);
  std::string text = fmt::format(
      "  parameters: size L {:.4g} m, reach of a step ℓ {:.4g} m, time T {:.4g} s; "
      "--set NAME=VALUE sets one\n",
      scale.size, scale.reach, scale.time);
  RobotParams all = completed(given, robot);
  for (const Parameter& one : parameters()) {
    const bool is_given = !is_derived(one.in(given));
    text += fmt::format(
        "  {:<32} {:>10.4g} {:<9}  {}\n", one.name, one.in(all), one.unit,
        is_given ? std::string("given") : fmt::format("{:g} {}", one.factor, symbol(one.of)));
  }
  return text;
}

}  // namespace hexagait::app

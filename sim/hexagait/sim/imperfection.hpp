// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/text/violations.hpp>
#include <span>
#include <string>

namespace hexagait {

/// What a number of a plant measures, and so the units in which it may be written.
enum class PlantUnit : std::uint8_t {
  number,        ///< such as a coefficient of friction
  share,         ///< a probability or a fraction
  angle,         ///< [rad]
  time,          ///< [s]
  force,         ///< [N]
  torque,        ///< [N m]
  inertia,       ///< [kg m²]
  acceleration,  ///< [m/s²]
  angular_rate,  ///< [rad/s]
};

/// "rad"; "1" for numbers and shares.
[[nodiscard]] constexpr const char* symbol(PlantUnit unit) {
  switch (unit) {
    case PlantUnit::number:
    case PlantUnit::share:
      return "1";
    case PlantUnit::angle:
      return "rad";
    case PlantUnit::time:
      return "s";
    case PlantUnit::force:
      return "N";
    case PlantUnit::torque:
      return "N m";
    case PlantUnit::inertia:
      return "kg m²";
    case PlantUnit::acceleration:
      return "m/s²";
    case PlantUnit::angular_rate:
      return "rad/s";
  }
  return "?";
}

/// A number by which a simulated plant differs from an ideal one: its name in files, messages and
/// (with dashes) on the command line, and the range that it must be in. One table of them per struct
/// serves C++, command line and sweep files alike.
template <class Params>
struct Imperfection {
  const char* name;
  double Params::*value;
  PlantUnit unit;
  double least, greatest;  ///< both are allowed
  const char* meaning;     ///< a line of --help
};

/// Adds those that are out of their range, each with name, unit, value and range.
template <class Params>
void check_ranges(Violations& violations, std::span<const Imperfection<Params>> all,
                  const Params& params) {
  for (const Imperfection<Params>& one : all) {
    const double value = params.*one.value;
    if (one.least <= value && value <= one.greatest) continue;
    violations.add(std::string(one.name) + " [" + symbol(one.unit) + "]",
                   in_words(value) + " must be finite and in [" + in_words(one.least) + ", " +
                       in_words(one.greatest) + "]");
  }
}

}  // namespace hexagait

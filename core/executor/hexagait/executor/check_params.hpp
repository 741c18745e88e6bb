// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/executor/executor.hpp>
#include <hexagait/text/violations.hpp>
#include <span>

namespace hexagait {

/// Adds the line "NAME: is VALUE; it must be …" unless `holds`.
void require(Violations& violations, const char* name, double value, bool holds,
             const char* must_be);

/// A parameter, by its name with unit.
struct NamedNumber {
  const char* name;
  double value;
};

/// The same for numbers that must be finite and greater than 0, or 0 or greater.
void require_positive(Violations& violations, std::span<const NamedNumber> numbers);
void require_not_negative(Violations& violations, std::span<const NamedNumber> numbers);

/// Adds what is wrong with the parameters that all controllers have: the control period, the longest
/// silence of the plant, and those of the executor.
void check_controller(Violations& violations, double control_dt, double late_limit,
                      const ExecutorParams& params);

}  // namespace hexagait

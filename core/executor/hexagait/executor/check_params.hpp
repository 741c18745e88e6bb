// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/executor/executor.hpp>
#include <hexagait/text/violations.hpp>

namespace hexagait {

/// Adds the line "NAME: is VALUE; it must be …" unless `holds`.
void require(Violations& violations, const char* name, double value, bool holds,
             const char* must_be);

/// Adds what is wrong with the parameters that all controllers have: the control period, the longest
/// silence of the plant, and those of the executor.
void check_controller(Violations& violations, double control_dt, double late_limit,
                      const ExecutorParams& params);

}  // namespace hexagait

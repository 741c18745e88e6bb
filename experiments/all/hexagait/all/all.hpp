// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/experiments/experiment.hpp>

namespace hexagait::experiments {

/// All experiments, in the order of the papers.
[[nodiscard]] const std::vector<Experiment>& experiments();

}  // namespace hexagait::experiments

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/experiments/experiment.hpp>

namespace hexagait::experiments {

/// What each imperfection costs, on flat ground and over boxes, in a ladder of sizes: up to which the
/// robot still walks. Writes sensitivity.csv, and sensitivity.md, which is docs/sensitivity.md.
Outcome sensitivity(const ExperimentContext& context, figures::StagedFiles& files);

}  // namespace hexagait::experiments

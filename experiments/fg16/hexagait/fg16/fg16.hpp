// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/experiments/experiment.hpp>

namespace hexagait::experiments {

/// Figures of [FG16]; their titles are in all.cpp.
Outcome fg16_fig6(const ExperimentContext& context, figures::StagedFiles& files);
Outcome fg16_fig7(const ExperimentContext& context, figures::StagedFiles& files);

}  // namespace hexagait::experiments

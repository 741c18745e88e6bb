// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/experiments/experiment.hpp>

namespace hexagait::experiments {

Outcome path(const ExperimentContext& context, figures::StagedFiles& files);

}  // namespace hexagait::experiments

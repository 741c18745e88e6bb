// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/experiments/experiment.hpp>

namespace hexagait::experiments {

/// Figures, tables and claims of [PC04]; their titles are in all.cpp.
Outcome table1(const ExperimentContext& context, figures::StagedFiles& files);
Outcome table2(const ExperimentContext& context, figures::StagedFiles& files);
Outcome fig3(const ExperimentContext& context, figures::StagedFiles& files);
Outcome fig4(const ExperimentContext& context, figures::StagedFiles& files);
Outcome fig6(const ExperimentContext& context, figures::StagedFiles& files);
Outcome fig7a(const ExperimentContext& context, figures::StagedFiles& files);
Outcome fig7b(const ExperimentContext& context, figures::StagedFiles& files);
Outcome fig7_physics(const ExperimentContext& context, figures::StagedFiles& files);
Outcome fig9(const ExperimentContext& context, figures::StagedFiles& files);
Outcome fig10(const ExperimentContext& context, figures::StagedFiles& files);
Outcome fig11(const ExperimentContext& context, figures::StagedFiles& files);
Outcome fig12(const ExperimentContext& context, figures::StagedFiles& files);
Outcome navigation(const ExperimentContext& context, figures::StagedFiles& files);
Outcome wave_family(const ExperimentContext& context, figures::StagedFiles& files);

}  // namespace hexagait::experiments

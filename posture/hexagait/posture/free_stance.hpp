// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/balance/stance_pose.hpp>

namespace hexagait::posture {

/// [PC04]'s pose adaptation as the strategy of scripted BaseAuto commands (PlannerParams::stance):
/// the base where the sum of squared distances of all feet in `reach` from the nominal stance is
/// least, in closed form (free_optimum()). The paper lets the feet alone decide: neither the margin
/// nor the legs' reach is kept, both are reported.
[[nodiscard]] StancePose free_stance(const RobotModel& model, const StanceProblem& problem);

}  // namespace hexagait::posture

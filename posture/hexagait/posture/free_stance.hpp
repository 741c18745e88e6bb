// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/balance/stance_pose.hpp>

namespace hexagait::posture {

/// [PC04]'s pose adaptation as a strategy of scripted BaseAuto commands (PlannerParams::stance):
/// the base pose with the least sum of squared distances of all feet in `reach` from the nominal
/// stance, in closed form (free_optimum()). As in the paper, neither stability margin nor reach
/// constrain the pose; both are reported.
[[nodiscard]] StancePose free_stance(const RobotModel& model, const StanceProblem& problem);

}  // namespace hexagait::posture

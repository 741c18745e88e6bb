// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/model/robot_model.hpp>
#include <hexagait/text/violations.hpp>

namespace hexagait {

/// Sets the nominal stance and the workspace of a leg. A yaw-pitch-pitch leg whose limits forbid the
/// place of nominal_foot() stands at the nearest place around it, inwards or outwards, up or down, or
/// turned about its yaw axis, with a workspace of at least 0.05 of its length.
/// @param violations  receives what keeps the leg from it, if there is no such place
void derive_stance(LegModel& leg, Violations& violations, std::vector<Substitution>& substitutions);

/// Feet stand on level ground: where nominal heights differ, all legs take the middle one's, at the
/// nearest place that they can.
/// @param violations  receives the heights that legs can't share
void share_ground(LegArray<LegModel>& legs, Violations& violations,
                  std::vector<Substitution>& substitutions);

}  // namespace hexagait

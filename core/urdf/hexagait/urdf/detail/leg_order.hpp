// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/model/robot_model.hpp>
#include <hexagait/text/violations.hpp>

namespace hexagait {

/// Left and right legs in turn, pairs from front to rear, by where the hips are.
/// @param violations  receives hips on the midline, and sides that differ in number
[[nodiscard]] LegArray<LegModel> in_leg_order(std::vector<LegModel> legs, Violations& violations);

/// Legs are commanded by their names. If two have one name, or two that differ only by what actions
/// may leave out, all are named by their places: LF RF, LM RM, LR RR; of more than three pairs L1 R1,
/// L2 R2, … from the front.
void make_names_unique(LegArray<LegModel>& legs, std::vector<Substitution>& substitutions);

}  // namespace hexagait

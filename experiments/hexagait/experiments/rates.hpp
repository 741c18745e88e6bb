// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/experiments/walks.hpp>

/// The same walks at other control periods, and the verdicts on them.
namespace hexagait::experiments {

/// Constant headings on flat ground at one control period, as good as at the reference.
/// @param reference  the same headings, in the same order
/// @param reach      of the farthest workspace centre from the base [m]
[[nodiscard]] Verdict judge_rate(std::span<const JudgedWalk> headings,
                                 std::span<const JudgedWalk> reference, double reach);

/// Rough ground at one control period.
/// @param least_arrived  walks that must arrive
[[nodiscard]] Verdict judge_rate_on_terrain(std::span<const JudgedWalk> walks, int least_arrived);

}  // namespace hexagait::experiments

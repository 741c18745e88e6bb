// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/model/stance.hpp>

/// Walking on with the legs that are left.
namespace hexagait::footstep_gen {

/// May a robot walk without these legs? At least four are left, two of them on each side; with one on a
/// side nothing holds the centre of mass while it steps.
[[nodiscard]] bool may_walk_without(LegSet lost, int legs) noexcept;

/// Stability margin on the legs that are left when the most of them step at once: least of the margins
/// of the centre of mass over the sets of legs that stay when as many as rule 1 allows lift, or, of four
/// legs, over all that are left.
///
///     min over the largest sets A without neighbours in the ring of  margin(p_M, {c_i : i not in A})   (lost 1)
///
/// @param p_BC  workspace centres [m]
/// @param p_BM  centre of mass [m]
/// @returns [m]
[[nodiscard]] double least_margin(const LegArray<Vector3>& p_BC, const Vector2& p_BM,
                                  LegSet lost) noexcept;

/// The stance recentred: all centres moved alike, so that (lost 1) is greatest, by no more than 0.6 of
/// the smallest workspace radius, and by less where less costs no more than a tenth of it. Discs are
/// what the legs reach about the new centres. Lost legs keep theirs. Takes some 0.1 ms of legs in closed
/// form; does not allocate.
/// @param stance  of all legs
[[nodiscard]] Stance stance_without(LegSet lost, const RobotModel& model, const Stance& stance,
                                    const Vector2& p_BM) noexcept;

}  // namespace hexagait::footstep_gen

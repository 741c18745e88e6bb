// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/action/action.hpp>
#include <hexagait/model/robot_model.hpp>

namespace hexagait::walk {

/// An action that is written for one robot, for another one: with the sizes of both,
/// params_for()'s ℓ and T, and the stances c_i,
///
///     foot      c'_i + ℓ'/ℓ (p − c_i), its height above the ground times ℓ'/ℓ at most h'/h
///     base      ℓ'/ℓ sideways; its height so that the belly is where it was between the ground and
///               the height h of the stance
///     times     T'/T; speeds and accelerations accordingly; forces by the weight
///     joints    those that put the foot at its new place; the same ones on the same robot
///
/// @throws InvalidInput  in one line, if the other robot can't do it: it has another number of legs,
///                       or the action is about a place of the map
[[nodiscard]] action::Action for_robot(action::Action action, const RobotModel& written_for,
                                       const RobotModel& robot);

}  // namespace hexagait::walk

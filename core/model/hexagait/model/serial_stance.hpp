// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/model/workspace.hpp>
#include <hexagait/text/violations.hpp>

namespace hexagait {

/// Lengths of a serial leg with all joints at zero: what workspace.hpp has of coxa, femur, tibia.
struct SerialLengths {
  double coxa = 0.0;     ///< from the first axis to the second [m]
  double upper = 0.0;    ///< from there to the third [m]
  double rest = 0.0;     ///< on from axis to axis, and to the foot's centre [m]
  double lateral = 0.0;  ///< of the foot, along x of the hip frame [m]
};

/// From each axis the shortest way to the next.
[[nodiscard]] SerialLengths serial_lengths(const LegModel& leg);

/// Distances of the foot centre from the hip that a serial leg can have, 4 % of the longest away
/// from those at which, without limits, it would be straight or folded.
///
/// About one joint after the other the distance goes like a + b cos q + c sin q, so that each is
/// turned to its best value; from several postures, until nothing changes.
[[nodiscard]] Reach serial_reach(const LegModel& leg);

/// Gives a serial leg its nominal stance and workspace: reach, p_BC, q_nominal, workspace_radius.
///
/// The foot stands where it would on a yaw-pitch-pitch leg if the first axis is steep: the first
/// two links out, what is left of them and the others /2.2 below the hip. Where the first axis lies
/// flat, as in the legs of mammals: out as far as with all joints at zero, 0.8 of the longest reach
/// below. If the leg doesn't get there well, the nearest place around where it does.
///
/// Of the postures that have the foot there, the one in which the foot can be moved best in all
/// directions, far from joint limits, with knees up, in front of all else towards the robot's
/// middle.
/// @param violations  receives why there is none: a foot that can't be moved in all three
/// directions
void take_serial_stance(LegModel& leg, Violations& violations);

}  // namespace hexagait

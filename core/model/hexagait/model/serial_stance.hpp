// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/model/workspace.hpp>
#include <hexagait/text/violations.hpp>

namespace hexagait {

/// Lengths of a serial leg with all joints at zero, in the roles of coxa, femur and tibia.
struct SerialLengths {
  double coxa = 0.0;     ///< from the first axis to the first one that bends the leg [m]
  double upper = 0.0;    ///< from there to the next joint that is not in the same place [m]
  double rest = 0.0;     ///< from there on, axis to axis and to the foot's centre [m]
  double lateral = 0.0;  ///< of the foot from the hip, along x of the hip frame [m]
};

/// Shortest distances from each joint axis to the next, and along the axes of joints that twist the leg.
///
/// If the first axis is steep, joints whose axes are across the leg bend it, the others twist it: coxa is the
/// way from a yaw axis to the first pitch axis, also where a roll axis is between them. If the first axis is
/// horizontal, every joint but the first counts as one that bends.
[[nodiscard]] SerialLengths serial_lengths(const LegModel& leg);

/// The reach of a serial leg, kSingularMargin inside the distances at which it would be straight or
/// folded without joint limits.
///
/// As a function of one joint, the squared distance of the foot from the hip is
/// a + b cos q + c sin q. Its extrema are found by moving one joint after the other to its best
/// value until nothing changes, from several postures.
[[nodiscard]] Reach serial_reach(const LegModel& leg);

/// Sets the nominal stance and workspace of a serial leg: reach, p_BC, q_nominal, workspace_radius.
///
/// If the first axis is steep, the foot stands where that of a yaw-pitch-pitch leg would: outwards
/// by coxa + upper, and (upper + rest) / kHeightRatio below the hip. If the first axis
/// is horizontal, as in legs of mammals, it stands as far out as with all joints at zero, 0.66 of
/// the longest reach below the hip. If the leg cannot reach that place well, the nearest place
/// around it that it can is taken.
///
/// Of the postures with the foot there, the one with the best dexterity (smallest singular value of
/// the Jacobian) far from joint limits is taken; knees up are preferred, then knees towards the
/// robot's middle.
/// @param violations  receives an entry if no stance lets the foot move in all three directions
void take_serial_stance(LegModel& leg, Violations& violations);

}  // namespace hexagait

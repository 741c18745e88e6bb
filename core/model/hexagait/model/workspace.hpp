// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/model/robot_model.hpp>

namespace hexagait {

/// Distances of the foot centre from the hip-pitch axis, of a serial leg from the hip [m].
struct Reach {
  double min = 0.0;
  double max = 0.0;
};

/// What the knee limits allow with the knee above the line from hip to foot, canonical knee in
/// [0, π]:
///
///     d² = femur² + tibia² + 2 femur tibia cos k₃
///
/// but 4 % of femur + tibia away from the straight and from the folded leg, where the Jacobian is
/// singular.
/// @returns max < min if the limits forbid all of this
[[nodiscard]] Reach leg_reach(const LegModel& leg);

/// Foot centre p_BF of the nominal stance [m]: yaw 0, as far out as coxa + femur,
/// (femur + tibia)/2.2 below the hip-pitch axis: the tibia near the vertical, the knee well bent.
[[nodiscard]] Vector3 nominal_foot(const LegModel& leg);

/// Radius of the largest horizontal disc about the leg's p_BC that it can reach all over [m], at
/// most a third of femur + tibia (of a serial leg: of all behind its second axis): the rest is left
/// for ground that is higher or lower than nominal.
/// @pre p_BC, min_reach and max_reach are set, of a serial leg also q_nominal
[[nodiscard]] double reachable_radius(const LegModel& leg);

}  // namespace hexagait

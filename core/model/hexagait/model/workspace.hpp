// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/model/robot_model.hpp>

namespace hexagait {

/// Distance kept from the straight and from the folded leg, where the Jacobian is singular, as a
/// fraction of the longest reach.
inline constexpr double kSingularMargin = 0.04;

/// Length of femur and tibia over the nominal height of the hip, of a leg that sprawls.
inline constexpr double kHeightRatio = 2.2;

/// Range of the distance of the foot centre from the hip-pitch axis; of a serial leg, from the
/// hip [m].
struct Reach {
  double min = 0.0;
  double max = 0.0;
};

/// The reach that the knee limits allow with the knee above the line from hip to foot (canonical
/// knee in [0, π]), less kSingularMargin at both ends:
///
///     d² = femur² + tibia² + 2 femur tibia cos k₃
///
/// @returns max < min if the limits allow none
[[nodiscard]] Reach leg_reach(const LegModel& leg);

/// Foot centre p_BF of the nominal stance [m]: yaw 0, coxa + femur outwards, and
/// (femur + tibia)/kHeightRatio below the hip-pitch axis. The tibia is then nearly vertical and the
/// knee well bent.
[[nodiscard]] Vector3 nominal_foot(const LegModel& leg);

/// Radius of the largest horizontal disc about p_BC that the foot can reach everywhere [m], at most
/// a third of femur + tibia (of a serial leg: of all links beyond the second axis), so that ground
/// higher or lower than nominal stays within reach.
/// @pre p_BC, min_reach and max_reach are set; of a serial leg also q_nominal
[[nodiscard]] double reachable_radius(const LegModel& leg);

}  // namespace hexagait

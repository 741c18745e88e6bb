// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/math/trigonometry.hpp>
#include <hexagait/model/leg_solution.hpp>

/// What legs of a yaw and one pitch, or two, have in common; canonical angles k as in LegModel.
namespace hexagait::detail {

[[nodiscard]] inline double canonical(const LegModel& leg, int joint, double q) noexcept {
  return leg.joint_sign[joint] * q + leg.joint_offset[joint];
}

/// The joint value of the canonical angle k, modulo 2π nearest to the middle of the limits.
[[nodiscard]] inline double joint_value(const LegModel& leg, int joint, double k) noexcept {
  const JointLimits& limits = leg.limits[joint];
  const double q = leg.joint_sign[joint] * (k - leg.joint_offset[joint]);
  if (within(limits, q)) return q;
  const double middle = 0.5 * (limits.lower + limits.upper);
  return middle + wrap_angle(q - middle);
}

/// 2 atan u, for each entry of u. For |u| ≤ YawPitchPitchLeg::kLittle, the rest of the series is below
/// 3e-18 u.
template <class Numbers>
[[nodiscard]] Numbers twice_atan(const Numbers& u) noexcept {
  constexpr double k3 = -1.0 / 3, k5 = 1.0 / 5, k7 = -1.0 / 7, k9 = 1.0 / 9, k11 = -1.0 / 11;
  constexpr double k13 = 1.0 / 13, k15 = -1.0 / 15, k17 = 1.0 / 17;
  const Numbers z = u * u;
  const Numbers tail =
      z * (k3 + z * (k5 + z * (k7 + z * (k9 + z * (k11 + z * (k13 + z * (k15 + z * k17)))))));
  return 2.0 * (u + u * tail);
}

/// R_BT of the last link's frame T: x to the foot, y along the canonical pitch axis.
/// @param yaw, pitch  of the last link
[[nodiscard]] inline Matrix3 last_link_rotation(const LegModel& leg, const portable::SinCos& yaw,
                                                const portable::SinCos& pitch) noexcept {
  Matrix3 R_HT;
  R_HT << yaw.c * pitch.c, -yaw.s, yaw.c * pitch.s,  //
      yaw.s * pitch.c, yaw.c, yaw.s * pitch.s,       //
      -pitch.s, 0.0, pitch.c;
  return leg.X_BH.R * R_HT;
}

/// How the last link turns while the canonical yaw and its pitch grow by so much together.
[[nodiscard]] inline Vector3 last_link_turn(const LegModel& leg, const portable::SinCos& yaw,
                                            double by_yaw, double by_pitch) noexcept {
  // The pitch axis at half the yaw: the joints move together.
  const double half = 0.5 * by_yaw;
  const Vector3 pitch_axis_H(-yaw.s - half * yaw.c, yaw.c - half * yaw.s, 0.0);
  return leg.X_BH.R * (by_yaw * Vector3::UnitZ() + by_pitch * pitch_axis_H);
}

}  // namespace hexagait::detail

// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/model/robot_model.hpp>
#include <limits>
#include <optional>

namespace hexagait {

/// The path of a swing foot from its start s to its target t, as a polygon. With u along the chord
/// (from s to t, perpendicular to the normal), n along the normal, both measured from s,
/// b = max(0, t.n) and h the profile height, its corners are
///
///     straight   s, t
///     triangle   s, (½ t.u, b + h), t
///     square     s, (0, b + h), (t.u, b + h), t
///     trapezoid  s, (0.1 t.u, h), (½ t.u, t.n + h), (0.9 t.u, t.n + h), t
enum class SwingProfile : std::uint8_t { straight, triangle, square, trapezoid };

/// A point on the path of a foot.
struct FootKnot {
  double time = 0.0;            ///< since the start of the motion [s]
  Vector3 p = Vector3::Zero();  ///< [m]
  std::optional<Vector3> v;     ///< [m/s]; without one, chosen for a smooth curve
};

/// Joint values on the path of a leg. Values that are not given are NaN.
struct JointKnot {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  double time = 0.0;                              ///< since the start of the motion [s]
  LegJoints q = LegJoints::Constant(kNone);       ///< [rad]
  LegJoints qd = LegJoints::Constant(kNone);      ///< [rad/s]
  LegJoints qdd = LegJoints::Constant(kNone);     ///< [rad/s²]
  LegJoints effort = LegJoints::Constant(kNone);  ///< [N m]
};

/// A pose on the path of the base.
struct BaseKnot {
  double time = 0.0;  ///< since the start of the motion [s]
  Pose X_AB;
};

}  // namespace hexagait

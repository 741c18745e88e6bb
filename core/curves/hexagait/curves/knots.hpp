// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/model/robot_model.hpp>
#include <limits>
#include <optional>

namespace hexagait {

/// The way of a swinging foot between its start s and its target t, as a polygon. u is along the
/// chord (from s to t, perpendicular to the normal), n along the normal, both from s; b = max(0,
/// t.n), h the profile height:
///
///     straight   s, t
///     triangle   s, (½ t.u, b + h), t
///     square     s, (0, b + h), (t.u, b + h), t
///     trapezoid  s, (0.1 t.u, h), (½ t.u, t.n + h), (0.9 t.u, t.n + h), t
enum class SwingProfile : std::uint8_t { straight, triangle, square, trapezoid };

/// A point that a foot passes.
struct FootKnot {
  double time = 0.0;            ///< since the motion began [s]
  Vector3 p = Vector3::Zero();  ///< [m]
  std::optional<Vector3> v;     ///< [m/s]; none: chosen so that the curve is smooth
};

/// Joint values that a leg passes. What is not given is NaN.
struct JointKnot {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  double time = 0.0;                              ///< since the motion began [s]
  LegJoints q = LegJoints::Constant(kNone);       ///< [rad]
  LegJoints qd = LegJoints::Constant(kNone);      ///< [rad/s]
  LegJoints qdd = LegJoints::Constant(kNone);     ///< [rad/s²]
  LegJoints effort = LegJoints::Constant(kNone);  ///< [N m]
};

/// A pose that the base passes.
struct BaseKnot {
  double time = 0.0;  ///< since the motion began [s]
  Pose X_AB;
};

}  // namespace hexagait

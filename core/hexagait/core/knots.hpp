// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/core/robot_model.hpp>
#include <limits>
#include <optional>

namespace hexagait {

/// Shape of a swing, from start s to target t with height h above the higher of the two, along the
/// surface normal: through
///   straight   s, t
///   triangle   s, middle + h, t
///   square     s, s + h, t + h, t
///   trapezoid  s, 10 % of the way at s + h, middle at t + h, 90 % at t + h, t
enum class SwingProfile : std::uint8_t { straight, triangle, square, trapezoid };

/// A point that a foot passes.
struct FootKnot {
  double time = 0.0;           ///< since the motion began [s]
  Vector3 p = Vector3::Zero(); ///< [m]
  std::optional<Vector3> v;    ///< [m/s]; none: chosen so that the curve is smooth
};

/// Joint values that a leg passes. What is not given is NaN.
struct JointKnot {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  double time = 0.0;                                   ///< since the motion began [s]
  LegJoints q = LegJoints::Constant(kNone);            ///< [rad]
  LegJoints qd = LegJoints::Constant(kNone);           ///< [rad/s]
  LegJoints qdd = LegJoints::Constant(kNone);          ///< [rad/s²]
  LegJoints effort = LegJoints::Constant(kNone);       ///< [N m]
};

/// A pose that the base passes.
struct BaseKnot {
  double time = 0.0;  ///< since the motion began [s]
  Pose X_AB;
};

}  // namespace hexagait
